#include "torus.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <af2/engine/error.h>

namespace {

using af2::Point3;
using af2::SurfacePoint;

constexpr double kFullTurn = 2 * std::numbers::pi;

/// The chart around one base edge.
class TorusChart final : public af2::AF2LocalTransform {
 public:
  TorusChart(const Torus& torus, const SurfacePoint& from, const SurfacePoint& to,
             double edgeLength)
      : torus_(torus) {
    const Point3 along = af2::unit(to.position - from.position);
    const Point3 sum = from.normal + to.normal;
    plane_.origin = from.position;
    plane_.xAxis = along;
    plane_.normal = af2::unit(sum - af2::dot(sum, along) * along);
    plane_.yAxis = af2::cross(plane_.normal, along);
    plane_.scale = 1 / edgeLength;
    plane_.minCosine = 0.25;  // steeper parts block elements but are not matched
    plane_.hiddenCosine = 0;  // parts that face away are the other side of the tube
    plane_.maxHeight = 2 * edgeLength;
  }

  af2::ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    return plane_.project(point);
  }

  std::optional<SurfacePoint> transformToSurface(af2::Point2 point) const override {
    const Point3 start =
        plane_.origin + (1 / plane_.scale) * (point.x * plane_.xAxis + point.y * plane_.yAxis);
    const auto found = torus_.hit(start, plane_.normal);
    if (!found || af2::dot(found->normal, plane_.normal) < plane_.minCosine) return std::nullopt;
    return found;
  }

  /// Optional: lets the engine project many points at once.
  const af2::ProjectionFrame* projection() const override { return &plane_; }

 private:
  Torus torus_;
  af2::ProjectionFrame plane_;
};

int piecesOf(double length, double size) {
  return std::max(3, static_cast<int>(std::lround(length / size)));
}

}  // namespace

SurfacePoint Torus::at(double u, double v) const {
  const Point3 outwards{std::cos(u), std::sin(u), 0};
  const Point3 normal = std::cos(v) * outwards + std::sin(v) * Point3{0, 0, 1};
  return {ring * outwards + tube * normal, normal, u, v};
}

Point3 Torus::normalAt(const Point3& p) const {
  const Point3 outwards = af2::unit({p.x, p.y, 0});
  return af2::unit(p - ring * outwards);
}

std::optional<SurfacePoint> Torus::hit(const Point3& start, const Point3& direction) const {
  // Newton's method on the distance from the surface, along the line.
  double t = 0;
  for (int round = 0; round < 20; ++round) {
    const Point3 p = start + t * direction;
    const Point3 normal = normalAt(p);
    const double offset = af2::length(p - ring * af2::unit({p.x, p.y, 0})) - tube;
    if (std::abs(offset) < 1e-14 * ring) return SurfacePoint{p, normal};
    const double slope = af2::dot(normal, direction);
    if (std::abs(slope) < 0.05) return std::nullopt;  // the line only grazes the surface
    t -= offset / slope;
  }
  return std::nullopt;
}

std::unique_ptr<af2::AF2LocalTransform> TorusChartMaker::makeLocalTransform(
    const SurfacePoint& from, const SurfacePoint& to, double edgeLength) const {
  return std::make_unique<TorusChart>(torus_, from, to, edgeLength);
}

af2::FrontInput cutOpen(const Torus& torus, double size) {
  const int along = piecesOf(kFullTurn * (torus.ring + torus.tube), size);
  const int around = piecesOf(kFullTurn * torus.tube, size);

  // Vertices: 0 where the circles meet, then the rest of v = 0, then the rest of u = 0.
  const auto corner = [&](int i, int j) {
    const int onLong = i % along, onShort = j % around;
    const int id = onLong == 0 && onShort == 0 ? 0 : onShort == 0 ? onLong : along + onShort - 1;
    // Positions on the two sides must be bitwise equal; only u and v may differ.
    SurfacePoint point = torus.at(kFullTurn * onLong / along, kFullTurn * onShort / around);
    point.u = kFullTurn * i / along;
    point.v = kFullTurn * j / around;
    return af2::BoundaryCorner{af2::VertexId(static_cast<std::size_t>(id)), point};
  };

  std::vector<af2::BoundaryCorner> loop;
  for (int i = 0; i < along; ++i) loop.push_back(corner(i, 0));
  for (int j = 0; j < around; ++j) loop.push_back(corner(along, j));
  for (int i = along; i > 0; --i) loop.push_back(corner(i, around));
  for (int j = around; j > 0; --j) loop.push_back(corner(0, j));
  return {{loop}, {}, static_cast<std::size_t>(along + around - 1)};
}
