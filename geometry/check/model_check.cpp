#include "geometry/check/model_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "engine/mesh/vertex_stars.h"
#include "geometry/base/parallel.h"
#include "geometry/mesh/merged_patches.h"
#include "geometry/mesh/mesh_sides.h"

namespace af2::geometry {

namespace {

/// A face without width has no elements, and no more than this share of the area of the mesh.
constexpr double kMaxWithoutWidth = 1e-4;

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
  /// No findings yet; at most `limit` of them are kept.
  Findings none() const { return Findings(limit_); }
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
  ElementChecker(const ModelMesh& mesh, Findings& findings)
      : mesh_(mesh), patches_(mesh), findings_(findings) {
    for (const EdgeSegment& segment : mesh.segments)
      firstInside_ = std::max({firstInside_, segment.from.value + 1, segment.to.value + 1});
  }

  void checkElements() {
    double* area = nullptr;  // of the face
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) {
      if (i == 0 || mesh_.face[i] != mesh_.face[i - 1]) {
        area = &areas_[patches_.of(mesh_.face[i])];
        insides_.emplace_back();
      }
      if (!hasProperCorners(mesh_.elements[i], mesh_.vertices.size())) {
        addUnsound(i);
        continue;
      }
      *area += checkedArea(i);
      noteInside(i);
    }
  }

  struct Patch {
    double area = 0;
    std::size_t elements = 0;
  };
  /// Complete faces of known area, by id; those that were meshed together are one.
  std::map<int, Patch> patchesOfFaces() const {
    std::map<int, Patch> all;
    for (const FaceReport& face : mesh_.faces) {
      if (face.status != FaceStatus::Complete || !(face.area > 0)) continue;
      Patch& patch = all[patches_.of(face.id)];
      patch.area += face.area;
      patch.elements += face.elements;
    }
    return all;
  }

  void checkAreas() {
    double whole = 0;
    for (const auto& [id, area] : areas_) whole += area;
    for (const auto& [id, face] : patchesOfFaces()) {
      if (!areas_.contains(id) && face.area < kMaxWithoutWidth * whole) continue;
      const double ratio = areas_[id] / face.area;
      if (!isWrongArea(ratio, face.elements)) continue;
      findings_.add(
          {id, "the elements have " + std::to_string(ratio) + " times the area of the face", {}});
    }
  }

  /// The lowest vertex such that no later vertex is on a segment or belongs to elements of two
  /// faces; nothing if the numbering gives no such vertex, or if corners are wrong.
  std::optional<std::uint32_t> firstInside() const {
    if (!unsound_.empty()) return std::nullopt;
    std::vector<Range> insides = insides_;
    std::erase_if(insides, [](const Range& inside) { return inside.low > inside.high; });
    std::ranges::sort(insides, {}, &Range::low);
    const auto meet = [](const Range& a, const Range& b) { return a.high >= b.low; };
    if (std::ranges::adjacent_find(insides, meet) != insides.end()) return std::nullopt;
    return firstInside_;
  }
  /// Elements with right corners, ascending.
  std::vector<std::size_t> sound() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i)
      if (!std::ranges::binary_search(unsound_, i)) all.push_back(i);
    return all;
  }
  /// All of these elements that have a side between vertices before firstInside().
  const std::vector<std::size_t>& atSegments() const { return atSegments_; }

 private:
  /// The lowest and the highest of some vertices.
  struct Range {
    std::uint32_t low = 0xffffffffu, high = 0;
  };

  const Point3& position(VertexId v) const { return mesh_.vertices[v.value]; }

  void addUnsound(std::size_t i) {
    unsound_.push_back(i);
    for (const VertexId v : mesh_.elements[i].vertices())
      if (v.value >= mesh_.vertices.size())
        return findings_.add({mesh_.face[i], "an element has a corner that is not a vertex", {}});
    std::array<VertexId, 4> corners = mesh_.elements[i].corners;
    std::ranges::sort(corners);
    const VertexId twice = *std::ranges::adjacent_find(corners);
    findings_.add({mesh_.face[i], "an element has a corner twice", position(twice)});
  }

  double checkedArea(std::size_t i) {
    const auto& [a, b, c, d] = mesh_.elements[i].corners;
    const Point3& origin = position(a);
    const Point3 diagonal = position(c) - origin;
    Point3 sum = cross(position(b) - origin, diagonal);
    if (!d.isNone()) sum = sum + cross(diagonal, position(d) - origin);
    const double area = length(sum) / 2;
    if (!(area > 0)) findings_.add({mesh_.face[i], "an element has no area", origin});
    return area;
  }

  void noteInside(std::size_t i) {
    int others = 0;
    for (const VertexId v : mesh_.elements[i].vertices()) {
      if (v.value < firstInside_) {
        ++others;
        continue;
      }
      Range& inside = insides_.back();
      inside.low = std::min(inside.low, v.value);
      inside.high = std::max(inside.high, v.value);
    }
    if (others > 1) atSegments_.push_back(i);
  }

  const ModelMesh& mesh_;
  const MergedPatches patches_;
  Findings& findings_;
  std::uint32_t firstInside_ = 0;        ///< from here on none is on a segment
  std::vector<std::size_t> unsound_;     ///< with wrong corners
  std::vector<std::size_t> atSegments_;  ///< with two corners before firstInside_
  std::vector<Range> insides_;           ///< of each run of elements of one face
  std::map<int, double> areas_;          ///< by face; of those meshed together by the first
};

/// Some vertices of a mesh, in a row.
struct VertexRange {
  std::size_t begin, end;
  bool contains(std::size_t v) const { return v >= begin && v < end; }
};

/// Whether the elements at each of some vertices enclose it: then the sides that end there are
/// correct, if the elements belong to one face.
bool areSurrounded(const ModelMesh& mesh, VertexRange vertices) {
  VertexStars stars(vertices.begin, vertices.end);
  for (const Element& element : mesh.elements) stars.add(element);
  stars.finish();
  for (std::size_t v = vertices.begin; v < vertices.end; ++v)
    if (!stars.isEmpty(v) && !stars.areAround(v)) return false;
  return true;
}

/// Looks at the edges whose lower vertex is one of some.
class EdgeChecker {
 public:
  /// Data that all parts of the check use.
  struct Task {
    const ModelMesh& mesh;
    const std::vector<WantedUses>& wanted;
    std::vector<std::size_t> elements;  ///< whose edges are to be looked at
    std::uint32_t last;                 ///< edges that end at a vertex from here on are not
  };

  EdgeChecker(const Task& task, Findings findings)
      : mesh_(task.mesh), task_(task), findings_(std::move(findings)) {}

  Findings check(VertexRange range) {
    const auto [begin, end] = range;
    const MeshSides sides(mesh_, task_.elements, [&](std::uint32_t low, std::uint32_t high) {
      return range.contains(low) && high < task_.last;
    });
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
  int faceOf(const MeshSide& side) const { return patches_.of(mesh_.face[side.element()]); }

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

  const ModelMesh& mesh_;
  const MergedPatches patches_{mesh_};
  const Task& task_;
  Findings findings_;
};

/// Sides and stars take more memory than the mesh: those of a large one are looked at in parts.
std::vector<VertexRange> partsOf(VertexRange vertices) {
  std::vector<VertexRange> parts;
  for (std::size_t v = vertices.begin; v < vertices.end; v += VertexStars::kMaxAtOnce)
    parts.push_back({v, std::min(v + VertexStars::kMaxAtOnce, vertices.end)});
  return parts;
}

/// Where all vertices inside faces are surrounded, only edges between others may be wrong.
void checkEdges(const ModelMesh& mesh, const ElementChecker& elements, int threads,
                Findings& findings) {
  const std::size_t count = mesh.vertices.size();
  const std::vector<WantedUses> wanted = wantedUses(mesh);
  const std::optional<std::uint32_t> firstInside = elements.firstInside();
  bool isSoundInside = firstInside.has_value();
  if (firstInside) {
    const std::vector<VertexRange> parts = partsOf({*firstInside, count});
    std::vector<std::uint8_t> isSound(parts.size());
    forEachInParallel(parts.size(), threads,
                      [&](std::size_t i) { isSound[i] = areSurrounded(mesh, parts[i]); });
    isSoundInside = std::ranges::all_of(isSound, std::identity());
  }
  const std::uint32_t last = isSoundInside ? *firstInside : 0xffffffffu;
  const EdgeChecker::Task task{mesh, wanted,
                               isSoundInside ? elements.atSegments() : elements.sound(), last};
  const std::vector<VertexRange> parts = partsOf({0, std::min<std::size_t>(count, last)});
  std::vector<Findings> found(parts.size(), findings.none());
  forEachInParallel(parts.size(), threads,
                    [&](std::size_t i) { found[i] = EdgeChecker(task, found[i]).check(parts[i]); });
  for (Findings& some : found) findings.take(std::move(some));
}

}  // namespace

bool isWrongArea(double ratio, std::size_t elements) {
  constexpr std::size_t kFew = 60;
  constexpr double kMaxFactor = 1.4, kMaxFactorOfFew = 5;
  const double most = elements < kFew ? kMaxFactorOfFew : kMaxFactor;
  return ratio < 1 / most || ratio > most;
}

std::vector<MeshFinding> checkModelMesh(const ModelMesh& mesh, std::size_t limit, int threads) {
  Findings findings(limit);
  ElementChecker elements(mesh, findings);
  elements.checkElements();
  checkEdges(mesh, elements, threads, findings);
  elements.checkAreas();
  return findings.result();
}

}  // namespace af2::geometry
