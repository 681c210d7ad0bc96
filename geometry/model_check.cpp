#include "geometry/model_check.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace af2::geometry {

namespace {

/// A mesh of straight elements has another area than a curved face, or than a plane face with a
/// curved boundary: on a face of a few elements, quite another one.
constexpr double kMostAreaFactor = 1.4, kMostAreaFactorOfFew = 5;
constexpr std::size_t kFewElements = 60;

struct HalfEdge {
  VertexId low, high;
  std::uint32_t element;
  bool forward;  ///< from low to high
  auto key() const { return std::pair(low, high); }
};

HalfEdge halfEdge(VertexId from, VertexId to, std::size_t element) {
  const auto index = static_cast<std::uint32_t>(element);
  return from < to ? HalfEdge{from, to, index, true} : HalfEdge{to, from, index, false};
}

/// Sorts by low, then high end, keeping the order of equal ones: first into a bucket for each low
/// end, of which each has but a few.
std::vector<HalfEdge> sorted(const std::vector<HalfEdge>& edges, std::size_t vertexCount) {
  std::vector<std::uint32_t> start(vertexCount + 1, 0);
  for (const HalfEdge& e : edges) ++start[e.low.value + 1];
  for (std::size_t v = 0; v < vertexCount; ++v) start[v + 1] += start[v];
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  std::vector<HalfEdge> result(edges.size());
  for (const HalfEdge& e : edges) result[next[e.low.value]++] = e;
  for (std::size_t v = 0; v < vertexCount; ++v)
    std::stable_sort(result.begin() + start[v], result.begin() + start[v + 1],
                     [](const HalfEdge& a, const HalfEdge& b) { return a.high < b.high; });
  return result;
}

class Checker {
 public:
  Checker(const ModelMesh& mesh, std::size_t limit) : mesh_(mesh), limit_(limit) {}

  std::vector<MeshFinding> check() {
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) checkElement(i);
    sortEdges();
    checkEdges();
    checkAreas();
    return std::move(findings_);
  }

 private:
  void add(int face, std::string what, const Point3& place) {
    if (findings_.size() < limit_) findings_.push_back({face, std::move(what), place});
  }
  const Point3& position(VertexId v) const { return mesh_.vertices[v.value]; }

  void checkElement(std::size_t i) {
    const auto corners = mesh_.elements[i].vertices();
    for (const VertexId v : corners) {
      if (v.value < mesh_.vertices.size()) continue;
      add(mesh_.face[i], "an element has a corner that is no vertex", {});
      return;
    }
    for (std::size_t a = 0; a < corners.size(); ++a)
      for (std::size_t b = a + 1; b < corners.size(); ++b)
        if (corners[a] == corners[b]) {
          add(mesh_.face[i], "an element has a corner twice", position(corners[a]));
          return;
        }
    const double area = areaOf(i);
    if (!(area > 0)) add(mesh_.face[i], "an element has no area", position(corners[0]));
    areas_[mesh_.face[i]] += area;
    for (std::size_t a = 0; a < corners.size(); ++a)
      edges_.push_back(halfEdge(corners[a], corners[(a + 1) % corners.size()], i));
  }

  double areaOf(std::size_t i) const {
    const auto c = mesh_.elements[i].vertices();
    Point3 sum;
    for (std::size_t k = 1; k + 1 < c.size(); ++k)
      sum = sum + cross(position(c[k]) - position(c[0]), position(c[k + 1]) - position(c[0]));
    return length(sum) / 2;
  }

  void sortEdges() {
    edges_ = sorted(edges_, mesh_.vertices.size());
    for (const EdgeSegment& s : mesh_.segments) {
      const auto [low, high] = std::minmax(s.from, s.to);
      segments_[{low, high}] += s.uses;
    }
  }

  void checkEdges() {
    for (std::size_t i = 0; i < edges_.size();) {
      std::size_t end = i;
      while (end < edges_.size() && edges_[end].key() == edges_[i].key()) ++end;
      checkEdge(i, end);
      i = end;
    }
    for (const auto& [key, uses] : segments_)
      if (uses > 0)
        add(0, "a segment of the boundary is missing from the mesh", position(key.first));
  }

  void checkEdge(std::size_t first, std::size_t last) {
    const HalfEdge& edge = edges_[first];
    const int face = mesh_.face[edge.element];
    const auto count = static_cast<int>(last - first);
    const auto segment = segments_.find(edge.key());
    if (segment != segments_.end()) {
      if (count != segment->second)
        add(face,
            "a segment of the boundary is used " + std::to_string(count) + " times, not " +
                std::to_string(segment->second),
            position(edge.low));
      segment->second = 0;
      checkSameFaceTwins(first, last);
      return;
    }
    if (count != 2) {
      add(face, "an edge has " + std::to_string(count) + " elements, not 2", position(edge.low));
      return;
    }
    if (edges_[first].forward == edges_[first + 1].forward)
      add(face, "two elements use an edge in the same direction", position(edge.low));
    if (face != mesh_.face[edges_[first + 1].element])
      add(face, "an edge that is no model edge has two faces", position(edge.low));
  }

  /// Along a seam a face uses a segment twice, in opposite directions.
  void checkSameFaceTwins(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = i + 1; k < last; ++k)
        if (mesh_.face[edges_[i].element] == mesh_.face[edges_[k].element] &&
            edges_[i].forward == edges_[k].forward)
          add(mesh_.face[edges_[i].element], "a face uses a segment twice in one direction",
              position(edges_[i].low));
  }

  void checkAreas() {
    for (const FaceReport& face : mesh_.faces) {
      if (face.status != FaceStatus::Complete || !(face.area > 0)) continue;
      const double ratio = areas_[face.id] / face.area;
      const double most = face.elements < kFewElements ? kMostAreaFactorOfFew : kMostAreaFactor;
      if (ratio >= 1 / most && ratio <= most) continue;
      add(face.id, "the elements have " + std::to_string(ratio) + " times the area of the face",
          {});
    }
  }

  const ModelMesh& mesh_;
  std::size_t limit_;
  std::vector<HalfEdge> edges_;
  std::map<std::pair<VertexId, VertexId>, int> segments_;
  std::map<int, double> areas_;
  std::vector<MeshFinding> findings_;
};

}  // namespace

std::vector<MeshFinding> checkModelMesh(const ModelMesh& mesh, std::size_t limit) {
  return Checker(mesh, limit).check();
}

}  // namespace af2::geometry
