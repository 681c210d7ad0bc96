// Nastran's bulk data, text: shell elements with a property for each group of faces; sets for
// groups that overlap, and for those of edges. Lines are PLOTEL elements, which have no stiffness.
#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
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

/// Lines of fields, which are filled with spaces but for the last one.
class FieldLines {
 public:
  explicit FieldLines(OutputFile& file) : file_(file) {}

  void text(std::string_view text, std::size_t columns = kSmallField) {
    for (; spaces_ > 0; --spaces_) file_.bytes(" ", 1);
    file_.text(text);
    spaces_ = columns - std::min(columns, text.size());
  }
  void number(std::size_t number, std::size_t columns = kSmallField) {
    char digits[20];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    text({digits, end}, columns);
  }
  void end() {
    file_.text("\n");
    spaces_ = 0;
  }

 private:
  OutputFile& file_;
  std::size_t spaces_ = 0;  ///< before the next field
};

/// Small fields; what does not fit into a line follows on others.
void putEntry(std::string_view name, std::span<const std::size_t> numbers, OutputFile& file) {
  constexpr std::size_t kFieldsInLine = 8;
  FieldLines lines(file);
  lines.text(name);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && i % kFieldsInLine == 0) {
      lines.text("+");
      lines.end();
      lines.text("+");
    }
    lines.number(numbers[i]);
  }
  lines.end();
}

/// Coordinates in large fields.
void putGrid(std::size_t number, const Point3& p, OutputFile& file) {
  FieldLines lines(file);
  lines.text("GRID*");
  lines.number(number, 2 * kLargeField);
  for (const double x : {p.x, p.y}) lines.text(nastranNumber(x, kLargeField), kLargeField);
  lines.end();
  lines.text("*");
  lines.text(nastranNumber(p.z, kLargeField), kLargeField);
  lines.end();
}

std::string_view nastranEntry(const ModelMesh& mesh, bool isQuad) {
  if (mesh.midsides.empty()) return isQuad ? "CQUAD4" : "CTRIA3";
  return isQuad ? "CQUAD8" : "CTRIA6";
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
      const std::array numbers{static_cast<std::size_t>(group.group.number)};
      putEntry("PSHELL", numbers, file);
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
  std::vector<std::size_t> numbers;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    numbers = {e + 1, groups.propertyOf(e)};
    for (const VertexId vertex : mshVertices(mesh, e))
      numbers.push_back(std::size_t{vertex.value} + 1);
    putEntry(nastranEntry(mesh, mesh.elements[e].isQuad()), numbers, file);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    numbers = {mesh.elements.size() + i + 1, std::size_t{lines[i].from.value} + 1,
               std::size_t{lines[i].to.value} + 1};
    putEntry("PLOTEL", numbers, file);
  }
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
