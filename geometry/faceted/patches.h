// Cuts a surface of triangles into smooth patches along its feature edges.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "geometry/domain/curve_use.h"
#include "geometry/faceted/crossed_facets.h"
#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// A chain of feature edges between two corners, or a closed one without any: vertices, the first
/// one again at the end if closed.
using FeatureCurve = std::vector<std::uint32_t>;

/// Triangles that can be reached from each other without crossing a feature edge.
struct Patch {
  std::vector<std::uint32_t> triangles;
  CurveLoops loops;
};

/// The normals of triangles, without noise.
struct FacetDirections {
  std::vector<Point3> normals;  ///< by triangle; 0: unknown
  std::vector<bool> isRough;    ///< by triangle: its normal is a mean of the surrounding ones
};

struct PatchedFacets {
  Facets facets;
  FacetDirections directions;
  std::vector<Point3> normals;  ///< by triangle, the basis of smooth normals (SharpBlends)
  std::vector<FeatureCurve> curves;
  std::vector<Patch> patches;  ///< in the order of their first triangles
  std::set<FacetEdge> cuts;    ///< edges between patches that are no features
  std::shared_ptr<CrossedFacets> crossed = std::make_shared<CrossedFacets>();  ///< shared
};

/// Limits that define feature edges.
struct FeatureLimits {
  double angle = 0;     ///< in radians: edges where the surface turns by more are features
  double looseEnd = 0;  ///< minimum length of a curve with the same patch on both sides
  /// Patches smaller than this are merged with one of those around them; so are patches narrower
  /// than a fiftieth of this; or a fifth, if they are shorter than a loose end or not the rim
  /// of a thin wall; or next to a crease in a rounding, narrower than twice this. A turn of a curve
  /// that is reversed within this length is no corner. Where the surface is rough, 0.7 times the
  /// wanted size is used instead.
  double speck = 0;
  /// Wanted size of elements by position: far smaller roundings become edges, and roughness on a
  /// smaller scale counts as noise; none: neither.
  std::function<double(const Point3&)> sizeAt = {};
};

/// Feature edges are those at which the surface turns by more than the angle, those between parts
/// of the file, those with one triangle, with more than two or with two of opposite orientations,
/// and those in the middle of small roundings. Corners are where a curve of feature edges turns by
/// more than the angle, and where several curves meet. A patch with little boundary for its area,
/// e.g. a sphere, is cut in two by a plane (cutAcross).
PatchedFacets findPatches(Facets facets, const FeatureLimits& limits);

/// The same, with further edges between patches.
PatchedFacets cutPatches(const PatchedFacets& patched, const std::set<FacetEdge>& cuts,
                         const FeatureLimits& limits);

}  // namespace af2::geometry
