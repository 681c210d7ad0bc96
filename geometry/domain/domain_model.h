// Faces that meet at curves: what planar domains and surfaces of triangles are meshed as.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/surface/size_field.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/domain/curve_use.h"
#include "geometry/domain/domain_size.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/meshing/meshing_options.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// A curve between two corners, by a parameter that grows along it.
struct DomainCurve {
  int id = 0;  ///< of the edge of the model that it is, or is part of: 1, 2, ...
  std::size_t first = 0, last = 0;        ///< corners
  std::vector<double> knots;              ///< parameters of its ends, and of places where it turns
  std::function<Point3(double)> pointAt;  ///< straight, or nearly so, from knot to knot
  double largest = kNoLimit;              ///< no segment is to be longer
  bool isKept = false;                    ///< it is a single segment, however long

  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
};

/// A face between curves, and the surface under it.
struct DomainFace {
  std::string name, surfaceType;
  double area = 0;
  CurveLoops loops;
  std::vector<std::size_t> isolated;  ///< corners inside that are to be vertices of the mesh
  std::shared_ptr<const ChartedSurface> surface;       ///< may be used by several threads at once
  std::function<SurfacePoint(const Point3&)> nearest;  ///< point of the surface
  bool canBeCut = false;                   ///< lines in the parameters of the surface may cut it
  double largest = DomainCurve::kNoLimit;  ///< no edge is to be longer
  std::vector<std::string> notes;          ///< what was put right, for the report
};

/// The largest edges that the curvature of a face allows.
class AF2_EXPORT CurvatureLimit : public SizeField {
 public:
  /// How many elements there will be about, if `size` is wanted everywhere.
  virtual double expectedElements(double size) const = 0;
  /// Places that want smaller ones, for elements to follow the face at all.
  virtual std::vector<SizeSource> sizesToFollow() const { return {}; }
};

struct DomainModel {
  std::string name;      ///< the file
  double diagonal = 0;   ///< of the box around it
  bool isFlat = false;   ///< all of it lies in one plane
  bool isExact = false;  ///< and its curves are straight, so that elements that fill their faces
                         ///< cannot cross each other
  std::vector<Point3> corners;
  std::vector<DomainCurve> curves;
  std::vector<DomainFace> faces;  ///< their ids are 1, 2, ...
  std::vector<FaceGroup> groups;
  std::vector<EdgeGroup> boundaries;  ///< by their numbers, ascending
  std::vector<std::string> notes;     ///< what was put right while reading
  /// How much of the wanted size is left along curves that turn sharply (DomainSize::turnLimit).
  double leastAtTurns = 0.1;
  /// Of the candidates that retries of CAD faces may take, as charts differ in what they cost.
  double retryShare = 1;
  /// By face, what curvature allows; empty: all faces are plane. To be used by several threads at
  /// once.
  std::function<std::vector<std::shared_ptr<const CurvatureLimit>>(const DomainSize&)>
      limitsOfFaces;
};

/// Meshes the faces between their curves, which are divided once and shared. A face that cannot be
/// meshed as it should be is tried again as those of CAD models are; one that fails is reported and
/// does not spoil the others.
///
/// Throws InputError for options that make no sense, and for a model with parts that are not there,
/// or with a face without a boundary.
AF2_EXPORT ModelMesh meshDomain(const DomainModel& model, const AF2Algorithm& algorithm,
                                const MeshingOptions& options);

}  // namespace af2::geometry
