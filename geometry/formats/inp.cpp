// Abaqus's input, as CalculiX reads it, too: text. Shell elements; each group of faces is a set of
// elements and one of nodes, each group of edges a set of nodes and one of elements for each side.
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/formats/column_numbers.h"
#include "geometry/formats/element_vertices.h"
#include "geometry/formats/format_names.h"
#include "geometry/formats/group_members.h"
#include "geometry/io/formats.h"

namespace af2::geometry {
namespace {

constexpr std::size_t kNumberColumns = 20;  // CalculiX ignores what follows
constexpr NameLimits kInpNames{60, true};   // 80, with what follows
constexpr const char* kAllElements = "all_elements";
constexpr const char* kAllNodes = "all_nodes";

/// Numbers, sixteen in a line at most.
class InpList {
 public:
  explicit InpList(OutputFile& file) : file_(file) {}

  void add(std::size_t number) {
    constexpr int kMostInLine = 16;
    if (inLine_ > 0) file_.text(inLine_ == kMostInLine ? ",\n" : ", ");
    inLine_ = inLine_ == kMostInLine ? 1 : inLine_ + 1;
    file_.number(number);
  }
  void end() { file_.text("\n"); }

 private:
  OutputFile& file_;
  int inLine_ = 0;
};

void putInpNodes(const ModelMesh& mesh, OutputFile& file) {
  const std::vector<bool> isUsed = usedVertices(mesh);
  file.text(std::string("*NODE, NSET=") + kAllNodes + "\n");
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!isUsed[v]) continue;
    file.number(v + 1);
    for (const double x : {mesh.vertices[v].x, mesh.vertices[v].y, mesh.vertices[v].z})
      file.text(", " + numberInColumns(x, kNumberColumns));
    file.text("\n");
  }
}

/// Those that both programs have; of second order, CalculiX has S6 and Abaqus STRI65.
const char* inpType(const ModelMesh& mesh, bool isQuad) {
  if (mesh.midsides.empty()) return isQuad ? "S4" : "S3";
  return isQuad ? "S8R" : "S6";
}

void putInpElements(const ModelMesh& mesh, const std::vector<ElementBlock>& blocks,
                    const std::map<PhysicalGroup, std::string>& names, OutputFile& file) {
  for (const ElementBlock& block : blocks) {
    file.text(std::string("*ELEMENT, TYPE=") + inpType(mesh, block.isQuad) +
              ", ELSET=" + names.at({PhysicalGroup::kSurface, block.group}) + "\n");
    for (const std::uint32_t e : block.elements) {
      file.number(e + 1u);
      for (const VertexId vertex : mshVertices(mesh, e)) {
        file.text(", ");
        file.number(std::size_t{vertex.value} + 1);
      }
      file.text("\n");
    }
  }
}

/// The set of all elements, made of those of the blocks.
void putAllElements(const std::set<std::int32_t>& firstGroups,
                    const std::map<PhysicalGroup, std::string>& names, OutputFile& file) {
  if (firstGroups.empty()) return;
  file.text(std::string("*ELSET, ELSET=") + kAllElements + "\n");
  for (const std::int32_t group : firstGroups)
    file.text(names.at({PhysicalGroup::kSurface, group}) + ",\n");
}

void putNodeSet(const std::string& name, const std::vector<VertexId>& vertices, OutputFile& file) {
  file.text("*NSET, NSET=" + name + "\n");
  InpList list(file);
  for (const VertexId vertex : vertices) list.add(std::size_t{vertex.value} + 1);
  list.end();
}

void putElementSet(const std::string& name, const std::vector<std::uint32_t>& elements,
                   OutputFile& file) {
  file.text("*ELSET, ELSET=" + name + "\n");
  InpList list(file);
  for (const std::uint32_t element : elements) list.add(element + 1u);
  list.end();
}

/// For loads on edges: the elements of which side 1 is in the group, those of which side 2 is, ...
void putSideSets(const GroupMembers& group, const std::string& name,
                 const std::vector<ElementSide>& sides, FormatNames& names, OutputFile& file) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> elements;
  for (const std::uint32_t line : group.members)
    elements[sides[line].side].push_back(sides[line].element);
  for (const auto& [side, own] : elements)
    putElementSet(names.add(name + "_side" + std::to_string(side + 1)), own, file);
}

}  // namespace

void writeInp(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  const MshGroups groups(mesh, extras, {});
  const std::vector<GroupMembers> members = groupMembers(mesh, extras.lines, groups);
  FormatNames names(kInpNames);
  for (const char* reserved : {kAllElements, kAllNodes}) names.add(reserved);
  std::map<PhysicalGroup, std::string> nameOf;
  for (const GroupMembers& group : members) nameOf[group.group] = names.add(group.name);

  file.text("*HEADING\nsurface mesh by AF2\n");
  putInpNodes(mesh, file);
  const std::vector<ElementBlock> blocks = elementBlocks(mesh, groups);
  std::set<std::int32_t> inBlocks;
  for (const ElementBlock& block : blocks) inBlocks.insert(block.group);
  putInpElements(mesh, blocks, nameOf, file);
  putAllElements(inBlocks, nameOf, file);
  const std::vector<ElementSide> sides = sidesOnLines(mesh, extras.lines);
  for (const GroupMembers& group : members) {
    const std::string& name = nameOf.at(group.group);
    putNodeSet(name, verticesOf(mesh, extras.lines, group), file);
    if (group.group.dimension == PhysicalGroup::kCurve)
      putSideSets(group, name, sides, names, file);
    else if (!inBlocks.contains(group.group.number))
      putElementSet(name, group.members, file);
  }
}

}  // namespace af2::geometry
