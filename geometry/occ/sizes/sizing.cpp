#include "geometry/occ/sizes/sizing.h"

#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"

namespace af2::geometry {

namespace {

/// A tube must not be cut off by a few large elements, however large the wanted size: with fewer
/// than five or so around it a front has no room. But a long thin one, a wire, shall not be cut
/// into too many.
double leastOnTube(const CadSizes& sizes, double size, const FaceSurface& surface, double radius) {
  constexpr double kShareOfBentFace = 1.0 / 15;
  constexpr double kMaxElements = 1e5;
  constexpr double kElements = 14.5;  // on a tube with edges of length 1, over length * radius
  constexpr double kMaxAlong = 2e4, kMinSize = 1e-4;  // where a spline has no radius at all
  const double extent = surface.extent();
  const double many = std::max(
      {std::sqrt(kElements * radius * extent / kMaxElements), extent / kMaxAlong, kMinSize * size});
  return std::min({sizes.bentFaceLeast * size, kShareOfBentFace * extent, many});
}

/// Whether a face turns in a crease that is far narrower than itself, so that it is not a tube. No
/// price would be too high to follow that, and elements that turn by a right angle follow nothing.
/// However many elements a turn is to have, a whole turn is 6.3 radii broad: no crease.
bool isCreased(double size, const FaceSurface& surface) {
  constexpr double kShareOfSize = 0.0413, kShareOfBreadth = 1.0 / 7.26;
  return surface.creaseRadius() <
         std::min(kShareOfSize * size, kShareOfBreadth * surface.breadth());
}

}  // namespace

CurvedSize curvedSizeAt(const CadSizes& sizes, int face, double size, const FaceSurface& surface,
                        const SurfacePoint& point) {
  constexpr double kVisible = 0.05;  // turn of an edge, in those that it may have
  const FaceSurface::Radii radii = surface.radiiAt(point, size);
  const double bend = std::min(1.0, size / (kVisible * sizes.faceTurn * radii.smallest));
  const double share = 1 - (1 - sizes.curvedShare) * bend;
  const double gentle =
      std::min(size, std::max(sizes.faceTurn * radii.smallest, sizes.faceLeast * size));
  if (sizes.roughFaces.contains(face) || isCreased(size, surface)) return {gentle, share};
  const double least = leastOnTube(sizes, size, surface, radii.bent);
  return {std::min(gentle, std::max(sizes.faceTurn * radii.bent, least)), share};
}

double limitByCurvature(const CadSizes& sizes, int face, double size, const FaceSurface& surface,
                        const SurfacePoint& point) {
  return curvedSizeAt(sizes, face, size, surface, point).limit;
}

double expectedElements(const CadSizes& sizes, int face, const FaceSurface& surface, double area,
                        int samples) {
  const double wanted = wantedOnFace(sizes, face);
  const auto density = [&](double size) { return 1 / (kUnitTriangle * size * size); };
  constexpr int kFewSamples = 4;
  const bool byPosition = samples > 0;
  if (surface.isPlane() && !byPosition) return area * density(wanted);
  if (!byPosition) samples = kFewSamples;
  const SplineSurface::Box& box = surface.box();
  double sum = 0, weights = 0;
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const double u = box.u1 + (i + 0.5) / samples * (box.u2 - box.u1);
      const double v = box.v1 + (j + 0.5) / samples * (box.v2 - box.v1);
      const SurfaceFrame frame = surface.inOccParameters().frameAt(u, v);
      const double weight = length(cross(frame.du, frame.dv));
      weights += weight;
      const double size = surface.isPlane() ? wanted
                                            : limitByCurvature(sizes, face, wanted, surface,
                                                               {frame.position, {}, u, v});
      sum +=
          weight *
          density(byPosition ? bounded(sizes, limitByFunction(sizes, size, frame.position)) : size);
    }
  }
  return weights > 0 ? area * sum / weights : area * density(wanted);
}

}  // namespace af2::geometry
