#include "geometry/check/drawn_part.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "engine/base/elementary.h"
#include "geometry/base/plane_axes.h"
#include "geometry/check/boundary_crossings.h"

namespace af2::geometry {

namespace {

/// A side of an element, along which it runs.
struct DrawnSide {
  std::uint32_t from, to;
  auto operator<=>(const DrawnSide&) const = default;
};

/// Sides that have been met in one direction only, by hash.
class LoneSides {
 public:
  /// sides  of all elements: as most are met twice, the slots are half empty
  explicit LoneSides(std::size_t sides) : slots_(std::bit_ceil(sides + 1), kEmpty) {}

  /// False: it has been met in this direction before.
  bool meet(DrawnSide side) {
    const auto [low, high] = std::minmax(side.from, side.to);
    const std::uint64_t key = std::uint64_t{low} << 32 | high;
    const std::uint64_t direction = side.from == low ? kForward : kBackward;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash(key) & mask;; i = (i + 1) & mask) {
      std::uint64_t& slot = slots_[i];
      if (slot == kEmpty) slot = key;
      if ((slot & ~(kForward | kBackward)) != key) continue;
      if (slot & direction) return false;
      slot |= direction;
      return true;
    }
  }

  /// In order.
  std::vector<DrawnSide> all() const {
    std::vector<DrawnSide> sides;
    for (const std::uint64_t slot : slots_) {
      if (slot == kEmpty || ((slot & kForward) && (slot & kBackward))) continue;
      const auto low = static_cast<std::uint32_t>(slot >> 32 & 0x7fffffffu);
      const auto high = static_cast<std::uint32_t>(slot & 0x7fffffffu);
      sides.push_back(slot & kForward ? DrawnSide{low, high} : DrawnSide{high, low});
    }
    std::ranges::sort(sides);
    return sides;
  }

 private:
  // Vertices have numbers below 2^31.
  static constexpr std::uint64_t kForward = std::uint64_t{1} << 63;
  static constexpr std::uint64_t kBackward = std::uint64_t{1} << 31;
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};

  static std::size_t hash(std::uint64_t key) {
    key *= 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(key ^ key >> 32);
  }

  std::vector<std::uint64_t> slots_;
};

std::optional<std::vector<DrawnSide>> outlineOf(const MeshPart& part) {
  std::size_t sides = 0;
  for (std::size_t i = 0; i < part.count; ++i) sides += part.corners(i).size();
  LoneSides lone(sides);
  for (std::size_t i = 0; i < part.count; ++i) {
    const auto corners = part.corners(i);
    std::uint32_t from = corners.back().value;
    for (const VertexId corner : corners) {
      if (!lone.meet({from, corner.value})) return std::nullopt;
      from = corner.value;
    }
  }
  return lone.all();
}

/// An outline in its plane.
class DrawnOutline {
 public:
  DrawnOutline(const MeshPart& part, std::vector<DrawnSide> sides, const Point3& normal)
      : mesh_(part.mesh),
        sides_(std::move(sides)),
        axes_(mesh_.vertices[sides_.front().from], normal) {}

  bool isSimple() const {
    return touchesInTurn() && traceLoops() &&
           crossingsOf(
               loops_, [&](const SurfacePoint& p) { return axes_(p); }, 1)
               .empty() &&
           std::ranges::all_of(steepest_,
                               [&](const DrawnSide& side) { return isEmptyRightOf(side); });
  }

 private:
  Point2 at(std::uint32_t vertex) const {
    return axes_({.position = mesh_.vertices[vertex], .normal = {}});
  }
  std::span<const DrawnSide> from(std::uint32_t vertex) const {
    const auto [first, last] = std::ranges::equal_range(sides_, vertex, {}, &DrawnSide::from);
    return {first, last};
  }

  /// Where the outline visits a vertex more than once, incoming and outgoing sides must alternate
  /// around it: then the parts of the mesh that meet there do not overlap.
  bool touchesInTurn() const {
    std::vector<DrawnSide> touching;
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (from(sides_[i].from).size() > 1) touching.push_back(sides_[i]);
    if (touching.empty()) return true;
    struct Way {
      std::uint32_t vertex;
      double angle;
      bool isOut;
    };
    std::vector<Way> ways;
    const auto add = [&](std::uint32_t vertex, std::uint32_t other, bool isOut) {
      const Point2 d = at(other) - at(vertex);
      ways.push_back({vertex, angleOf(d), isOut});
    };
    for (const DrawnSide& side : touching) add(side.from, side.to, true);
    for (const DrawnSide& side : sides_)
      if (from(side.to).size() > 1) add(side.to, side.from, false);
    std::ranges::sort(ways, [](const Way& a, const Way& b) {
      return a.vertex != b.vertex ? a.vertex < b.vertex : a.angle < b.angle;
    });
    for (std::size_t i = 0, last = 0; i < ways.size(); i = last) {
      for (last = i; last < ways.size() && ways[last].vertex == ways[i].vertex;) ++last;
      for (std::size_t k = i; k < last; ++k)
        if (ways[k].isOut == ways[k + 1 < last ? k + 1 : i].isOut) return false;
    }
    return true;
  }

  /// Fills loops_ and steepest_; false: the sides make no loops.
  bool traceLoops() const {
    std::vector<bool> isUsed(sides_.size(), false);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (isUsed[i]) continue;
      auto& loop = loops_.loops.emplace_back();
      DrawnSide steepest = sides_[i];
      for (std::size_t k = i;;) {
        isUsed[k] = true;
        loop.push_back(
            {VertexId(sides_[k].from), {.position = mesh_.vertices[sides_[k].from], .normal = {}}});
        if (rise(sides_[k]) > rise(steepest)) steepest = sides_[k];
        if (sides_[k].to == sides_[i].from) break;
        const auto ways = from(sides_[k].to);
        const auto next = std::ranges::find_if(ways, [&](const DrawnSide& side) {
          return !isUsed[static_cast<std::size_t>(&side - sides_.data())];
        });
        if (next == ways.end()) return false;
        k = static_cast<std::size_t>(&*next - sides_.data());
      }
      steepest_.push_back(steepest);
    }
    return true;
  }

  double rise(const DrawnSide& side) const { return std::abs(at(side.to).y - at(side.from).y); }

  /// How often the part lies above the plane just right of a side: as often as the outline goes
  /// around there.
  bool isEmptyRightOf(const DrawnSide& side) const {
    const Point2 middle = 0.5 * (at(side.from) + at(side.to));
    int around = 0;
    for (const auto& loop : loops_.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const BoundaryCorner &a = loop[i], &b = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (a.vertex.value == side.from && b.vertex.value == side.to) continue;
        const Point2 p = axes_(a.point), q = axes_(b.point);
        if ((p.y > middle.y) == (q.y > middle.y)) continue;
        if (middle.x < p.x + (middle.y - p.y) / (q.y - p.y) * (q.x - p.x))
          around += q.y > p.y ? 1 : -1;
      }
    }
    // To the right of a side that runs down, the side itself is still ahead.
    return around - (at(side.to).y < at(side.from).y) == 0;
  }

  const ModelMesh& mesh_;
  std::vector<DrawnSide> sides_;
  PlaneAxes axes_;
  mutable FrontInput loops_;
  mutable std::vector<DrawnSide> steepest_;  ///< of each loop
};

}  // namespace

bool allFace(const MeshPart& part, const Point3& plane) {
  bool isCommon = true;
  for (std::size_t i = 0; i < part.count && isCommon; ++i)
    part.forEachNormal(i, [&](const Point3& normal) {
      const double facing = dot(normal, plane);
      isCommon =
          isCommon && facing > 0 && facing * facing > kMinFacing * kMinFacing * dot(normal, normal);
    });
  return isCommon;
}

bool canBeDrawn(const MeshPart& part) {
  Point3 sum;
  for (std::size_t i = 0; i < part.count; ++i)
    part.forEachNormal(i, [&](const Point3& normal) { sum = sum + normal; });
  const Point3 normal = unit(sum);
  if (!allFace(part, normal)) return false;
  std::optional<std::vector<DrawnSide>> outline = outlineOf(part);
  return outline && !outline->empty() && DrawnOutline(part, std::move(*outline), normal).isSimple();
}

}  // namespace af2::geometry
