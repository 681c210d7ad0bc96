#include "geometry/check/patch_outline.h"

#include <algorithm>
#include <cmath>

#include "geometry/base/plane_axes.h"
#include "geometry/check/boundary_crossings.h"
#include "geometry/check/drawn_part.h"

namespace af2::geometry {

namespace {

struct DrawnLoop {
  std::vector<Point2> points;
  double area = 0;  ///< positive if it runs counter-clockwise
  Point2 low, high;
};

DrawnLoop draw(const std::vector<BoundaryCorner>& loop, const PlaneAxes& axes) {
  DrawnLoop drawn;
  for (const BoundaryCorner& corner : loop) drawn.points.push_back(axes(corner.point));
  drawn.low = drawn.high = drawn.points[0];
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    const Point2 p = drawn.points[i], q = drawn.points[(i + 1) % drawn.points.size()];
    drawn.area += cross(p - drawn.points[0], q - drawn.points[0]) / 2;
    drawn.low = {std::min(drawn.low.x, p.x), std::min(drawn.low.y, p.y)};
    drawn.high = {std::max(drawn.high.x, p.x), std::max(drawn.high.y, p.y)};
  }
  return drawn;
}

bool contains(const DrawnLoop& loop, Point2 point) {
  if (point.x < loop.low.x || point.x > loop.high.x || point.y < loop.low.y ||
      point.y > loop.high.y)
    return false;
  bool inside = false;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Point2 p = loop.points[i], q = loop.points[(i + 1) % loop.points.size()];
    if ((p.y > point.y) == (q.y > point.y)) continue;
    if (point.x < p.x + (point.y - p.y) / (q.y - p.y) * (q.x - p.x)) inside = !inside;
  }
  return inside;
}

/// For simple loops that do not cross: whether each has the region on its left, given how they are
/// nested.
bool areNestedInTurn(const FrontInput& outline, const PlaneAxes& axes) {
  std::vector<DrawnLoop> loops;
  for (const auto& loop : outline.loops) loops.push_back(draw(loop, axes));
  for (const DrawnLoop& loop : loops) {
    const auto around = std::ranges::count_if(loops, [&](const DrawnLoop& other) {
      return &other != &loop && contains(other, loop.points[0]);
    });
    if ((around % 2 == 0) != (loop.area > 0)) return false;
  }
  return true;
}

/// Triangles of a closed surface as seen from a point inside. If all of them turn the same way,
/// each direction meets as many of them as any other.
class StarShape {
 public:
  explicit StarShape(const Point3& centre) : centre_(centre) {}

  /// False: the triangle does not look the same way as those before, or too little, or it is not
  /// certain whether it is met.
  bool takes(const Point3& a, const Point3& b, const Point3& c) {
    const Point3 p = a - centre_, q = b - centre_, r = c - centre_;
    const Point3 normal = cross(b - a, c - a);
    const double facing = dot(normal, p);
    if (side_ == 0) side_ = facing > 0 ? 1 : -1;
    if (!(side_ * facing > 0) ||
        !(facing * facing > kMinFacing * kMinFacing * dot(normal, normal) * dot(p, p)))
      return false;
    return meets(p, q, r);
  }
  bool goesAroundOnce() const { return count_ == 1; }

 private:
  static constexpr Point3 kRay{0.5257, 0.6143, 0.5885};  // parallel to no usual direction
  static constexpr double kCertain = 1e-9;  // of the largest value that the terms can have

  bool meets(const Point3& p, const Point3& q, const Point3& r) {
    const double reach = kCertain * (dot(p, p) + dot(q, q) + dot(r, r));
    double least = 1e300;
    for (const Point3& edge : {cross(p, q), cross(q, r), cross(r, p)})
      least = std::min(least, side_ * dot(kRay, edge));
    count_ += least > reach;
    return std::abs(least) > reach;
  }

  Point3 centre_;
  double side_ = 0;
  int count_ = 0;
};

/// Whether each segment that elements use is used by them in both directions.
bool areClosed(std::span<const Patch* const> patches) {
  std::vector<Patch::Side> sides;
  for (const Patch* patch : patches)
    sides.insert(sides.end(), patch->sides.begin(), patch->sides.end());
  std::sort(sides.begin(), sides.end());
  return std::ranges::all_of(sides, [&](const Patch::Side& side) {
    return std::ranges::binary_search(sides, Patch::Side(side.second, side.first));
  });
}

}  // namespace

PatchOutlines::PatchOutlines(const ModelMesh& mesh)
    : mesh_(mesh), isOnSegment_(mesh.vertices.size(), 0) {
  for (const EdgeSegment& segment : mesh.segments) {
    isOnSegment_[segment.from.value] = isOnSegment_[segment.to.value] = 1;
    segments_.push_back(std::minmax(segment.from.value, segment.to.value));
  }
  std::sort(segments_.begin(), segments_.end());
}

bool PatchOutlines::isSegment(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(segments_.begin(), segments_.end(), Side(std::minmax(a, b)));
}

Patch PatchOutlines::patch(std::size_t first, std::size_t last) const {
  Patch patch{first, last, {}, {}, {}, {}, {}, {}};
  for (std::size_t begin = first; begin < last; begin += Patch::kRun)
    addRun(begin, std::min(begin + Patch::kRun, last), patch);
  std::sort(patch.sides.begin(), patch.sides.end());
  return patch;
}

void PatchOutlines::addRun(std::size_t begin, std::size_t end, Patch& patch) const {
  Box3 box;
  Point3 normals, firsts;
  for (std::size_t i = begin; i < end; ++i) {
    const auto& [a, b, c, d] = mesh_.elements[i].corners;
    const Point3 &p = mesh_.vertices[a.value], &q = mesh_.vertices[b.value],
                 &r = mesh_.vertices[c.value];
    for (const Point3* corner : {&p, &q, &r}) box.add(*corner);
    normals = normals + cross(q - p, r - p);
    firsts = firsts + p;
    int ends = isOnSegment_[a.value] + isOnSegment_[b.value] + isOnSegment_[c.value];
    if (!d.isNone()) {
      const Point3& s = mesh_.vertices[d.value];
      box.add(s);
      normals = normals + cross(r - p, s - p);
      ends += isOnSegment_[d.value];
    }
    if (ends > 0) addAtSegments(mesh_.elements[i].vertices(), patch);
  }
  patch.boxes.push_back(box);
  patch.box.add(box);
  patch.normal = patch.normal + normals;
  patch.corners = patch.corners + firsts;
}

/// Of an element with corners on segments.
void PatchOutlines::addAtSegments(std::span<const VertexId> corners, Patch& patch) const {
  std::uint32_t from = corners.back().value;
  for (const VertexId corner : corners) {
    const std::uint32_t to = corner.value;
    if (isOnSegment_[to]) patch.onSegments.push_back(to);
    if (isOnSegment_[to] && isOnSegment_[from] && isSegment(from, to))
      patch.sides.push_back({from, to});
    from = to;
  }
}

std::optional<PatchOutlines::Loops> PatchOutlines::outline(const std::vector<Side>& sides) const {
  std::vector<bool> isUsed(sides.size(), false);
  Loops loops;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    // Where a vertex stands twice, loops touch.
    if (i > 0 && sides[i].first == sides[i - 1].first) return std::nullopt;
    if (isUsed[i]) continue;
    std::vector<std::uint32_t>& loop = loops.emplace_back();
    for (std::size_t k = i; !isUsed[k];) {
      isUsed[k] = true;
      loop.push_back(sides[k].first);
      const auto next = std::ranges::lower_bound(sides, sides[k].second, {}, &Side::first);
      if (next == sides.end() || next->first != sides[k].second) return std::nullopt;
      k = static_cast<std::size_t>(next - sides.begin());
      if (isUsed[k] && k != i) return std::nullopt;
    }
  }
  return loops;
}

bool PatchOutlines::canBeDrawn(const Patch& patch) const {
  const Point3 normal = unit(patch.normal);
  if (!allFace({mesh_, patch.first, patch.last - patch.first}, normal)) return false;
  const std::optional<Loops> loops = outline(patch.sides);
  if (!loops || loops->empty()) return false;
  FrontInput boundary;
  for (const auto& loop : *loops) {
    auto& corners = boundary.loops.emplace_back();
    for (const std::uint32_t v : loop)
      corners.push_back({VertexId(v), {.position = mesh_.vertices[v], .normal = {}}});
  }
  const PlaneAxes axes(mesh_.vertices[loops->front().front()], normal);
  const auto inPlane = [&](const SurfacePoint& point) { return axes(point); };
  return crossingsOf(boundary, inPlane, 1).empty() && areNestedInTurn(boundary, axes);
}

bool PatchOutlines::isStarShaped(std::span<const Patch* const> patches) const {
  Point3 sum;
  std::size_t count = 0;
  for (const Patch* patch : patches) {
    count += patch->last - patch->first;
    sum = sum + patch->corners;
  }
  const Point3 centre = (1 / static_cast<double>(count)) * sum;
  const auto takes = [&](StarShape& star, std::size_t i) {
    const auto corners = mesh_.elements[i].vertices();
    const Point3& origin = mesh_.vertices[corners[0].value];
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      if (!star.takes(origin, mesh_.vertices[corners[k].value],
                      mesh_.vertices[corners[k + 1].value]))
        return false;
    return true;
  };
  // A quick test: one element of each face is enough to reject most models that are not
  // star-shaped.
  StarShape sample(centre), star(centre);
  for (const Patch* patch : patches)
    if (!takes(sample, patch->first)) return false;
  for (const Patch* patch : patches)
    for (std::size_t i = patch->first; i < patch->last; ++i)
      if (!takes(star, i)) return false;
  return star.goesAroundOnce() && areClosed(patches);
}

}  // namespace af2::geometry
