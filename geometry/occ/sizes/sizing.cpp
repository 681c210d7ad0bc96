#include "geometry/occ/sizes/sizing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/constants.h"
#include "geometry/base/box_tree.h"

namespace af2::geometry {

namespace {

/// The size below which a tube, or a wire, would be cut into too many elements.
double affordableOnTube(double size, const FaceSurface& surface, double radius) {
  constexpr double kMaxElements = 1e5;
  constexpr double kElements = 14.5;  // on a tube with edges of length 1, over length * radius
  constexpr double kMaxAlong = 2e4, kMinSize = 1e-4;  // where a spline has no radius at all
  const double extent = surface.extent();
  return std::max(
      {std::sqrt(kElements * radius * extent / kMaxElements), extent / kMaxAlong, kMinSize * size});
}

/// A tube must not be cut off by a few large elements, however large the wanted size: with fewer
/// than five or so around it a front has no room. But a long thin one, a wire, shall not be cut
/// into too many.
double leastOnTube(const CadSizes& sizes, double size, const FaceSurface& surface, double radius) {
  constexpr double kShareOfBentFace = 1.0 / 15;
  return std::min({sizes.bentFaceLeast * size, kShareOfBentFace * surface.extent(),
                   affordableOnTube(size, surface, radius)});
}

/// The smallest allowed size on a tube: --min-size, but never so much that fewer than four elements
/// go around it. Fewer have no room, and the tube would be lost. A face that turns sharply along a
/// line, such as the leading edge of a wing, is much longer around than its radius there says, and
/// no tube.
double leastAllowedOnTube(const CadSizes& sizes, double size, const FaceSurface& surface,
                          double radius) {
  constexpr double kFewestAround = 4;
  if (sizes.minSize == 0) return 0;
  const double around =
      std::max(2 * std::numbers::pi * radius, surface.isRound() ? 0 : surface.girth());
  return std::min(sizes.minSize,
                  std::max(around / kFewestAround, affordableOnTube(size, surface, radius)));
}

/// How far from a sharp tip the radius counts: a size away, but on the face.
double reachFromTip(double size, const FaceSurface& surface) {
  return size > surface.extent() ? surface.extent() / 2 : size;
}

/// Whether a face turns in a crease that is far narrower than itself, so that it is not a tube. No
/// price would be too high to follow that, and elements that turn by a right angle follow nothing.
/// However many elements a turn is to have, a whole turn is 6.3 radii broad: no crease.
bool isCreased(double size, const FaceSurface& surface) {
  constexpr double kShareOfSize = 0.0413, kShareOfBreadth = 1.0 / 7.26;
  return surface.creaseRadius() <
         std::min(kShareOfSize * size, kShareOfBreadth * surface.breadth());
}

/// Whether a face is a strip that is far narrower than any element, and has waves across, as
/// fillets get where they barely meet. It is no tube either, and what the waves do cannot be seen.
bool isRippledStrip(double size, const FaceSurface& surface) {
  constexpr double kShareOfSize = 0.05;
  return surface.isWavy() && surface.breadth() < kShareOfSize * size;
}

/// Elements scatter around their size.
double byChord(const CadSizes& sizes, int face, double radius) {
  constexpr double kAim = 0.9;
  return kAim * longestChord(radius, sizes.chords.aimOf(face) * chordOnFace(sizes, face));
}

/// Elements on a unit of area, on average over some places of a face.
struct Density {
  double mean = 0;
  double smallest = INFINITY;  ///< of the sizes
  Box3 around;                 ///< the places
};

/// From `samples` places along each parameter.
Density densityOn(const CadSizes& sizes, int face, const FaceSurface& surface,
                  const SplineSurface::Box& box, int samples, bool byPosition) {
  const double wanted = wantedOnFace(sizes, face);
  Density density;
  double sum = 0, weights = 0;
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const double u = box.u1 + (i + 0.5) / samples * (box.u2 - box.u1);
      const double v = box.v1 + (j + 0.5) / samples * (box.v2 - box.v1);
      const SurfaceFrame frame = surface.inOccParameters().frameAt(u, v);
      const double weight = length(cross(frame.du, frame.dv));
      const CurvedSize curved = surface.isPlane() ? CurvedSize{wanted, 1, sizes.minSize}
                                                  : curvedSizeAt(sizes, face, wanted, surface,
                                                                 {frame.position, {}, u, v});
      double size = sizes.chords.areGiven() ? bounded(sizes, curved, curved.limit) : curved.limit;
      if (byPosition) size = bounded(sizes, curved, limitByFunction(sizes, size, frame.position));
      weights += weight;
      sum += weight / (kUnitTriangle * size * size);
      density.smallest = std::min(density.smallest, size);
      density.around.add(frame.position);
    }
  }
  density.mean = weights > 0 ? sum / weights : 1 / (kUnitTriangle * wanted * wanted);
  return density;
}

}  // namespace

CurvedSize curvedSizeAt(const CadSizes& sizes, int face, double size, const FaceSurface& surface,
                        const SurfacePoint& point) {
  constexpr double kVisible = 0.05;  // turn of an edge, in those that it may have
  const FaceSurface::Radii radii = surface.radiiAt(point, reachFromTip(size, surface));
  const double bend = std::min(1.0, size / (kVisible * sizes.faceTurn * radii.smallest));
  const double share = 1 - (1 - sizes.curvedShare) * bend;
  const double gentle =
      std::min({size, std::max(sizes.faceTurn * radii.smallest, sizes.faceLeast * size),
                byChord(sizes, face, radii.smallest)});
  if (sizes.roughFaces.contains(face) || isCreased(size, surface) || isRippledStrip(size, surface))
    return {gentle, share, sizes.minSize};
  const double least = leastOnTube(sizes, size, surface, radii.bent);
  return {std::min(gentle, std::max(sizes.faceTurn * radii.bent, least)), share,
          leastAllowedOnTube(sizes, size, surface, radii.bent)};
}

double bounded(const CadSizes& sizes, const CurvedSize& curved, double size) {
  return std::clamp(size, curved.least, sizes.maxSize);
}

double expectedElements(const CadSizes& sizes, int face, const FaceSurface& surface, double area) {
  constexpr int kSamples = 4;
  if (!surface.isPlane())
    return area * densityOn(sizes, face, surface, surface.box(), kSamples, false).mean;
  const double wanted = wantedOnFace(sizes, face);
  return area / (kUnitTriangle * wanted * wanted);
}

double expectedByPosition(const CadSizes& sizes, int face, const FaceSurface& surface, double area,
                          const SplineSurface::Box& where, int samples) {
  constexpr int kFewest = 2;
  constexpr double kEven = 0.25;  // of the size: what it can change by across the face
  const Density few = densityOn(sizes, face, surface, where, kFewest, true);
  const double extent = kFewest * distance(few.around.low, few.around.high);
  if (sizes.growth * extent < kEven * few.smallest) return area * few.mean;
  return area * densityOn(sizes, face, surface, where, samples, true).mean;
}

}  // namespace af2::geometry
