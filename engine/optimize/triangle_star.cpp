#include "engine/optimize/triangle_star.h"

#include <algorithm>
#include <cmath>

#include "engine/base/pair.h"
#include "engine/mesh/element_shape.h"
#include "engine/optimize/vertex_step.h"
#include "engine/step/chart_drawing.h"

namespace af2 {
namespace {

Pair both(double number) { return Pair{number, number}; }
double sum(Pair pair) { return pair[0] + pair[1]; }

/// A vector for each of two triangles.
struct Vectors {
  Pair x, y, z;
};
Vectors both(const Point3& p, const Point3& q) {
  return {Pair{p.x, q.x}, Pair{p.y, q.y}, Pair{p.z, q.z}};
}
Vectors operator-(const Vectors& p, const Vectors& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Pair dot(const Vectors& p, const Vectors& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Vectors cross(const Vectors& p, const Vectors& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// Two triangles with a corner at the origin. The distortion of one with this corner at x is a
/// fixed multiple of (2 |x|^2 - 2 sum.x + fixed) / (a.x + area); the denominator is twice its area.
struct Triangles {
  Pair sumX, sumY, fixed, ax, ay, area;

  /// a, b, c  their other corners, the second of which both have
  Triangles(Pair a, Pair b, Pair c) {
    const Pair px{a[0], b[0]}, py{a[1], b[1]}, qx{b[0], c[0]}, qy{b[1], c[1]};
    sumX = px + qx;
    sumY = py + qy;
    fixed = both(2) * (px * px + py * py + qx * qx + qy * qy - px * qx - py * qy);
    ax = py - qy;
    ay = qx - px;
    area = px * qy - py * qx;
  }
};

/// 1 for each of two triangles, the first of which is the i-th, but 0 behind the last one.
Pair weightAt(std::size_t i, std::size_t count) { return Pair{1, i + 1 < count ? 1. : 0.}; }

/// leansLittle for two triangles.
bool leanLittle(const Vectors& turned, Pair squared, const Vectors& normals) {
  const Pair cosine = dot(turned, normals);
  return bothHold(cosine > Pair{}) &
         bothHold(cosine * cosine > both(kMinNormalCosine * kMinNormalCosine) * squared);
}

}  // namespace

bool TriangleStar::draw(const SurfacePoint& here, std::span<const SurfacePoint* const> ring,
                        const StepChart& chart) {
  ring_ = ring;
  bool isSeen = false;
  withDrawing(chart, [&](const auto& drawing) { isSeen = draw(here, chart, drawing); });
  return isSeen;
}

template <class Drawing>
bool TriangleStar::draw(const SurfacePoint& here, const StepChart& chart, const Drawing& drawing) {
  const double squaredUnit = chart.unit() * chart.unit();
  const bool isPlane = chart.isPlane();
  double shortest = INFINITY;  // squared
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Drawn drawn = drawing(*ring_[i]);
    if (drawn.view == ChartView::Hidden) return false;
    Pair at = drawn.position;
    if (!isPlane) {
      const Point3 edge = ring_[i]->position - here.position;
      at *= both(stretchOf(af2::dot(edge, edge), squaredUnit * sum(at * at)));
    }
    shortest = std::min(shortest, sum(at * at));
    drawn_[i] = at;
  }
  reach_ = std::sqrt(shortest);
  drawn_[ring_.size()] = drawn_[0];
  drawn_[ring_.size() + 1] = drawn_[1];
  return true;
}

Point2 TriangleStar::improvedPosition(double relaxation) const {
  Pair value{}, x{}, y{}, xx{}, xy{}, yy{};
  for (std::size_t i = 0; i < ring_.size(); i += 2) {
    const Triangles t(drawn_[i], drawn_[i + 1], drawn_[i + 2]);
    if (!bothHold(t.area > Pair{})) return {};
    const Pair weight = weightAt(i, ring_.size()), inverse = both(1) / t.area;
    const Pair ratio = t.fixed * inverse;
    const Pair gx = (both(-2) * t.sumX - ratio * t.ax) * inverse;
    const Pair gy = (both(-2) * t.sumY - ratio * t.ay) * inverse;
    const Pair weighted = weight * ratio, bent = weighted * inverse;
    value += weighted * ratio;
    x += weighted * gx;
    y += weighted * gy;
    xx += weight * gx * gx + bent * (both(4) - both(2) * gx * t.ax);
    xy += weight * gx * gy - bent * (gx * t.ay + gy * t.ax);
    yy += weight * gy * gy + bent * (both(4) - both(2) * gy * t.ay);
  }
  // All derivatives are halves.
  const Energy energy{sum(value), {sum(x), sum(y)}, sum(xx), sum(xy), sum(yy)};
  const Point2 step = newtonStep(energy, reach_, relaxation);
  return descent(step, energy.value, [&](Point2 at) { return energyAt(at); }).step;
}

double TriangleStar::energyAt(Point2 at) const {
  const Pair x = both(2 * at.x), y = both(2 * at.y), squared = both(2 * af2::dot(at, at));
  Pair energy{};
  for (std::size_t i = 0; i < ring_.size(); i += 2) {
    const Triangles t(drawn_[i], drawn_[i + 1], drawn_[i + 2]);
    const Pair area = t.ax * both(at.x) + t.ay * both(at.y) + t.area;
    if (!bothHold(area > Pair{})) return INFINITY;
    const Pair ratio = (squared - x * t.sumX - y * t.sumY + t.fixed) / area;
    energy += weightAt(i, ring_.size()) * ratio * ratio;
  }
  return sum(energy);
}

bool TriangleStar::isPlainlyBelow(double limit, const SurfacePoint& here) const {
  const auto vertex = [&](std::size_t i) -> const SurfacePoint& {
    return *ring_[i < ring_.size() ? i : i - ring_.size()];
  };
  const Vectors at = both(here.position, here.position), own = both(here.normal, here.normal);
  for (std::size_t i = 0; i < ring_.size(); i += 2) {
    const SurfacePoint &a = vertex(i), &b = vertex(i + 1), &c = vertex(i + 2);
    const Vectors p = both(a.position, b.position) - at, q = both(b.position, c.position) - at;
    const Vectors turned = cross(p, q);
    const Pair squared = dot(turned, turned);
    if (!(leanLittle(turned, squared, own) & leanLittle(turned, squared, both(a.normal, b.normal)) &
          leanLittle(turned, squared, both(b.normal, c.normal))))
      return false;
    const Pair squares = both(2) * (dot(p, p) + dot(q, q) - dot(p, q));
    if (!bothHold(squares * squares < both(plainLimit(limit)) * squared)) return false;
  }
  return true;
}

}  // namespace af2
