#include "geometry/mpi/partition/divide_mesh.h"

#include <metis.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/base/error.h"
#include "geometry/mpi/partition/patch_graph.h"

namespace af2::mpi {

namespace {

/// By patch: its part.
std::vector<std::int32_t> dividedByMetis(const PatchGraph& graph, int parts) {
  const std::size_t patches = graph.elements.size();
  std::vector<std::int32_t> partOf(patches);
  if (parts <= 1 || patches <= static_cast<std::size_t>(parts)) {
    for (std::size_t p = 0; p < patches; ++p) partOf[p] = static_cast<std::int32_t>(p) % parts;
    return partOf;
  }
  if (graph.links.size() > static_cast<std::size_t>(std::numeric_limits<idx_t>::max()))
    throw InputError("the mesh would be divided into too many parts for METIS");
  std::vector<idx_t> begin(patches + 1, 0), beside, sides, weights, result(patches);
  for (const PatchGraph::Link& link : graph.links) {
    ++begin[link.from + 1];
    beside.push_back(static_cast<idx_t>(link.to));
    sides.push_back(static_cast<idx_t>(link.sides));
  }
  for (std::size_t p = 0; p < patches; ++p) begin[p + 1] += begin[p];
  for (const std::uint64_t count : graph.elements) weights.push_back(static_cast<idx_t>(count));
  idx_t vertices = static_cast<idx_t>(patches), constraints = 1, wanted = parts, cut = 0,
        options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // else the parts may differ from run to run
  const int outcome = METIS_PartGraphKway(&vertices, &constraints, begin.data(), beside.data(),
                                          weights.data(), nullptr, sides.data(), &wanted, nullptr,
                                          nullptr, options, &cut, result.data());
  if (outcome != METIS_OK) throw InputError("METIS could not divide the mesh");
  std::ranges::copy(result, partOf.begin());
  return partOf;
}

/// Finds the parts at vertices from the patches at them.
void findPartsAt(std::vector<std::pair<std::uint32_t, std::uint32_t>> atVertices,
                 MeshDivision& division) {
  for (auto& [vertex, patch] : atVertices)
    patch = static_cast<std::uint32_t>(division.partOfPatch[patch]);
  std::ranges::sort(atVertices);
  atVertices.erase(std::ranges::unique(atVertices).begin(), atVertices.end());
  division.begin.assign(std::size_t{division.insideFrom} + 1, 0);
  for (const auto& [vertex, part] : atVertices) {
    ++division.begin[vertex + 1];
    division.partsAt.push_back(static_cast<std::int32_t>(part));
  }
  for (std::size_t v = 0; v < division.insideFrom; ++v) division.begin[v + 1] += division.begin[v];
}

}  // namespace

Point3 middleOf(const geometry::MeshSlice& slice, std::size_t element) {
  const auto corners = slice.elements[element].vertices();
  Point3 sum{};
  for (const VertexId v : corners) sum = sum + slice.position(v);
  return 1.0 / static_cast<double>(corners.size()) * sum;
}

MeshDivision divisionInto(int count, std::vector<std::int32_t> parts, PatchGraph graph) {
  MeshDivision division;
  division.parts = count;
  division.partOfPatch = std::move(parts);
  division.insideFrom = graph.insideFrom;
  division.faces = std::move(graph.faces);
  findPartsAt(std::move(graph.atVertices), division);
  return division;
}

MeshDivision divideMesh(const geometry::ModelMesh& mesh, int parts) {
  // Small enough for the balance and the borders of the parts, few enough for any mesh.
  constexpr std::size_t kPatchesPerPart = 500;
  const std::size_t patches = kPatchesPerPart * static_cast<std::size_t>(parts);
  PatchGraph graph = patchGraph(mesh, std::max<std::size_t>(elementCount(mesh) / patches, 1));
  std::vector<std::int32_t> partOfPatch = dividedByMetis(graph, parts);
  return divisionInto(parts, std::move(partOfPatch), std::move(graph));
}

}  // namespace af2::mpi
