#include "geometry/mpi/partition/divide_mesh.h"

#include <metis.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "engine/base/error.h"

namespace af2::mpi {

namespace {

void refuseTooManyFor(const geometry::ModelMesh& mesh) {
  constexpr std::size_t kCornersAtMost = 4;
  const auto most = static_cast<std::size_t>(std::numeric_limits<idx_t>::max()) / kCornersAtMost;
  if (mesh.elements.size() > most)
    throw InputError("the mesh has " + std::to_string(mesh.elements.size()) +
                     " elements, and METIS can divide at most " + std::to_string(most));
}

/// One array of METIS: its owners by number, and the numbers that follow each other for each owner.
std::vector<std::uint64_t> numbersFor(const std::vector<std::int32_t>& owners, int parts) {
  std::vector<std::uint64_t> next(static_cast<std::size_t>(parts) + 1, 0);
  for (const std::int32_t owner : owners) ++next[static_cast<std::size_t>(owner) + 1];
  for (std::size_t p = 1; p < next.size(); ++p) next[p] += next[p - 1];
  std::vector<std::uint64_t> numbers;
  numbers.reserve(owners.size());
  for (const std::int32_t owner : owners)
    numbers.push_back(next[static_cast<std::size_t>(owner)]++);
  return numbers;
}

}  // namespace

std::vector<std::int32_t> divideMesh(const geometry::ModelMesh& mesh, int parts) {
  refuseTooManyFor(mesh);
  const std::size_t count = mesh.elements.size();
  std::vector<std::int32_t> owners(count, 0);
  if (parts <= 1 || count <= static_cast<std::size_t>(parts)) {
    for (std::size_t e = 0; e < count; ++e) owners[e] = static_cast<std::int32_t>(e) % parts;
    return owners;
  }
  std::vector<idx_t> begin{0}, corners, ofElement(count), ofVertex(mesh.vertices.size());
  for (const Element& element : mesh.elements) {
    for (const VertexId v : element.vertices()) corners.push_back(static_cast<idx_t>(v.value));
    begin.push_back(static_cast<idx_t>(corners.size()));
  }
  idx_t elements = static_cast<idx_t>(count), vertices = static_cast<idx_t>(mesh.vertices.size());
  idx_t common = 2, wanted = parts, cut = 0, options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // else the parts may differ from run to run
  const int outcome = METIS_PartMeshDual(&elements, &vertices, begin.data(), corners.data(),
                                         nullptr, nullptr, &common, &wanted, nullptr, options, &cut,
                                         ofElement.data(), ofVertex.data());
  if (outcome != METIS_OK) throw InputError("METIS could not divide the mesh");
  std::ranges::copy(ofElement, owners.begin());
  return owners;
}

DividedMesh::DividedMesh(const geometry::ModelMesh& mesh, std::vector<std::int32_t> elementOwners,
                         int parts)
    : mesh_(mesh),
      elementOwners_(std::move(elementOwners)),
      elementsOf_(static_cast<std::size_t>(parts)),
      elementNumbers_(numbersFor(elementOwners_, parts)) {
  for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
    elementsOf_[static_cast<std::size_t>(elementOwners_[e])].push_back(e);
  findElementsAround();
  findOwnersOfVertices();
  vertexNumbers_ = numbersFor(vertexOwners_, parts);
}

void DividedMesh::findElementsAround() {
  begin_.assign(mesh_.vertices.size() + 1, 0);
  for (const Element& element : mesh_.elements)
    for (const VertexId v : element.vertices()) ++begin_[v.value + 1];
  for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  around_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t e = 0; e < mesh_.elements.size(); ++e)
    for (const VertexId v : mesh_.elements[e].vertices()) around_[next[v.value]++] = e;
}

/// The lowest process wins: a rule that each can follow. A vertex without elements goes to the
/// first.
void DividedMesh::findOwnersOfVertices() {
  constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();
  vertexOwners_.assign(mesh_.vertices.size(), kNone);
  const auto claim = [&](VertexId v, std::uint32_t element) {
    vertexOwners_[v.value] = std::min(vertexOwners_[v.value], elementOwners_[element]);
  };
  for (std::uint32_t e = 0; e < mesh_.elements.size(); ++e) {
    const auto corners = mesh_.elements[e].vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      claim(corners[i], e);
      if (!mesh_.midsides.empty()) claim(mesh_.midsides[e][i], e);
    }
  }
  std::ranges::replace(vertexOwners_, kNone, 0);
}

}  // namespace af2::mpi
