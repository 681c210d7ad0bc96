#include "geometry/occ/faces/most_area.h"

#include <BRep_Tool.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace af2::geometry {
namespace {

/// The area of all of a surface, infinite for those that do not end by themselves.
double areaOfAll(const TopoDS_Face& face) {
  constexpr int kSamples = 16;
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
  surface->Bounds(u1, u2, v1, v2);
  for (const double bound : {u1, u2, v1, v2})
    if (Precision::IsInfinite(bound)) return std::numeric_limits<double>::infinity();
  const auto at = [](double low, double high, int i) {
    return low + (high - low) * (i + 0.5) / kSamples;
  };
  double sum = 0;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      gp_Pnt place;
      gp_Vec du, dv;
      surface->D1(at(u1, u2, i), at(v1, v2, j), place, du, dv);
      sum += du.Crossed(dv).Magnitude();
    }
  return sum / (kSamples * kSamples) * (u2 - u1) * (v2 - v1);
}

double farthest(const FrontInput& boundary) {
  const Point3& origin = boundary.loops[0][0].point.position;
  double extent = 0;
  for (const auto& loop : boundary.loops)
    for (const BoundaryCorner& corner : loop)
      extent = std::max(extent, distance(corner.point.position, origin));
  return extent;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double width() const { return high - low; }
  double at(double share) const { return low + share * width(); }
};

/// The area of the part of a surface within the bounds of the boundary in the parameters.
double areaAround(const FaceSurface& surface, const FrontInput& boundary) {
  constexpr int kSamples = 8;
  Range u, v;
  for (const auto& loop : boundary.loops)
    for (const BoundaryCorner& corner : loop) {
      u.add(corner.point.u);
      v.add(corner.point.v);
    }
  double sum = 0;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const SurfaceFrame frame =
          surface.inParameters()->frameAt(u.at((i + 0.5) / kSamples), v.at((j + 0.5) / kSamples));
      sum += length(cross(frame.du, frame.dv));
    }
  return sum / (kSamples * kSamples) * u.width() * v.width();
}

}  // namespace

double mostArea(const TopoDS_Face& face, const FaceSurface& surface, const FrontInput& boundary) {
  const double all = areaOfAll(face);
  const bool isEndless = std::isinf(all);
  const double extent = std::max(farthest(boundary), isEndless ? 0.0 : surface.extent());
  const double sphere = std::numbers::pi * extent * extent;
  if (!isEndless) return std::min(sphere, all);
  return surface.isPlane() ? sphere : std::min(sphere, areaAround(surface, boundary));
}

}  // namespace af2::geometry
