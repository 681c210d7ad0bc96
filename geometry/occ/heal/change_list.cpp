#include "geometry/occ/heal/change_list.h"

#include <BRep_Tool.hxx>
#include <Message_Msg.hxx>
#include <ShapeExtend_DataMapOfShapeListOfMsg.hxx>
#include <TCollection_AsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cctype>
#include <tuple>

#include "geometry/occ/base/points.h"

namespace af2::geometry {
namespace {

bool isBefore(const std::optional<Point3>& a, const std::optional<Point3>& b) {
  if (!a || !b) return a.has_value();
  return std::tuple(a->x, a->y, a->z) < std::tuple(b->x, b->y, b->z);
}

std::string wordsOf(const Message_Msg& message) {
  std::string words = TCollection_AsciiString(message.Original()).ToCString();
  for (auto at = words.find(" %"); at != std::string::npos; at = words.find(" %"))
    words.erase(at, 3);
  while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back()))) words.pop_back();
  if (!words.empty())
    words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return words;
}

/// Some messages only report what could not be done.
bool isChange(const std::string& words) {
  return !words.empty() && words.find("annot") == std::string::npos &&
         words.find("not corrected") == std::string::npos &&
         words.find("mpossible") == std::string::npos;
}

}  // namespace

std::optional<Point3> placeOf(const TopoDS_Shape& shape) {
  const TopExp_Explorer vertex(shape, TopAbs_VERTEX);
  if (!vertex.More()) return std::nullopt;
  return toPoint(BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())));
}

void ChangeList::add(const std::string& what, const std::optional<Point3>& place,
                     std::size_t count) {
  const auto [entry, isNew] = changes_.try_emplace(what, HealedChange{what, 0, place});
  // Those who report come in no particular order.
  if (!isNew && isBefore(place, entry->second.place)) entry->second.place = place;
  entry->second.count += count;
}

void ChangeList::add(const Handle(ShapeExtend_MsgRegistrator) & messages) {
  for (ShapeExtend_DataMapOfShapeListOfMsg::Iterator it(messages->MapShape()); it.More(); it.Next())
    for (const Message_Msg& message : it.Value())
      if (const std::string what = wordsOf(message); isChange(what)) add(what, placeOf(it.Key()));
}

std::vector<HealedChange> ChangeList::take() const {
  std::vector<HealedChange> all;
  for (const auto& [what, change] : changes_) all.push_back(change);
  return all;
}

}  // namespace af2::geometry
