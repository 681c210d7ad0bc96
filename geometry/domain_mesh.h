// The mesh of faces that meet at curves, which are divided once and shared: what planar domains and
// surfaces of triangles have in common.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/mesh_region.h"
#include "geometry/curve_use.h"
#include "geometry/domain_options.h"
#include "geometry/model_mesh.h"
#include "geometry/second_order.h"

namespace af2::geometry {

/// A curve after its division: the vertices along it, both ends included, and where the middles of
/// the segments between them lie, which only elements of second order need.
struct DividedCurve {
  std::vector<VertexId> vertices;
  std::vector<Point3> middles;
  int edge = 0;  ///< id of the edge of the model that it is part of, 1, 2, ...
};

/// A face between divided curves, and the surface under it.
struct DomainFace {
  std::string surfaceType, chart;
  double area = 0;
  CurveLoops loops;
  std::shared_ptr<const SizeField> wanted;
  std::function<SurfacePoint(const Point3&)> nearest;  ///< point of the surface
  /// Called from several threads at once.
  std::function<std::unique_ptr<AF2LocalTransformMaker>()> makeCharts;
  const SurfaceEvaluator* cuts = nullptr;  ///< not null: the face may be cut into pieces
};

/// Takes vertices and curves, then faces, each of which is meshed at once.
class DomainMesh {
 public:
  /// Both are kept as references.
  DomainMesh(const AF2Algorithm& algorithm, const DomainMeshingOptions& options);

  VertexId addVertex(const Point3& position);
  /// The next curve. All curves go before the first face.
  void addCurve(DividedCurve curve);
  /// The next face: 1, 2, ... One that cannot be meshed is reported as failed.
  void addFace(DomainFace face);
  void addGroup(FaceGroup group) { mesh_.groups.push_back(std::move(group)); }
  /// Checks all, leaves out faces that do not pass, and gives elements the wanted order.
  ///
  /// isFlat  all lies in one plane, where elements that fill their faces cannot cross each other
  ModelMesh finish(bool isFlat);

 private:
  void fill(const DomainFace& face, FaceReport& report);
  FrontInput boundaryOf(const DomainFace& face, std::vector<VertexId>& boundary);
  BoundaryCorner cornerOf(VertexId id, const DomainFace& face, std::vector<VertexId>& boundary);
  /// Triangulates what is left of a front that got stuck, and tells so.
  void close(const RegionTask& task, RegionMesh& meshed, FaceReport& report) const;
  void judge(const RegionMesh& meshed, FaceReport& report) const;
  void add(Mesh meshed, const std::vector<VertexId>& boundary, const SizeField& wanted,
           FaceReport& report);
  void addSegments();
  std::vector<SideMiddles> middlesOfSides() const;

  const AF2Algorithm& algorithm_;
  const DomainMeshingOptions& options_;
  std::vector<DividedCurve> curves_;
  std::vector<DomainFace> faces_;
  std::vector<VertexId> localIds_;  // by vertex of the mesh, while the boundary of a face is read
  ModelMesh mesh_;
};

/// Throws InputError for a size that is not positive.
void checkSize(const DomainMeshingOptions& options);

/// Adds what is narrow in `coarse` to the sources of `finer`.
void addNarrowPlaces(const ModelMesh& coarse, double elementsAcross, DomainMeshingOptions& finer);

/// Calls mesh(options); if `elementsAcross` asks for it twice, as a first mesh shows what is
/// narrow.
///
/// Options  derived from DomainMeshingOptions
template <class Options, class Mesh>
ModelMesh meshOnceOrTwice(const Options& options, const Mesh& mesh) {
  if (options.elementsAcross == 0) return mesh(options);
  Options finer = options;
  finer.elementsAcross = 0;
  Options first = finer;
  first.optimize = false;
  first.order = 1;
  first.progress = {};
  first.observer = nullptr;
  addNarrowPlaces(mesh(first), options.elementsAcross, finer);
  return mesh(finer);
}

}  // namespace af2::geometry
