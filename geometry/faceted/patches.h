// Cuts a surface of triangles into smooth patches along its feature edges.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <vector>

#include "geometry/domain/curve_use.h"
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

/// Where triangles look to, without noise.
struct FacetDirections {
  std::vector<Point3> normals;  ///< by triangle; 0: there is nothing to tell it by
  std::vector<bool> isRough;    ///< by triangle: its normal is a mean of those around
};

struct PatchedFacets {
  Facets facets;
  FacetDirections directions;
  std::vector<Point3> normals;  ///< by triangle, as smooth normals are to follow (SharpBlends)
  std::vector<FeatureCurve> curves;
  std::vector<Patch> patches;  ///< in the order of their first triangles
  std::set<FacetEdge> cuts;    ///< edges between patches that no feature has made
};

/// What feature edges are.
struct FeatureLimits {
  double angle = 0;     ///< in radians: where the surface turns by more
  double looseEnd = 0;  ///< a curve with the same patch on both sides is longer than this
  /// Patches smaller than this are part of those around them; so are those that are narrower than a
  /// fiftieth of it. What a curve turns within it and back is no corner. Where the surface is rough
  /// it is most of an element.
  double speck = 0;
  /// Wanted size of elements by position: roundings far smaller than that are taken for edges;
  /// none: they are not. What is rough on a smaller scale is taken for noise.
  std::function<double(const Point3&)> sizeAt = {};
};

/// Feature edges are those at which the surface turns by more than the angle, those between parts
/// of the file, those with one triangle or with more than two, and those amid small roundings.
/// Where a curve of feature edges turns by more than this, or several meet, is a corner. A patch
/// with hardly any boundary for its area, e.g. a sphere, is cut in two across its longest
/// direction.
///
/// Throws InputError if neighbours are turned against each other.
PatchedFacets findPatches(Facets facets, const FeatureLimits& limits);

/// The same with more edges between patches.
PatchedFacets cutPatches(const PatchedFacets& patched, const std::set<FacetEdge>& cuts,
                         const FeatureLimits& limits);

}  // namespace af2::geometry
