#include "geometry/check/edge_checker.h"

#include <string>

#include "engine/base/parallel.h"

namespace af2::geometry {

std::vector<WantedUses> wantedUses(const ModelMesh& mesh) {
  std::vector<WantedUses> all;
  for (const EdgeSegment& s : mesh.segments) {
    const auto [low, high] = std::minmax(s.from, s.to);
    all.push_back({low, high, s.uses});
  }
  std::sort(all.begin(), all.end(),
            [](const WantedUses& a, const WantedUses& b) { return a.key() < b.key(); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (kept > 0 && all[kept - 1].key() == all[i].key())
      all[kept - 1].uses += all[i].uses;
    else
      all[kept++] = all[i];
  }
  all.resize(kept);
  return all;
}

Findings EdgeChecker::check(VertexRange range) {
  const auto [begin, end] = range;
  const MeshSides sides(range, mesh_.elements, task_.elements,
                        [&](std::uint32_t, std::uint32_t high) { return high < task_.last; });
  auto segment = firstFrom(begin);  // both are in order
  const auto last = firstFrom(end);
  for (std::size_t v = begin; v < end; ++v) {
    std::span<const MeshSide> left = sides.of(v);
    while (!left.empty()) {
      const std::pair key(VertexId(v), VertexId(left.front().to));
      std::size_t count = 1;
      while (count < left.size() && left[count].to == left.front().to) ++count;
      for (; segment != last && segment->key() < key; ++segment) addMissing(*segment);
      if (segment != last && segment->key() == key)
        checkSegment(*segment++, left.first(count));
      else
        checkEdge(position(key.first), left.first(count));
      left = left.subspan(count);
    }
  }
  for (; segment != last; ++segment) addMissing(*segment);
  return std::move(findings_);
}

void EdgeChecker::addMissing(const WantedUses& segment) {
  if (segment.uses > 0)
    findings_.add({0, "a segment of the boundary is missing from the mesh", position(segment.low)});
}

void EdgeChecker::checkSegment(const WantedUses& segment, std::span<const MeshSide> sides) {
  if (std::cmp_not_equal(sides.size(), segment.uses))
    findings_.add({faceOf(sides.front()),
                   "a segment of the boundary is used " + std::to_string(sides.size()) +
                       " times, not " + std::to_string(segment.uses),
                   position(segment.low)});
  // Along a seam a face uses a segment twice, in opposite directions.
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = i + 1; k < sides.size(); ++k)
      if (faceOf(sides[i]) == faceOf(sides[k]) && sides[i].isForward() == sides[k].isForward())
        findings_.add({faceOf(sides[i]), "a face uses a segment twice in one direction",
                       position(segment.low)});
}

void EdgeChecker::checkEdge(const Point3& place, std::span<const MeshSide> sides) {
  // Of two identical faces, the later one is removed.
  const int face = faceOf(sides.size() > 2 ? sides.back() : sides.front());
  if (sides.size() != 2) {
    findings_.add(
        {face, "an edge has " + std::to_string(sides.size()) + " elements, not 2", place});
    return;
  }
  if (sides[0].isForward() == sides[1].isForward())
    findings_.add({face, "two elements use an edge in the same direction", place});
  if (face != faceOf(sides[1]))
    findings_.add({face, "an edge that is no model edge has two faces", place});
}

void checkEdges(const EdgeChecker::Task& task, int threads, Findings& findings) {
  // The sides of all edges of a large mesh would take more memory than the mesh.
  constexpr std::size_t kVertices = 250'000;
  const Ranges ranges(std::min<std::size_t>(task.mesh.vertices.size(), task.last), kVertices);
  std::vector<Findings> found(ranges.count(), findings.none());
  forEachInParallel(found.size(), threads, [&](std::size_t i) {
    const auto vertices = ranges[i];
    found[i] = EdgeChecker(task, found[i]).check({vertices.front(), vertices.back() + 1});
  });
  for (Findings& some : found) findings.take(std::move(some));
}

}  // namespace af2::geometry
