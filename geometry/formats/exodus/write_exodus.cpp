// Exodus II files, in netCDF's 64-bit classic format. A block for each group of faces, sets of
// elements for groups that overlap, and for each group of edges a set of sides and one of nodes.
#include <exodusII.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "geometry/formats/element_vertices.h"
#include "geometry/formats/format_names.h"
#include "geometry/formats/writer_module.h"

namespace af2::geometry {
namespace {

constexpr NameLimits kExodusNames{MAX_STR_LENGTH, false};

constexpr int kFront = 1, kFirstEdge = 3;  // sides of elements in space; 2 is the back

void check(int code, const char* doing) {
  if (code < 0) throw InputError(std::string("libexodusii reports an error: ") + doing);
}

class ExodusWriter {
 public:
  ExodusWriter(const GroupedMesh& grouped, const char* path)
      : grouped_(grouped), mesh_(grouped.mesh) {
    ex_opts(0);  // errors are told once, below
    int wordSize = sizeof(double), fileWordSize = sizeof(double);
    file_ = ex_create(path, EX_CLOBBER | EX_LARGE_MODEL, &wordSize, &fileWordSize);
    check(file_, "making the file");
    std::set<std::int32_t> inBlocks;
    for (const ElementBlock& block : grouped.blocks) inBlocks.insert(block.group);
    for (const GroupMembers& group : grouped.groups) {
      const bool isOfLines = group.group.dimension == PhysicalGroup::kCurve;
      if (isOfLines) highestCurve_ = group.group.number;
      if (isOfLines || !inBlocks.contains(group.group.number))
        (isOfLines ? ofLines_ : ofElements_).push_back(&group);
    }
    for (const ElementBlock& block : grouped.blocks)
      for (const std::uint32_t e : block.elements) order_.push_back(e);
    placeOf_.resize(mesh_.elements.size());
    for (std::size_t i = 0; i < order_.size(); ++i) placeOf_[order_[i]] = static_cast<int>(i) + 1;
  }
  ExodusWriter(const ExodusWriter&) = delete;
  ExodusWriter& operator=(const ExodusWriter&) = delete;
  ~ExodusWriter() {
    if (file_ >= 0) ex_close(file_);
  }

  void write() {
    putCounts();
    putVertices();
    for (const ElementBlock& block : grouped_.blocks) putBlock(block);
    putNumbers();
    FormatNames setNames(kExodusNames), sideNames(kExodusNames), nodeNames(kExodusNames);
    for (const GroupMembers* group : ofElements_) {
      std::vector<int> places;
      for (const std::uint32_t e : group->members) places.push_back(placeOf_[e]);
      std::ranges::sort(places);
      putSet(EX_ELEM_SET, group->group.number, places, nullptr, setNames.add(group->name));
      const std::vector<int> fronts(places.size(), kFront);
      putSet(EX_SIDE_SET, highestCurve_ + group->group.number, places, fronts.data(),
             sideNames.add(group->name));
    }
    for (const GroupMembers* group : ofLines_) {
      putSides(*group, sideNames.add(group->name));
      putNodes(*group, nodeNames.add(group->name));
    }
    const int file = file_;
    file_ = -1;
    check(ex_close(file), "closing the file");
  }

 private:
  void putCounts() {
    ex_init_params counts{};
    std::strcpy(counts.title, "surface mesh by AF2");
    counts.num_dim = 3;
    counts.num_nodes = static_cast<std::int64_t>(mesh_.vertices.size());
    counts.num_elem = static_cast<std::int64_t>(mesh_.elements.size());
    counts.num_elem_blk = static_cast<std::int64_t>(grouped_.blocks.size());
    counts.num_elem_sets = static_cast<std::int64_t>(ofElements_.size());
    counts.num_node_sets = static_cast<std::int64_t>(ofLines_.size());
    counts.num_side_sets = counts.num_elem_sets + counts.num_node_sets;
    check(ex_put_init_ext(file_, &counts), "writing the counts");
  }

  void putVertices() {
    std::vector<double> x, y, z;
    for (const Point3& p : mesh_.vertices) {
      x.push_back(p.x);
      y.push_back(p.y);
      z.push_back(p.z);
    }
    if (!x.empty())
      check(ex_put_coord(file_, x.data(), y.data(), z.data()), "writing the vertices");
    char names[3][2] = {"x", "y", "z"};
    char* list[] = {names[0], names[1], names[2]};
    check(ex_put_coord_names(file_, list), "writing the names of coordinates");
  }

  /// A group of triangles and quadrilaterals is two blocks.
  void putBlock(const ElementBlock& block) {
    const int vertices = (block.isQuad ? 4 : 3) * (mesh_.midsides.empty() ? 1 : 2);
    const std::string type = (block.isQuad ? "SHELL" : "TRI") + std::to_string(vertices);
    const auto* const group = std::ranges::find(
        grouped_.groups.data(), grouped_.groups.data() + grouped_.groups.size(),
        PhysicalGroup{PhysicalGroup::kSurface, block.group}, &GroupMembers::group);
    std::int64_t id = block.group;
    if (!blockIds_.insert(id).second) id += grouped_.groups.back().group.number;
    blockIds_.insert(id);
    std::vector<int> corners;
    for (const std::uint32_t e : block.elements)
      for (const VertexId v : mshVertices(mesh_, e))
        corners.push_back(static_cast<int>(v.value) + 1);
    check(ex_put_block(file_, EX_ELEM_BLOCK, id, type.c_str(),
                       static_cast<std::int64_t>(block.elements.size()), vertices, 0, 0, 0),
          "making a block");
    check(ex_put_conn(file_, EX_ELEM_BLOCK, id, corners.data(), nullptr, nullptr),
          "writing a block");
    check(ex_put_name(file_, EX_ELEM_BLOCK, id, blockNames_.add(group->name).c_str()),
          "naming a block");
  }

  /// The numbers of the elements in other formats.
  void putNumbers() {
    std::vector<int> numbers;
    for (const std::uint32_t e : order_) numbers.push_back(static_cast<int>(e) + 1);
    if (!numbers.empty())
      check(ex_put_id_map(file_, EX_ELEM_MAP, numbers.data()), "writing numbers of elements");
  }

  void putSides(const GroupMembers& group, const std::string& name) {
    std::vector<int> places, sides;
    for (const std::uint32_t line : group.members) {
      places.push_back(placeOf_[grouped_.sides[line].element]);
      sides.push_back(static_cast<int>(grouped_.sides[line].side) + kFirstEdge);
    }
    putSet(EX_SIDE_SET, group.group.number, places, sides.data(), name);
  }

  void putNodes(const GroupMembers& group, const std::string& name) {
    std::set<int> nodes;
    for (const std::uint32_t line : group.members)
      for (const VertexId v : mshVertices(grouped_.lines[line]))
        nodes.insert(static_cast<int>(v.value) + 1);
    putSet(EX_NODE_SET, group.group.number, {nodes.begin(), nodes.end()}, nullptr, name);
  }

  void putSet(ex_entity_type type, std::int64_t id, const std::vector<int>& members,
              const int* sides, const std::string& name) {
    check(ex_put_set_param(file_, type, id, static_cast<std::int64_t>(members.size()), 0),
          "making a set");
    check(ex_put_set(file_, type, id, members.data(), sides), "writing a set");
    check(ex_put_name(file_, type, id, name.c_str()), "naming a set");
  }

  const GroupedMesh& grouped_;
  const ModelMesh& mesh_;
  int file_ = -1;
  std::vector<const GroupMembers*> ofElements_, ofLines_;  ///< groups that become sets
  std::vector<std::uint32_t> order_;                       ///< of the elements in the file
  std::vector<int> placeOf_;                               ///< in the file, counted from 1
  std::int32_t highestCurve_ = 0;
  std::set<std::int64_t> blockIds_;
  FormatNames blockNames_{kExodusNames};
};

}  // namespace

void writeExodusFile(const GroupedMesh& mesh, const char* path) {
  ExodusWriter(mesh, path).write();
}

}  // namespace af2::geometry
