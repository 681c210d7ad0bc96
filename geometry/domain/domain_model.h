// Faces that meet at curves: the form in which planar domains and triangle surfaces are meshed.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
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

/// A curve between two corners, with a parameter that increases along it.
struct DomainCurve {
  int id = 0;                       ///< of the edge of the model to which it belongs: 1, 2, ...
  std::size_t first = 0, last = 0;  ///< corners
  std::vector<double> knots;        ///< parameters of its ends and of places where it turns
  std::function<Point3(double)> pointAt;  ///< straight, or nearly so, from knot to knot
  double largest = kNoLimit;              ///< maximum length of a segment
  bool isKept = false;                    ///< it stays a single segment of any length

  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
};

/// A face between curves, and the surface under it.
struct DomainFace {
  std::string name, surfaceType;
  double area = 0;
  CurveLoops loops;
  std::vector<std::size_t> isolated;  ///< corners inside that become vertices of the mesh
  std::shared_ptr<const ChartedSurface> surface;       ///< may be used by several threads at once
  std::function<SurfacePoint(const Point3&)> nearest;  ///< point of the surface
  bool canBeCut = false;                   ///< lines in the parameters of the surface may cut it
  double largest = DomainCurve::kNoLimit;  ///< maximum length of an edge
  std::vector<std::string> notes;          ///< repairs, for the report
};

/// The largest edges that the curvature of a face allows.
class AF2_EXPORT CurvatureLimit : public SizeField {
 public:
  /// On one surface, limits with the same numbers are the same; nothing: they cannot be compared.
  virtual std::optional<std::vector<double>> numbers() const { return std::nullopt; }
  /// Approximate number of elements if `size` is wanted everywhere.
  virtual double expectedElements(double size) const = 0;
  /// Places that need smaller sizes, so that elements can follow the face at all.
  virtual std::vector<SizeSource> sizesToFollow() const { return {}; }
};

/// What curvature allows on the faces of a model.
struct CurvatureLimits {
  std::vector<std::shared_ptr<const CurvatureLimit>> ofFaces;  ///< by face; null: it is plane
  /// By curve, the limits at its knots, linear in between, as all curved faces beside it have them
  /// there. Empty: the faces are asked.
  std::vector<std::vector<double>> atKnots = {};
};

/// A place where a face crosses another one, or itself, in the model itself.
struct FacesCross {
  std::array<int, 2> faces{};  ///< their ids
  Point3 place;
};

class FaceMemory;

struct DomainModel {
  std::string name;      ///< the file
  double diagonal = 0;   ///< of the box around it
  bool isFlat = false;   ///< all of it is in one plane
  bool isExact = false;  ///< and its curves are straight, so that elements that fill their faces
                         ///< cannot cross each other
  std::vector<Point3> corners;
  std::vector<DomainCurve> curves;
  std::vector<DomainFace> faces;  ///< their ids are 1, 2, ...
  std::vector<FaceGroup> groups;
  std::vector<EdgeGroup> boundaries;  ///< by their numbers, ascending
  std::vector<std::string> notes;     ///< repairs made while reading
  /// Least size along sharply turning curves, as a share of the wanted size
  /// (DomainSize::turnLimit).
  double leastAtTurns = 0.1;
  /// The budget of retries, as a share of the candidates that CAD faces may use: the cost of charts
  /// differs.
  double retryShare = 1;
  /// How its faces were filled before, for models that are meshed several times with options that
  /// differ in their retries only; null: nothing is remembered.
  std::shared_ptr<FaceMemory> memory;
  bool mayTilt = true;  ///< as the last remedy, elements may tilt against the surface by any angle
  /// Looks for crossings, which explain failures; empty: there are none. Several threads may use it
  /// at once.
  std::function<std::vector<FacesCross>()> crossings;
  /// Empty: all faces are plane. Several threads may use the limits at once.
  std::function<CurvatureLimits(const DomainSize&)> curvatureLimits;
};

/// Meshes the faces between their curves, which are divided once and shared. A face that fails or
/// comes out poor is retried as the faces of CAD models are; a face that still fails is reported
/// and does not affect the others.
///
/// Throws InputError for invalid options, for a model whose parts refer to parts that do not exist,
/// and for a face without a boundary.
AF2_EXPORT ModelMesh meshDomain(const DomainModel& model, const AF2Algorithm& algorithm,
                                const MeshingOptions& options);

}  // namespace af2::geometry
