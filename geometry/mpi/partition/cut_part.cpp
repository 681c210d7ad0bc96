#include "geometry/mpi/partition/cut_part.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace af2::mpi {

namespace {

using geometry::LineElement;
using geometry::ModelMesh;

class PartCutter {
 public:
  PartCutter(const DividedMesh& divided, int part)
      : divided_(divided), mesh_(divided.mesh()), index_(divided.mesh().vertices.size(), kNone) {
    part_.process = part;
    part_.processes = divided.parts();
    part_.allVertices = mesh_.vertices.size();
    part_.allElements = mesh_.elements.size();
  }

  OwnedPart cut(std::span<const LineElement> lines, std::span<const std::int32_t> owners) {
    const std::vector<std::uint32_t>& own = divided_.elementsOf(part_.process);
    const std::vector<std::uint32_t> ghosts = ghostsBeside(own);
    part_.ownedElements = own.size();
    numberVertices(own, ghosts);
    for (const std::uint32_t e : own) add(e);
    for (const std::uint32_t e : ghosts) add(e);
    findGhostsOf(own);
    part_.allLines = lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (owners[i] == part_.process) add(lines[i], i);
    return std::move(part_);
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> ghostsBeside(const std::vector<std::uint32_t>& own) const {
    std::vector<std::uint32_t> ghosts;
    for (const std::uint32_t e : own)
      divided_.forEachBeside(e, [&](std::uint32_t other) {
        if (divided_.ownerOfElement(other) != part_.process) ghosts.push_back(other);
      });
    std::ranges::sort(ghosts);
    ghosts.erase(std::ranges::unique(ghosts).begin(), ghosts.end());
    return ghosts;
  }

  void forEachVertex(std::uint32_t element, const auto& visit) const {
    const auto corners = mesh_.elements[element].vertices();
    for (const VertexId v : corners) visit(v.value);
    for (std::size_t i = 0; !mesh_.midsides.empty() && i < corners.size(); ++i)
      visit(mesh_.midsides[element][i].value);
  }

  /// Own vertices first, each kind in the order of the whole mesh.
  void numberVertices(const std::vector<std::uint32_t>& own,
                      const std::vector<std::uint32_t>& ghosts) {
    std::vector<std::uint32_t> all;
    for (const auto* elements : {&own, &ghosts})
      for (const std::uint32_t e : *elements)
        forEachVertex(e, [&](std::uint32_t v) { all.push_back(v); });
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    const auto isOwn = [&](std::uint32_t v) { return divided_.ownerOfVertex(v) == part_.process; };
    std::ranges::stable_partition(all, isOwn);
    part_.ownedVertices = static_cast<std::size_t>(std::ranges::count_if(all, isOwn));
    for (const std::uint32_t v : all) {
      index_[v] = static_cast<std::uint32_t>(part_.vertices.size());
      part_.vertices.push_back(mesh_.vertices[v]);
      part_.vertexIds.push_back(v);
      part_.vertexNumbers.push_back(divided_.numberOfVertex(v));
      part_.vertexOwners.push_back(divided_.ownerOfVertex(v));
    }
  }

  VertexId at(VertexId v) const { return v.isNone() ? v : VertexId(std::size_t{index_[v.value]}); }

  void add(std::uint32_t e) {
    Element element = mesh_.elements[e];
    for (VertexId& v : element.corners) v = at(v);
    part_.elements.push_back(element);
    part_.elementIds.push_back(e);
    part_.elementNumbers.push_back(divided_.numberOfElement(e));
    part_.elementOwners.push_back(divided_.ownerOfElement(e));
    part_.face.push_back(mesh_.face[e]);
    if (mesh_.midsides.empty()) return;
    part_.midsides.push_back(mesh_.midsides[e]);
    for (VertexId& v : part_.midsides.back()) v = at(v);
  }

  void add(const LineElement& line, std::size_t id) {
    part_.lines.push_back({at(line.from), at(line.to), at(line.middle), id, line.edge});
  }

  void findGhostsOf(const std::vector<std::uint32_t>& own) {
    part_.ghostsBegin.push_back(0);
    for (const std::uint32_t e : own) {
      std::set<std::int32_t> others;
      divided_.forEachBeside(e, [&](std::uint32_t other) {
        const std::int32_t owner = divided_.ownerOfElement(other);
        if (owner != part_.process) others.insert(owner);
      });
      part_.ghostsOf.insert(part_.ghostsOf.end(), others.begin(), others.end());
      part_.ghostsBegin.push_back(part_.ghostsOf.size());
    }
  }

  const DividedMesh& divided_;
  const ModelMesh& mesh_;
  std::vector<std::uint32_t> index_;  ///< by vertex of the mesh
  OwnedPart part_;
};

}  // namespace

std::vector<std::int32_t> ownersOfLines(const DividedMesh& divided,
                                        std::span<const LineElement> lines) {
  std::map<std::pair<VertexId, VertexId>, std::vector<std::size_t>> bySide;
  for (std::size_t i = 0; i < lines.size(); ++i)
    bySide[std::minmax(lines[i].from, lines[i].to)].push_back(i);
  std::vector<std::int32_t> owners(lines.size(), -1);
  const ModelMesh& mesh = divided.mesh();
  for (std::uint32_t e = 0; !lines.empty() && e < mesh.elements.size(); ++e) {
    const auto corners = mesh.elements[e].vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto found = bySide.find(std::minmax(corners[i], corners[(i + 1) % corners.size()]));
      if (found == bySide.end()) continue;
      for (const std::size_t line : found->second)
        if (owners[line] < 0) owners[line] = divided.ownerOfElement(e);
    }
  }
  std::ranges::replace(owners, -1, 0);
  return owners;
}

OwnedPart cutPart(const DividedMesh& divided, std::span<const LineElement> lines,
                  std::span<const std::int32_t> owners, int part) {
  return PartCutter(divided, part).cut(lines, owners);
}

}  // namespace af2::mpi
