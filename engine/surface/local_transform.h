// Charts: a chart is a 2-D map of the surface in which one step of the advance takes place.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2 {

/// Whether a front vertex can be matched in a step, and whether it blocks new elements.
enum class ChartView {
  Legal = 0,  ///< can be matched, and blocks new elements
  Obstacle,   ///< its image in the chart is too distorted to match, but it blocks
  Hidden,     ///< belongs to another sheet of the surface: neither matched nor blocking
};

struct ChartPoint {
  Point2 position;
  ChartView view = ChartView::Legal;
};

/// The fast form of mapping to a chart: orthogonal or central projection onto a plane.
///
/// x = scale * (p - origin).xAxis, y likewise. A point whose normal makes a cosine with `normal` of
/// less than `minCosine` is an Obstacle, of less than `hiddenCosine` Hidden; so is a point farther
/// than `maxHeight` (model units) from the plane.
struct ProjectionFrame {
  Point3 origin, xAxis, yAxis, normal;
  double scale = 1;
  double minCosine = -2, hiddenCosine = -2;  ///< -2: normals are not tested (plane surfaces)
  double maxHeight = 1e300;
  /// Not 0: a central projection, whose centre lies 1 / perspective below the plane (above it, if
  /// negative) at `centreX` on the chart's x axis. All points are Legal then; the surface bends
  /// towards the centre, and elsewhere rises at most `maxHeight` above the plane.
  double perspective = 0, centreX = 0;
  /// Not 0: lengths in the plane vary. As complex numbers, p = (x, y) is mapped to p (1 - bend L) /
  /// (1 - bend p), where (L, 0) is the end of the base edge; `kept` is 1 - bend L. This map
  /// preserves angles, circles and the base edge; `bend` controls how lengths vary around the base.
  Point2 bend{0, 0}, kept{1, 0};

  ChartPoint project(const SurfacePoint& point) const {
    const Point3 d = point.position - origin;
    const Point2 position{scale * dot(d, xAxis), scale * dot(d, yAxis)};
    if (perspective != 0) return {fromCentre(position, d), ChartView::Legal};
    if (bend != Point2{0, 0}) return bent(position);
    return {position, minCosine <= -2 ? ChartView::Legal : viewOf(point, d)};
  }
  /// For surfaces whose normals are tested; d = point.position - origin.
  ChartView viewOf(const SurfacePoint& point, const Point3& d) const {
    const double cosine = dot(point.normal, normal);
    const bool isHidden = (cosine < hiddenCosine) | (std::abs(dot(d, normal)) > maxHeight);
    const int view = isHidden ? 2 : cosine < minCosine ? 1 : 0;
    return static_cast<ChartView>(view);
  }
  /// Far away, where the map would fold over, the point stays outside and still blocks.
  ChartPoint bent(Point2 p) const {
    constexpr double kMin = 0.25;
    const Point2 divisor{1 - (bend.x * p.x - bend.y * p.y), -(bend.x * p.y + bend.y * p.x)};
    if (divisor.x < kMin) return {(1 / kMin) * p, ChartView::Obstacle};
    const Point2 q{kept.x * p.x - kept.y * p.y, kept.x * p.y + kept.y * p.x};
    const double scaled = 1 / dot(divisor, divisor);
    return {{scaled * dot(q, divisor), scaled * cross(divisor, q)}, ChartView::Legal};
  }
  /// The inverse map.
  Point2 straightened(Point2 z) const {
    const Point2 divisor{kept.x + bend.x * z.x - bend.y * z.y,
                         kept.y + bend.x * z.y + bend.y * z.x};
    const double scaled = 1 / dot(divisor, divisor);
    return {scaled * dot(z, divisor), scaled * cross(divisor, z)};
  }

 private:
  Point2 fromCentre(Point2 p, const Point3& d) const {
    const double stretch = 1 / (1 + perspective * dot(d, normal));
    return {centreX + stretch * (p.x - centreX), stretch * p.y};
  }
};

/// A chart around one base edge. Source: [VanderZee16], local transforms.
class AF2_EXPORT AF2LocalTransform {
 public:
  virtual ~AF2LocalTransform() = default;
  virtual ChartPoint transformFromSurface(const SurfacePoint& point) const = 0;
  /// No value where the surface cannot be reached from this point of the chart.
  virtual std::optional<SurfacePoint> transformToSurface(Point2 point) const = 0;
  /// Not null: transformFromSurface is this projection, and the engine evaluates it itself in
  /// batches.
  virtual const ProjectionFrame* projection() const { return nullptr; }
};

/// Storage for one chart at a time, so that a step of the advance need not allocate.
class ChartSlot {
 public:
  ChartSlot() = default;
  ChartSlot(const ChartSlot&) = delete;
  ChartSlot& operator=(const ChartSlot&) = delete;
  ~ChartSlot() { clear(); }

  /// Holds the chart that `make` returns, constructed in place: it is not moved.
  template <class Make>
  const AF2LocalTransform& fill(const Make& make) {
    using Chart = decltype(make());
    static_assert(sizeof(Chart) <= kSize && alignof(Chart) <= alignof(std::max_align_t));
    clear();
    inPlace_ = ::new (static_cast<void*>(room_)) Chart(make());
    return *inPlace_;
  }

  const AF2LocalTransform& hold(std::unique_ptr<AF2LocalTransform> chart) {
    clear();
    held_ = std::move(chart);
    return *held_;
  }

 private:
  static constexpr std::size_t kSize = 512;

  void clear() {
    if (inPlace_) inPlace_->~AF2LocalTransform();
    inPlace_ = nullptr;
    held_.reset();
  }

  alignas(std::max_align_t) std::byte room_[kSize];
  AF2LocalTransform* inPlace_ = nullptr;
  std::unique_ptr<AF2LocalTransform> held_;
};

/// Makes the chart for one step of the advance. This is the only thing that the engine asks of a
/// surface. Derive from this class to mesh a new kind of surface.
///
/// The engine calls one maker from one thread only.
class AF2_EXPORT AF2LocalTransformMaker {
 public:
  virtual ~AF2LocalTransformMaker() = default;

  /// Returns a chart with `from` at (0, 0) and `to` on the positive x axis.
  ///
  /// from, to    ends of the base edge, distinct; the unmeshed region lies to the left of
  ///             from -> to, seen from the side to which the normals point
  /// edgeLength  the length, in model units, that becomes 1 in the chart; > 0
  ///
  /// Throws GeometryError if there is no chart here, e.g. no normal at `from` or at `to`.
  virtual std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                                const SurfacePoint& to,
                                                                double edgeLength) const = 0;

  /// The same chart, made in `slot`. Override it together with the above to avoid the allocation.
  virtual const AF2LocalTransform& makeLocalTransformIn(ChartSlot& slot, const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double edgeLength) const {
    return slot.hold(makeLocalTransform(from, to, edgeLength));
  }
};

/// A maker that allocates nothing in a step. Derive as `class Maker : public ChartMaker<Maker>`,
/// with
///   Chart chart(const SurfacePoint& from, const SurfacePoint& to, double edgeLength) const;
/// which returns a chart of any class, with the meaning that makeLocalTransform has.
template <class Derived>
class ChartMaker : public AF2LocalTransformMaker {
 public:
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double edgeLength) const final {
    using Chart = decltype(derived().chart(from, to, edgeLength));
    return std::unique_ptr<AF2LocalTransform>(new Chart(derived().chart(from, to, edgeLength)));
  }
  const AF2LocalTransform& makeLocalTransformIn(ChartSlot& slot, const SurfacePoint& from,
                                                const SurfacePoint& to,
                                                double edgeLength) const final {
    return slot.fill([&] { return derived().chart(from, to, edgeLength); });
  }

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace af2
