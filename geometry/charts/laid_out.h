// Maps a front into the plane of a PlaneMap, and its mesh back to the surface.
#pragma once

#include <string>
#include <vector>

#include "engine/run/algorithm.h"
#include "engine/run/region_split.h"
#include "engine/surface/size_field.h"
#include "geometry/charts/plane_map.h"

namespace af2::geometry {

/// A front in the plane z = 0. A vertex on a seam has a place on each side of the seam, and the
/// front has one vertex for each place.
struct LaidOutFront {
  FrontInput input;
  std::vector<VertexId> original;  ///< by vertex of `input`
  bool hasTwins = false;           ///< whether some vertex has several places
};

/// A point of the plane, as the engine sees it.
inline SurfacePoint pointInPlane(Point2 p) { return {{p.x, p.y, 0}, {0, 0, 1}, p.x, p.y}; }
inline Point2 placeOf(const SurfacePoint& point) { return {point.position.x, point.position.y}; }

LaidOutFront layOut(const FrontInput& input, const PlaneMap& map);

/// Maps the result of a run in the plane to the surface. The vertices of the boundary keep the
/// positions that they were given.
void lift(MeshingResult& result, const LaidOutFront& front, const FrontInput& original,
          const PlaneMap& map);

/// Describes a fault that mapping back has caused in a mesh that was sound in the plane; empty if
/// there is none.
///
/// ignoresNormals  elements may tilt against the surface by any angle
std::string faultOfLifted(const Mesh& mesh, const LaidOutFront& front, const FrontInput& original,
                          bool ignoresNormals = false);

/// The sizes on the surface, converted to lengths in the plane.
class LaidOutSize final : public SizeField {
 public:
  LaidOutSize(const SizeField& size, const PlaneMap& map) : size_(size), map_(map) {}
  double sizeAt(const SurfacePoint& point) const override {
    const Point2 place = placeOf(point);
    return size_.sizeAt(map_.lift(place)) * map_.scaleAt(place);
  }

 private:
  const SizeField& size_;
  const PlaneMap& map_;
};

/// The plane itself as a surface, for cuts between pieces of a face.
class PlanePoints final : public SurfaceEvaluator {
 public:
  SurfacePoint at(double u, double v) const override { return pointInPlane({u, v}); }
};

}  // namespace af2::geometry
