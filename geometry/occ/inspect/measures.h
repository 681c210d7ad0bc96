// What can be measured of the faces and solids of a model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

struct FaceMeasures {
  int id = 0;
  double area = 0;
  Point3 centroid{};     ///< of the area; it need not be on the face
  Point3 place{};        ///< the point of the face, of some in its inside, that is nearest to this
  Point3 low{}, high{};  ///< corners of the box around the face
  /// At some points of the face: the least and the greatest of the larger principal curvature, by
  /// its absolute value; 1 / radius on a cylinder or a sphere.
  double leastCurvature = 0, greatestCurvature = 0;
  std::vector<int> edges, neighbors;  ///< ids, ascending; neighbors share an edge with the face
};

struct SolidMeasures {
  int number = 0;  ///< 1, 2, ... as in the name of its group
  double volume = 0;
  Point3 centroid{};  ///< of the volume
  Point3 low{}, high{};
  std::vector<int> faces;  ///< ids, ascending
};

/// By face; nothing for a face that OpenCASCADE cannot measure.
AF2_EXPORT std::vector<std::optional<FaceMeasures>> measuresOfFaces(const Model& model);

/// Without solids that OpenCASCADE cannot measure.
AF2_EXPORT std::vector<SolidMeasures> measuresOfSolids(const Model& model);

}  // namespace af2::geometry
