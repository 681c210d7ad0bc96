#include "geometry/model_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/mesh_sides.h"
#include "geometry/parallel.h"

namespace af2::geometry {

namespace {

/// A face without width has no elements, and no more than this share of the area of the mesh.
constexpr double kMostWithoutWidth = 1e-4;

/// How often a piece of a model edge is to be used. Several may have the same ends.
struct WantedUses {
  VertexId low, high;
  int uses = 0;
  auto key() const { return std::pair(low, high); }
};

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

/// No more than so many.
class Findings {
 public:
  explicit Findings(std::size_t limit) : limit_(limit) {}

  void add(MeshFinding finding) {
    if (all_.size() < limit_) all_.push_back(std::move(finding));
  }
  void take(Findings other) {
    for (MeshFinding& finding : other.all_) add(std::move(finding));
  }
  std::vector<MeshFinding> result() { return std::move(all_); }

 private:
  std::size_t limit_;
  std::vector<MeshFinding> all_;
};

/// Looks at corners and areas.
class ElementChecker {
 public:
  ElementChecker(const ModelMesh& mesh, Findings& findings) : mesh_(mesh), findings_(findings) {}

  void checkElements() {
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) checkElement(i);
  }

  void checkAreas() {
    double whole = 0;
    for (const auto& [id, area] : areas_) whole += area;
    for (const FaceReport& face : mesh_.faces) {
      if (face.status != FaceStatus::Complete || !(face.area > 0)) continue;
      if (!areas_.contains(face.id) && face.area < kMostWithoutWidth * whole) continue;
      const double ratio = areas_[face.id] / face.area;
      if (!isWrongArea(ratio, face.elements)) continue;
      findings_.add({face.id,
                     "the elements have " + std::to_string(ratio) + " times the area of the face",
                     {}});
    }
  }

  /// Elements with wrong corners, in order.
  const std::vector<std::size_t>& unsound() const { return unsound_; }

 private:
  const Point3& position(VertexId v) const { return mesh_.vertices[v.value]; }

  void checkElement(std::size_t i) {
    const auto corners = mesh_.elements[i].vertices();
    for (const VertexId v : corners) {
      if (v.value < mesh_.vertices.size()) continue;
      findings_.add({mesh_.face[i], "an element has a corner that is no vertex", {}});
      unsound_.push_back(i);
      return;
    }
    for (std::size_t a = 0; a < corners.size(); ++a)
      for (std::size_t b = a + 1; b < corners.size(); ++b)
        if (corners[a] == corners[b]) {
          findings_.add({mesh_.face[i], "an element has a corner twice", position(corners[a])});
          unsound_.push_back(i);
          return;
        }
    const double area = areaOf(i);
    if (!(area > 0)) findings_.add({mesh_.face[i], "an element has no area", position(corners[0])});
    if (i == 0 || mesh_.face[i] != mesh_.face[i - 1]) areaOfFace_ = &areas_[mesh_.face[i]];
    *areaOfFace_ += area;
  }

  double areaOf(std::size_t i) const {
    const auto c = mesh_.elements[i].vertices();
    Point3 sum;
    for (std::size_t k = 1; k + 1 < c.size(); ++k)
      sum = sum + cross(position(c[k]) - position(c[0]), position(c[k + 1]) - position(c[0]));
    return length(sum) / 2;
  }

  const ModelMesh& mesh_;
  Findings& findings_;
  std::vector<std::size_t> unsound_;
  std::map<int, double> areas_;   ///< by face
  double* areaOfFace_ = nullptr;  ///< in areas_, of the element before
};

/// Looks at the edges whose lower vertex is one of some.
class EdgeChecker {
 public:
  /// What goes into all parts.
  struct Task {
    const ModelMesh& mesh;
    const std::vector<std::size_t>& unsound;  ///< elements that do not count, in order
    const std::vector<WantedUses>& wanted;
  };

  EdgeChecker(const Task& task, std::size_t limit)
      : mesh_(task.mesh), task_(task), findings_(limit) {}

  Findings check(std::size_t begin, std::size_t end) {
    const MeshSides sides(
        mesh_, [&](std::size_t i) { return !std::ranges::binary_search(task_.unsound, i); }, begin,
        end);
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

 private:
  std::vector<WantedUses>::const_iterator firstFrom(std::size_t vertex) const {
    return std::ranges::lower_bound(task_.wanted, VertexId(vertex), {}, &WantedUses::low);
  }
  const Point3& position(VertexId v) const { return mesh_.vertices[v.value]; }
  int faceOf(const MeshSide& side) const { return mesh_.face[side.element()]; }

  void addMissing(const WantedUses& segment) {
    if (segment.uses > 0)
      findings_.add(
          {0, "a segment of the boundary is missing from the mesh", position(segment.low)});
  }

  void checkSegment(const WantedUses& segment, std::span<const MeshSide> sides) {
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

  void checkEdge(const Point3& place, std::span<const MeshSide> sides) {
    // Of faces that are there twice, the later one goes.
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

  const ModelMesh& mesh_;
  const Task& task_;
  Findings findings_;
};

/// Sides take more memory than the mesh: those of a large one are looked at in parts.
void checkEdges(const EdgeChecker::Task& task, std::size_t limit, int threads, Findings& findings) {
  constexpr std::size_t kMostVertices = 500'000;
  const std::size_t vertices = task.mesh.vertices.size();
  std::vector<Findings> parts((vertices + kMostVertices - 1) / kMostVertices, Findings(limit));
  forEachInParallel(parts.size(), threads, [&](std::size_t i) {
    const std::size_t begin = i * kMostVertices;
    parts[i] = EdgeChecker(task, limit).check(begin, std::min(begin + kMostVertices, vertices));
  });
  for (Findings& part : parts) findings.take(std::move(part));
}

}  // namespace

bool isWrongArea(double ratio, std::size_t elements) {
  constexpr std::size_t kFew = 60;
  constexpr double kMostFactor = 1.4, kMostFactorOfFew = 5;
  const double most = elements < kFew ? kMostFactorOfFew : kMostFactor;
  return ratio < 1 / most || ratio > most;
}

std::vector<MeshFinding> checkModelMesh(const ModelMesh& mesh, std::size_t limit, int threads) {
  Findings findings(limit);
  ElementChecker elements(mesh, findings);
  elements.checkElements();
  checkEdges({mesh, elements.unsound(), wantedUses(mesh)}, limit, threads, findings);
  elements.checkAreas();
  return findings.result();
}

}  // namespace af2::geometry
