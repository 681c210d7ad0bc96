#include "geometry/check/patch_outline.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include "engine/base/parallel.h"
#include "geometry/base/plane_axes.h"
#include "geometry/check/boundary_crossings.h"
#include "geometry/check/drawn_part.h"
#include "geometry/check/star_shape.h"

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

/// Elements that are looked at together; a multiple of OutlinedPatch::kRun.
constexpr std::size_t kAtOnce = 1 << 15;

auto positionIn(const ModelMesh& mesh) {
  return [&mesh](VertexId v) -> const Point3& { return mesh.vertices[v.value]; };
}

}  // namespace

bool areClosed(std::vector<OutlinedPatch::Side> sides) {
  std::sort(sides.begin(), sides.end());
  return std::ranges::all_of(sides, [&](const OutlinedPatch::Side& side) {
    return std::ranges::binary_search(sides, OutlinedPatch::Side(side.second, side.first));
  });
}

PatchOutlines::PatchOutlines(const ModelMesh& mesh, const Repeat& repeat)
    : mesh_(mesh), repeat_(repeat), isOnSegment_(mesh.vertices.size(), 0) {
  for (const EdgeSegment& segment : mesh.segments) {
    isOnSegment_[segment.from.value] = isOnSegment_[segment.to.value] = 1;
    segments_.push_back(std::minmax(segment.from.value, segment.to.value));
  }
  std::sort(segments_.begin(), segments_.end());
}

bool PatchOutlines::isSegment(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(segments_.begin(), segments_.end(), Side(std::minmax(a, b)));
}

OutlinedPatch PatchOutlines::patch(std::size_t first, std::size_t last) const {
  const Ranges ranges(last - first, kAtOnce);
  std::vector<OutlinedPatch> parts(ranges.count());
  repeat_(parts.size(), [&](std::size_t i) {
    const auto elements = ranges[i];
    parts[i] = partOf(first + elements.front(), first + elements.back() + 1);
  });
  OutlinedPatch patch{first, last, {}, {}, {}, {}, {}, {}};
  for (const OutlinedPatch& part : parts) {
    patch.box.add(part.box);
    std::ranges::copy(part.boxes, std::back_inserter(patch.boxes));
    patch.normal = patch.normal + part.normal;
    patch.corners = patch.corners + part.corners;
    std::ranges::copy(part.sides, std::back_inserter(patch.sides));
    std::ranges::copy(part.onSegments, std::back_inserter(patch.onSegments));
  }
  std::sort(patch.sides.begin(), patch.sides.end());
  return patch;
}

OutlinedPatch PatchOutlines::partOf(std::size_t first, std::size_t last) const {
  OutlinedPatch part{first, last, {}, {}, {}, {}, {}, {}};
  for (std::size_t begin = first; begin < last; begin += OutlinedPatch::kRun)
    addRun(begin, std::min(begin + OutlinedPatch::kRun, last), part);
  return part;
}

void PatchOutlines::addRun(std::size_t begin, std::size_t end, OutlinedPatch& patch) const {
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
void PatchOutlines::addAtSegments(std::span<const VertexId> corners, OutlinedPatch& patch) const {
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

bool PatchOutlines::canBeDrawn(const OutlinedPatch& patch) const {
  const Point3 normal = unit(patch.normal);
  if (!allFace(patch, normal)) return false;
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

bool PatchOutlines::allFace(const OutlinedPatch& patch, const Point3& normal) const {
  const Ranges ranges(patch.last - patch.first, kAtOnce);
  std::atomic<bool> doAll = true;
  repeat_(ranges.count(), [&](std::size_t i) {
    const auto elements = ranges[i];
    if (doAll &&
        !geometry::allFace({mesh_, patch.first + elements.front(), elements.size()}, normal))
      doAll = false;
  });
  return doAll;
}

bool PatchOutlines::allAreIn(StarShape& star, const OutlinedPatch& patch) const {
  const Ranges ranges(patch.last - patch.first, kAtOnce);
  std::vector<StarShape> parts(ranges.count(), star.forOthers());
  std::atomic<bool> areAll = true;
  repeat_(parts.size(), [&](std::size_t i) {
    for (const std::size_t e : ranges[i]) {
      if (!areAll) return;
      if (!parts[i].takes(mesh_.elements[patch.first + e], positionIn(mesh_))) areAll = false;
    }
  });
  for (const StarShape& part : parts) star.add(part);
  return areAll;
}

bool PatchOutlines::isStarShaped(std::span<const OutlinedPatch* const> patches) const {
  Point3 sum;
  std::size_t count = 0;
  for (const OutlinedPatch* patch : patches) {
    count += patch->last - patch->first;
    sum = sum + patch->corners;
  }
  const Point3 centre = (1 / static_cast<double>(count)) * sum;
  // A quick test: one element of each face is enough to reject most models that are not
  // star-shaped.
  StarShape sample(centre);
  for (const OutlinedPatch* patch : patches)
    if (!sample.takes(mesh_.elements[patch->first], positionIn(mesh_))) return false;
  StarShape star = sample.forOthers();
  for (const OutlinedPatch* patch : patches)
    if (!allAreIn(star, *patch)) return false;
  if (!star.goesAroundOnce()) return false;
  std::vector<Side> sides;
  for (const OutlinedPatch* patch : patches)
    sides.insert(sides.end(), patch->sides.begin(), patch->sides.end());
  return areClosed(std::move(sides));
}

}  // namespace af2::geometry
