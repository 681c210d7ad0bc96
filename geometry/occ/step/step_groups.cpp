#include "geometry/occ/step/step_groups.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <array>

namespace af2::geometry {
namespace {

/// Systems write what kind of shape it is, or the number of an entity, for what has no name.
bool isMadeUp(const std::string& name) {
  constexpr std::array kKinds{"COMPOUND", "COMPSOLID", "SOLID",  "SHELL",    "FACE",
                              "WIRE",     "EDGE",      "VERTEX", "ASSEMBLY", "NONE"};
  return name.empty() || name.starts_with("=>") ||
         std::find(kKinds.begin(), kKinds.end(), name) != kKinds.end() || name[0] == '#';
}

class Collector {
 public:
  explicit Collector(const StepParts& parts) : parts_(parts) {}

  std::vector<ShapeGroup> collect(const std::vector<PlacedStepPart>& tops) {
    for (const PlacedStepPart& top : tops) {
      walk(parts_[top.part], top.place);
      addColors(top);
    }
    return std::move(groups_);
  }

 private:
  ShapeGroup& group(GroupKind kind, const std::string& name) {
    for (ShapeGroup& group : groups_)
      if (group.kind == kind && group.name == name) return group;
    groups_.push_back({name, kind, {}});
    return groups_.back();
  }

  void walk(const StepPart& part, const TopLoc_Location& place) {
    add(part, place);
    for (const StepInstance& instance : part.instances) {
      add(instance, place);
      walk(parts_[instance.part], place * instance.shape.Location());
    }
    for (const StepItem& piece : part.pieces) add(piece, place);
  }

  void add(const StepItem& item, const TopLoc_Location& place) {
    const TopoDS_Shape placed = item.shape.Moved(place);
    if (!isMadeUp(item.name)) group(GroupKind::Part, item.name).shapes.push_back(placed);
    for (const std::string& layer : item.layers)
      group(GroupKind::Layer, layer).shapes.push_back(placed);
  }

  /// Each face has the colour of the smallest part that has one; that of an instance comes before
  /// that of its part.
  void addColors(const PlacedStepPart& top) {
    colored_.Clear();
    colors_.clear();
    takeColors(parts_[top.part], top.place, "");
    TopTools_IndexedMapOfShape faces;
    std::vector<std::string> colorOf;
    for (int type = TopAbs_COMPOUND; type <= TopAbs_FACE; ++type)
      for (int i = 1; i <= colored_.Extent(); ++i) {
        if (colored_(i).ShapeType() != type) continue;
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(colored_(i), TopAbs_FACE, own);
        for (int k = 1; k <= own.Extent(); ++k) {
          const auto index = static_cast<std::size_t>(faces.Add(own(k)));
          colorOf.resize(static_cast<std::size_t>(faces.Extent()));
          colorOf[index - 1] = colors_[static_cast<std::size_t>(i) - 1];
        }
      }
    for (int i = 1; i <= faces.Extent(); ++i)
      group(GroupKind::Color, colorOf[static_cast<std::size_t>(i) - 1]).shapes.push_back(faces(i));
  }

  /// inherited  of the assembly around the part
  void takeColors(const StepPart& part, const TopLoc_Location& place,
                  const std::string& inherited) {
    const std::string& own = part.color.empty() ? inherited : part.color;
    for (const StepInstance& instance : part.instances) {
      takeColors(parts_[instance.part], place * instance.shape.Location(), own);
      takeColor(instance.shape.Moved(place), instance.color);
    }
    for (const StepItem& piece : part.pieces) takeColor(piece.shape.Moved(place), piece.color);
    takeColor(part.shape.Moved(place), own);
  }

  void takeColor(const TopoDS_Shape& shape, const std::string& color) {
    if (color.empty()) return;
    const auto index = static_cast<std::size_t>(colored_.Add(shape));
    colors_.resize(static_cast<std::size_t>(colored_.Extent()));
    colors_[index - 1] = color;
  }

  const StepParts& parts_;
  std::vector<ShapeGroup> groups_;
  TopTools_IndexedMapOfShape colored_;
  std::vector<std::string> colors_;  ///< of these
};

}  // namespace

std::vector<ShapeGroup> groupsOf(const StepDocument& document) {
  return Collector(document.parts()).collect(document.tops());
}

}  // namespace af2::geometry
