// Nastran's bulk data, text: shell elements with a property for each group of faces; sets for
// groups that overlap, and for those of edges. Lines are PLOTEL elements, which have no stiffness.
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "geometry/formats/column_numbers.h"
#include "geometry/formats/element_vertices.h"
#include "geometry/formats/group_members.h"
#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

constexpr std::size_t kSmallField = 8, kLargeField = 16;
constexpr std::size_t kHighestNumber = 99'999'999;  // that fits into a small field

std::string padded(std::string text, std::size_t columns) {
  if (text.size() < columns) text.append(columns - text.size(), ' ');
  return text;
}

/// A line of small fields; what does not fit follows on others.
void putEntry(const std::string& name, const std::vector<std::size_t>& numbers, OutputFile& file) {
  constexpr std::size_t kFieldsInLine = 8;
  std::string line = padded(name, kSmallField);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && i % kFieldsInLine == 0) line += "+\n" + padded("+", kSmallField);
    line += padded(std::to_string(numbers[i]), kSmallField);
  }
  while (line.ends_with(' ')) line.pop_back();
  file.text(line + "\n");
}

/// Coordinates in large fields.
void putGrid(std::size_t number, const Point3& p, OutputFile& file) {
  const auto field = [](double x) { return padded(nastranNumber(x, kLargeField), kLargeField); };
  file.text(padded("GRID*", kSmallField) + padded(std::to_string(number), 2 * kLargeField) +
            field(p.x) + field(p.y) + "\n" + padded("*", kSmallField) +
            nastranNumber(p.z, kLargeField) + "\n");
}

/// CTRIA3, CQUAD4, CTRIA6 or CQUAD8.
std::string nastranEntry(const ModelMesh& mesh, bool isQuad) {
  const int vertices = (isQuad ? 4 : 3) * (mesh.midsides.empty() ? 1 : 2);
  return (isQuad ? "CQUAD" : "CTRIA") + std::to_string(vertices);
}

/// A comment ends with its line, and old programs read bytes of ASCII only.
std::string inComment(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '_';
  return name;
}

/// A set of the case control section, in lines of at most 72 columns.
void putCaseSet(std::size_t number, const std::string& what,
                const std::vector<std::size_t>& members, OutputFile& file) {
  constexpr std::size_t kLongestLine = 70;
  file.text("$ SET " + std::to_string(number) + ": " + inComment(what) + "\n");
  std::string line = "SET " + std::to_string(number) + " = ";
  for (std::size_t i = 0; i < members.size();) {
    std::size_t last = i;
    while (last + 1 < members.size() && members[last + 1] == members[last] + 1) ++last;
    if (last - i < 2) last = i;
    std::string part = std::to_string(members[i]);
    if (last > i) part += " THRU " + std::to_string(members[last]);
    i = last + 1;
    if (i < members.size()) part += ',';
    if (line.size() + part.size() > kLongestLine) {
      file.text(line + "\n");
      line = "  ";
    }
    line += part;
  }
  file.text(line + "\n");
}

void refuseTooMany(const ModelMesh& mesh, Lines lines) {
  if (std::max(mesh.vertices.size(), mesh.elements.size() + lines.size()) > kHighestNumber)
    throw InputError("cannot write a Nastran file: its numbers end at 99999999; use a larger size");
}

/// Everything that is told of groups: sets before the bulk data, properties in it.
class NastranGroups {
 public:
  NastranGroups(const ModelMesh& mesh, const Extras& extras)
      : mesh_(mesh),
        lines_(extras.lines),
        groups_(mesh, extras, {}),
        firstGroup_(firstGroups(mesh, groups_)),
        properties_(firstGroup_.begin(), firstGroup_.end()),
        members_(groupMembers(mesh, lines_, groups_)) {}

  std::size_t propertyOf(std::size_t element) const {
    return static_cast<std::size_t>(firstGroup_[element]);
  }

  /// A group that is a property needs no set of elements.
  void putSets(OutputFile& file) const {
    std::size_t number = 0;
    for (const GroupMembers& group : members_) {
      const bool isOfLines = group.group.dimension == PhysicalGroup::kCurve;
      const std::size_t before = isOfLines ? mesh_.elements.size() : 0;
      std::vector<std::size_t> numbers;
      for (const std::uint32_t member : group.members) numbers.push_back(before + member + 1);
      if (isOfLines || !properties_.contains(group.group.number))
        putCaseSet(++number, "elements of " + group.name, numbers, file);
      numbers.clear();
      for (const VertexId vertex : verticesOf(mesh_, lines_, group))
        numbers.push_back(std::size_t{vertex.value} + 1);
      putCaseSet(++number, "grid points of " + group.name, numbers, file);
    }
  }

  /// Without material and thickness, which are not known.
  void putProperties(OutputFile& file) const {
    for (const GroupMembers& group : members_) {
      if (group.group.dimension == PhysicalGroup::kCurve ||
          !properties_.contains(group.group.number))
        continue;
      file.text("$ PSHELL " + std::to_string(group.group.number) + ": " + inComment(group.name) +
                "\n");
      putEntry("PSHELL", {static_cast<std::size_t>(group.group.number)}, file);
    }
  }

 private:
  const ModelMesh& mesh_;
  Lines lines_;
  MshGroups groups_;
  std::vector<std::int32_t> firstGroup_;
  std::set<std::int32_t> properties_;
  std::vector<GroupMembers> members_;
};

void putBulkElements(const ModelMesh& mesh, Lines lines, const NastranGroups& groups,
                     OutputFile& file) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    std::vector<std::size_t> numbers{e + 1, groups.propertyOf(e)};
    for (const VertexId vertex : mshVertices(mesh, e))
      numbers.push_back(std::size_t{vertex.value} + 1);
    putEntry(nastranEntry(mesh, mesh.elements[e].isQuad()), numbers, file);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    putEntry("PLOTEL",
             {mesh.elements.size() + i + 1, std::size_t{lines[i].from.value} + 1,
              std::size_t{lines[i].to.value} + 1},
             file);
}

}  // namespace

void writeNastran(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  refuseTooMany(mesh, extras.lines);
  const NastranGroups groups(mesh, extras);
  file.text("$ surface mesh by AF2\nCEND\n");
  groups.putSets(file);
  file.text("BEGIN BULK\n");
  groups.putProperties(file);
  const std::vector<bool> isUsed = usedVertices(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (isUsed[v]) putGrid(v + 1, mesh.vertices[v], file);
  putBulkElements(mesh, extras.lines, groups, file);
  file.text("ENDDATA\n");
}

}  // namespace af2::geometry
