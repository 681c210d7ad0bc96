// How far a mesh is from its model, and where smaller elements are needed.
// Not installed.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "geometry/deviation/edge_curves.h"
#include "geometry/deviation/face_distance.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

struct DeviationTask {
  /// By id of a face: null if its elements lie in its surface.
  std::function<std::unique_ptr<FaceDistance>(int face)> distanceFrom;
  std::function<double(int face)> boundOf;  ///< by id of a face; infinite: none
  std::vector<double> boundsOfSegments;     ///< the smallest of the faces beside each
  int threads = 0;
};

struct Deviations {
  Deviation largest;
  double excess = 0;  ///< the largest ratio of a distance and its bound
  /// By face: the largest such ratio of elements that are larger than their size.
  std::map<int, double> scatter;
  /// Where other elements, or segments, exceed a bound, with the size that would keep it.
  std::vector<SizeSource> tooFar;
};

/// Measures the elements at points inside and on their sides, against the surfaces of their faces,
/// and the segments against their edges. The largest distance on each face goes to its report.
Deviations measureDeviations(ModelMesh& mesh, const EdgeCurves& curves, const DeviationTask& task);

/// By segment: the smallest bound of the faces that have it as a side.
std::vector<double> boundsOfSegments(const ModelMesh& mesh,
                                     const std::function<double(int face)>& boundOf);

/// The largest distance of a triangle from a surface, at points inside and on its sides.
struct FarPoint {
  double distance = 0;
  Point3 place = {};
};
FarPoint farthestOf(const Point3& a, const Point3& b, const Point3& c, FaceDistance& surface);

}  // namespace af2::geometry
