#include "geometry/formats/group_members.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/formats/element_vertices.h"

namespace af2::geometry {
namespace {

std::string nameIn(const MshGroups& groups, const PhysicalGroup& group) {
  const auto found = groups.names().find(group);
  return found == groups.names().end() ? "face " + std::to_string(group.number) : found->second;
}

/// The groups of faces, asked for once each.
class GroupsByFace {
 public:
  explicit GroupsByFace(const MshGroups& groups) : groups_(groups) {}
  const std::vector<std::int32_t>& operator[](std::int32_t face) {
    const auto [own, isNew] = ofFace_.try_emplace(face);
    if (isNew) own->second = groups_.ofFace(face);
    return own->second;
  }

 private:
  const MshGroups& groups_;
  std::map<std::int32_t, std::vector<std::int32_t>> ofFace_;
};

}  // namespace

std::vector<GroupMembers> groupMembers(const ModelMesh& mesh, Lines lines,
                                       const MshGroups& groups) {
  std::map<PhysicalGroup, std::vector<std::uint32_t>> members;
  for (std::uint32_t i = 0; i < lines.size(); ++i)
    members[{PhysicalGroup::kCurve, groups.of(lines[i])}].push_back(i);
  GroupsByFace ofFace(groups);
  for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
    for (const std::int32_t group : ofFace[mesh.face[e]])
      members[{PhysicalGroup::kSurface, group}].push_back(e);
  std::vector<GroupMembers> result;
  for (auto& [group, own] : members)
    result.push_back({group, nameIn(groups, group), std::move(own)});
  return result;
}

std::vector<std::int32_t> firstGroups(const ModelMesh& mesh, const MshGroups& groups) {
  GroupsByFace ofFace(groups);
  std::vector<std::int32_t> first;
  for (const std::int32_t face : mesh.face) first.push_back(ofFace[face].front());
  return first;
}

std::vector<ElementBlock> elementBlocks(const ModelMesh& mesh, const MshGroups& groups) {
  const std::vector<std::int32_t> first = firstGroups(mesh, groups);
  std::map<std::pair<std::int32_t, bool>, std::vector<std::uint32_t>> elements;
  for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
    elements[{first[e], mesh.elements[e].isQuad()}].push_back(e);
  std::vector<ElementBlock> blocks;
  for (auto& [key, own] : elements) blocks.push_back({key.first, key.second, std::move(own)});
  return blocks;
}

std::vector<VertexId> verticesOf(const ModelMesh& mesh, Lines lines, const GroupMembers& group) {
  std::vector<VertexId> vertices;
  const bool isOfLines = group.group.dimension == PhysicalGroup::kCurve;
  for (const std::uint32_t i : group.members)
    for (const VertexId v : isOfLines ? mshVertices(lines[i]) : mshVertices(mesh, i))
      vertices.push_back(v);
  std::ranges::sort(vertices);
  const auto repeated = std::ranges::unique(vertices);
  vertices.erase(repeated.begin(), repeated.end());
  return vertices;
}

std::vector<bool> usedVertices(const ModelMesh& mesh) {
  std::vector<bool> isUsed(mesh.vertices.size(), false);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const VertexId v : mshVertices(mesh, e)) isUsed[v.value] = true;
  return isUsed;
}

std::vector<ElementSide> sidesOnLines(const ModelMesh& mesh, Lines lines) {
  std::map<std::pair<VertexId, VertexId>, std::vector<std::size_t>> byEnds;
  std::vector<bool> isOnLine(mesh.vertices.size(), false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    byEnds[std::minmax(lines[i].from, lines[i].to)].push_back(i);
    isOnLine[lines[i].from.value] = isOnLine[lines[i].to.value] = true;
  }
  std::vector<ElementSide> sides(lines.size());
  for (std::uint32_t e = 0; e < mesh.elements.size() && !byEnds.empty(); ++e) {
    const auto corners = mesh.elements[e].vertices();
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const VertexId from = corners[i], to = corners[(i + 1) % corners.size()];
      if (!isOnLine[from.value] || !isOnLine[to.value]) continue;
      const auto found = byEnds.find(std::minmax(from, to));
      if (found == byEnds.end()) continue;
      for (const std::size_t line : found->second) sides[line] = {e, i};
      byEnds.erase(found);
    }
  }
  return sides;
}

}  // namespace af2::geometry
