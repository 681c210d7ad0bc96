// Parts of meshes in Gmsh's format, version 4.1, binary, as Gmsh itself writes them: each process
// has entities of its own, whose parents are the faces and edges of the model, and an entity for
// its ghosts.
#include <algorithm>
#include <limits>
#include <map>

#include "engine/base/error.h"
#include "geometry/base/box_tree.h"
#include "geometry/mpi/partition/part_files.h"

namespace af2::mpi {

namespace {

using namespace geometry;

constexpr std::int32_t kCurve = 1, kSurface = 2;
constexpr std::int32_t kLine = 1, kTriangle = 2, kQuad = 3, kLine2 = 8, kTriangle2 = 9, kQuad2 = 16;
constexpr int kGhosts = 0;  ///< parent of the entity of ghosts

/// What lies on one face or edge of the model, or all ghosts.
struct PartEntity {
  std::int32_t dimension = kSurface, parent = kGhosts, tag = 0;
  std::vector<std::int32_t> groups;
  Box3 box;
  std::vector<std::size_t> vertices;  ///< those that no earlier entity has
  std::vector<std::size_t> lines, triangles, quads;
};

class PartMsh {
 public:
  PartMsh(const OwnedPart& part, OutputFile& file) : part_(part), file_(file) {
    findEntities();
    placeVertices();
  }

  void write() {
    file_.text("$MeshFormat\n4.1 1 8\n");
    file_.binary(std::int32_t{1});  // tells readers the order of bytes
    file_.text("\n$EndMeshFormat\n");
    writeNames();
    writeParents();
    writeEntities();
    writeNodes();
    writeElements();
    writeGhosts();
  }

 private:
  std::int32_t partition() const { return part_.process + 1; }

  /// Unique among all processes, after the tags of the model.
  std::int32_t tagOf(const std::vector<PartLabels::Entity>& all, std::int32_t parent) const {
    const std::int64_t highest = all.empty() ? 0 : all.back().id;
    const std::int64_t tag = highest + part_.processes * std::int64_t{parent} + partition();
    if (tag > std::numeric_limits<std::int32_t>::max())
      throw InputError("the model has too many faces for a .msh file in this many parts");
    return static_cast<std::int32_t>(tag);
  }

  void addEntities(std::int32_t dimension, const std::vector<PartLabels::Entity>& labels) {
    for (const PartLabels::Entity& label : labels)
      entities_.push_back(
          {dimension, label.id, tagOf(labels, label.id), label.groups, {}, {}, {}, {}, {}});
  }

  PartEntity& entityOf(std::int32_t dimension, std::int32_t parent) {
    const auto key = [](const PartEntity& e) { return std::pair(e.dimension, e.parent); };
    const auto found = std::ranges::lower_bound(entities_, std::pair(dimension, parent), {}, key);
    AF2_CHECK(found != entities_.end() && key(*found) == std::pair(dimension, parent),
              "each element is on a face of the model");
    return *found;
  }

  void findEntities() {
    addEntities(kCurve, part_.labels.edges);
    const PartLabels& labels = part_.labels;
    entities_.push_back({kSurface, kGhosts, tagOf(labels.faces, kGhosts), {}, {}, {}, {}, {}, {}});
    addEntities(kSurface, labels.faces);
    for (std::size_t i = 0; i < part_.lines.size(); ++i)
      entityOf(kCurve, part_.lines[i].edge).lines.push_back(i);
    for (std::size_t e = 0; e < part_.elements.size(); ++e) {
      PartEntity& entity = entityOf(kSurface, e < part_.ownedElements ? part_.face[e] : kGhosts);
      (part_.elements[e].isQuad() ? entity.quads : entity.triangles).push_back(e);
    }
    std::erase_if(entities_, [](const PartEntity& entity) {
      return entity.parent != kGhosts && entity.lines.empty() && entity.triangles.empty() &&
             entity.quads.empty();
    });
    // Vertices belong to the first entity that comes to them: ghosts take what is left.
    std::ranges::stable_partition(entities_, [](const auto& e) { return e.parent != kGhosts; });
  }

  std::vector<std::size_t> verticesOf(const OwnedLine& line) const {
    std::vector<std::size_t> vertices{line.from.value, line.to.value};
    if (!line.middle.isNone()) vertices.push_back(line.middle.value);
    return vertices;
  }
  std::vector<std::size_t> verticesOf(std::size_t element) const {
    std::vector<std::size_t> vertices;
    const auto corners = part_.elements[element].vertices();
    for (const VertexId v : corners) vertices.push_back(v.value);
    for (std::size_t i = 0; !part_.midsides.empty() && i < corners.size(); ++i)
      vertices.push_back(part_.midsides[element][i].value);
    return vertices;
  }

  void placeVertices() {
    std::vector<bool> isPlaced(part_.vertices.size(), false);
    for (PartEntity& entity : entities_) {
      const auto take = [&](const std::vector<std::size_t>& vertices) {
        for (const std::size_t v : vertices) {
          entity.box.add(part_.vertices[v]);
          if (!isPlaced[v]) entity.vertices.push_back(v);
          isPlaced[v] = true;
        }
      };
      for (const std::size_t i : entity.lines) take(verticesOf(part_.lines[i]));
      for (const auto* elements : {&entity.triangles, &entity.quads})
        for (const std::size_t e : *elements) take(verticesOf(e));
      std::ranges::sort(entity.vertices);
    }
  }

  void writeNames() {
    file_.text("$PhysicalNames\n");
    file_.number(part_.labels.names.size());
    for (const PartLabels::Name& name : part_.labels.names) {
      file_.text("\n");
      file_.number(name.dimension);
      file_.text(" ");
      file_.number(name.group);
      file_.text(" \"" + name.name + "\"");
    }
    file_.text("\n$EndPhysicalNames\n");
  }

  std::size_t countOf(std::int32_t dimension) const {
    return static_cast<std::size_t>(std::ranges::count_if(entities_, [&](const PartEntity& e) {
      return e.dimension == dimension && e.parent != kGhosts;
    }));
  }

  void putCounts() {
    for (const std::int32_t dimension : {0, kCurve, kSurface, 3})
      file_.binary(std::uint64_t{countOf(dimension)});
  }

  void putBoxAndGroups(const PartEntity& entity) {
    for (const Point3& p : {entity.box.low, entity.box.high})
      for (const double x : {p.x, p.y, p.z}) file_.binary(x);
    file_.binary(std::uint64_t{entity.groups.size()});
    for (const std::int32_t group : entity.groups) file_.binary(group);
    file_.binary(std::uint64_t{0});  // what bounds it
  }

  void writeParents() {
    file_.text("$Entities\n");
    putCounts();
    for (const PartEntity& entity : entities_) {
      if (entity.parent == kGhosts) continue;
      file_.binary(entity.parent);
      putBoxAndGroups(entity);
    }
    file_.text("\n$EndEntities\n");
  }

  void writeEntities() {
    file_.text("$PartitionedEntities\n");
    file_.binary(std::uint64_t(static_cast<std::uint64_t>(part_.processes)));
    file_.binary(std::uint64_t{1});
    file_.binary(tagOf(part_.labels.faces, kGhosts));
    file_.binary(partition());
    putCounts();
    for (const PartEntity& entity : entities_) {
      if (entity.parent == kGhosts) continue;
      for (const std::int32_t number : {entity.tag, entity.dimension, entity.parent})
        file_.binary(number);
      file_.binary(std::uint64_t{1});
      file_.binary(partition());
      putBoxAndGroups(entity);
    }
    file_.text("\n$EndPartitionedEntities\n");
  }

  /// Tags are those of the whole mesh, from 1.
  ///
  /// more  lines, whose tags are higher
  void putHead(std::uint64_t blocks, const std::vector<std::uint64_t>& ids, std::uint64_t more,
               std::uint64_t highestOfMore) {
    if (ids.empty()) {  // there are more processes than elements
      for (int i = 0; i < 4; ++i) file_.binary(std::uint64_t{0});
      return;
    }
    const auto [least, most] = std::ranges::minmax(ids);
    for (const std::uint64_t number :
         {blocks, ids.size() + more, least + 1, more > 0 ? highestOfMore : most + 1})
      file_.binary(number);
  }

  void writeNodes() {
    file_.text("$Nodes\n");
    putHead(static_cast<std::uint64_t>(std::ranges::count_if(
                entities_, [](const PartEntity& e) { return !e.vertices.empty(); })),
            part_.vertexIds, 0, 0);
    for (const PartEntity& entity : entities_) {
      if (entity.vertices.empty()) continue;
      for (const std::int32_t number : {entity.dimension, entity.tag, 0}) file_.binary(number);
      file_.binary(std::uint64_t{entity.vertices.size()});
      for (const std::size_t v : entity.vertices) file_.binary(part_.vertexIds[v] + 1);
      for (const std::size_t v : entity.vertices)
        for (const double x : {part_.vertices[v].x, part_.vertices[v].y, part_.vertices[v].z})
          file_.binary(x);
    }
    file_.text("\n$EndNodes\n");
  }

  template <class TagOf, class VerticesOf>
  void writeBlock(const PartEntity& entity, std::int32_t type,
                  const std::vector<std::size_t>& members, TagOf tagOfMember,
                  VerticesOf verticesOfMember) {
    if (members.empty()) return;
    for (const std::int32_t number : {entity.dimension, entity.tag, type}) file_.binary(number);
    file_.binary(std::uint64_t{members.size()});
    for (const std::size_t member : members) {
      file_.binary(std::uint64_t{tagOfMember(member)});
      for (const std::size_t v : verticesOfMember(member)) file_.binary(part_.vertexIds[v] + 1);
    }
  }

  void writeElements() {
    std::uint64_t blocks = 0;
    for (const PartEntity& e : entities_)
      blocks += !e.lines.empty() + !e.triangles.empty() + !e.quads.empty();
    file_.text("$Elements\n");
    putHead(blocks, part_.elementIds, part_.lines.size(),
            part_.lines.empty() ? 0 : part_.allElements + part_.lines.back().id + 1);
    const bool isSecond = !part_.midsides.empty();
    const auto tagOfLine = [&](std::size_t i) { return part_.allElements + part_.lines[i].id + 1; };
    const auto tagOfElement = [&](std::size_t e) { return part_.elementIds[e] + 1; };
    const auto ofLine = [&](std::size_t i) { return verticesOf(part_.lines[i]); };
    const auto ofElement = [&](std::size_t e) { return verticesOf(e); };
    for (const PartEntity& entity : entities_) {
      writeBlock(entity, isSecond ? kLine2 : kLine, entity.lines, tagOfLine, ofLine);
      writeBlock(entity, isSecond ? kTriangle2 : kTriangle, entity.triangles, tagOfElement,
                 ofElement);
      writeBlock(entity, isSecond ? kQuad2 : kQuad, entity.quads, tagOfElement, ofElement);
    }
    file_.text("\n$EndElements\n");
  }

  /// Those of others that are ghosts here.
  void writeGhosts() {
    file_.text("$GhostElements\n");
    file_.binary(std::uint64_t{part_.elements.size() - part_.ownedElements});
    for (std::size_t e = part_.ownedElements; e < part_.elements.size(); ++e) {
      file_.binary(part_.elementIds[e] + 1);
      file_.binary(part_.elementOwners[e] + 1);
      file_.binary(std::uint64_t{1});
      file_.binary(partition());
    }
    file_.text("\n$EndGhostElements\n");
  }

  const OwnedPart& part_;
  OutputFile& file_;
  std::vector<PartEntity> entities_;  ///< curves, surfaces, ghosts
};

}  // namespace

void writePartMsh(const OwnedPart& part, OutputFile& file) { PartMsh(part, file).write(); }

}  // namespace af2::mpi
