#include "geometry/mpi/partition/part_builder.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace af2::mpi {

namespace {

template <class T>
void append(std::vector<T>& values, const std::vector<T>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

/// By process: where its numbers begin in the whole mesh.
std::vector<std::uint64_t> firstNumbers(const std::vector<std::uint64_t>& counts) {
  std::vector<std::uint64_t> first(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), first.begin(), std::uint64_t{0});
  return first;
}

/// Sorts vertices by their ids, each of which stays once.
void makeUnique(std::vector<PieceVertex>& vertices) {
  std::ranges::sort(vertices, {}, &PieceVertex::id);
  const auto same = std::ranges::unique(vertices, {}, &PieceVertex::id);
  vertices.erase(same.begin(), same.end());
}

/// Where the vertices are in a part, by their ids.
class Indices {
 public:
  /// Adds the vertices to the part: its own ones first, by their numbers, then those of others by
  /// their ids.
  Indices(const std::vector<PieceVertex>& vertices, const PartEnd& end, OwnedPart& part)
      : indices_(vertices.size()) {
    for (const PieceVertex& vertex : vertices) ids_.push_back(vertex.id);
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto others = std::ranges::stable_partition(
        order, [&](std::uint32_t i) { return vertices[i].owner == part.process; });
    part.ownedVertices = order.size() - others.size();
    std::ranges::sort(order.begin(), others.begin(), {},
                      [&](std::uint32_t i) { return vertices[i].number; });
    const std::vector<std::uint64_t> first = firstNumbers(end.vertices);
    for (const std::uint32_t i : order) {
      const PieceVertex& vertex = vertices[i];
      indices_[i] = static_cast<std::uint32_t>(part.vertices.size());
      part.vertices.push_back(vertex.position);
      part.vertexIds.push_back(vertex.id);
      part.vertexNumbers.push_back(first[static_cast<std::size_t>(vertex.owner)] + vertex.number);
      part.vertexOwners.push_back(vertex.owner);
    }
  }

  VertexId at(VertexId v) const {
    if (v.isNone()) return v;
    const auto found = std::ranges::lower_bound(ids_, v.value);
    return VertexId(std::size_t{indices_[static_cast<std::size_t>(found - ids_.begin())]});
  }

 private:
  std::vector<std::uint32_t> ids_, indices_;  // ids ascend
};

}  // namespace

void PartBuilder::take(const PartPiece& piece) {
  for (const PieceElement& element : piece.elements) {
    Elements& some = element.owner == process_ ? own_ : ghosts_;
    some.corners.push_back({element.corners});
    if (!element.midsides[0].isNone()) some.midsides.push_back(element.midsides);
    some.ids.push_back(element.id);
    some.numbers.push_back(element.number);
    some.owners.push_back(element.owner);
    some.faces.push_back(piece.face);
  }
  append(vertices_, piece.vertices);
  for (const std::int32_t count : piece.ghostCounts)
    ghostsBegin_.push_back(ghostsBegin_.back() + static_cast<std::size_t>(count));
  append(ghostsOf_, piece.ghostsOf);
}

OwnedPart PartBuilder::finish(PartEnd end) {
  OwnedPart part;
  part.process = process_;
  part.processes = static_cast<std::int32_t>(end.vertices.size());
  part.allVertices = std::reduce(end.vertices.begin(), end.vertices.end());
  part.allElements = std::reduce(end.elements.begin(), end.elements.end());
  part.allLines = end.allLines;
  part.labels = std::move(end.labels);

  makeUnique(vertices_);
  const Indices indices(std::exchange(vertices_, {}), end, part);

  part.ownedElements = own_.ids.size();
  const auto both = [&](auto of) {
    auto all = std::move(own_.*of);
    append(all, ghosts_.*of);
    (ghosts_.*of) = {};
    return all;
  };
  part.elements = both(&Elements::corners);
  part.midsides = both(&Elements::midsides);
  part.elementIds = both(&Elements::ids);
  part.elementNumbers = both(&Elements::numbers);
  part.elementOwners = both(&Elements::owners);
  part.face = both(&Elements::faces);
  part.ghostsBegin = std::move(ghostsBegin_);
  part.ghostsOf = std::move(ghostsOf_);

  const std::vector<std::uint64_t> first = firstNumbers(end.elements);
  for (std::size_t e = 0; e < part.elements.size(); ++e)
    part.elementNumbers[e] += first[static_cast<std::size_t>(part.elementOwners[e])];
  for (Element& element : part.elements)
    for (VertexId& v : element.corners) v = indices.at(v);
  for (std::array<VertexId, 4>& middles : part.midsides)
    for (VertexId& v : middles) v = indices.at(v);
  for (const OwnedLine& line : end.lines)
    part.lines.push_back(
        {indices.at(line.from), indices.at(line.to), indices.at(line.middle), line.id, line.edge});
  return part;
}

}  // namespace af2::mpi
