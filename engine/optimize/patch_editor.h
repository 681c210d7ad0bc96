// Takes small parts out of a mesh with quadrilaterals and puts changed ones back.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"
#include "engine/optimize/patch_shape.h"
#include "engine/optimize/quad_patch.h"
#include "engine/step/neighborhood.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// Works on one patch after another. The vertices of a patch are placed in one chart.
class PatchEditor {
 public:
  /// anglesAtFixed  the angle that the mesh has at each fixed vertex, in radians
  PatchEditor(MeshTopology& topology, const AF2LocalTransformMaker& maker,
              const std::vector<double>& anglesAtFixed, ActRecorder* recorder = nullptr);

  const MeshTopology& topology() const { return topology_; }
  /// How much the sum of the ideal angles at a vertex differs from the angle there, in units of 30
  /// degrees; 0: the vertex is regular.
  int irregularity(VertexId v) const;
  /// The angle at a vertex, in units of 30 degrees.
  int wantedAt(VertexId v) const;

  /// Takes the elements within some rings around a vertex: fewer rings where the surface bends so
  /// much that its chart hides some. Returns false if there are too many, or no chart shows them.
  bool take(VertexId seed);
  /// Takes these elements, and some rings around them, as above.
  ///
  /// seed  one of their vertices, in the middle: the chart is made there
  bool take(VertexId seed, std::span<const std::size_t> elements);

  // Of the patch that was taken last:

  const QuadPatch& patch() const { return patch_; }
  /// The patch's number of an element of the mesh.
  std::optional<std::size_t> find(std::size_t element) const;
  QuadPatch::Vertex find(VertexId v) const { return numbers_[v.value]; }
  VertexId vertexAt(QuadPatch::Vertex v) const { return vertices_[v]; }
  /// The scaled Jacobians in the chart; no value if the patch has no chart.
  std::optional<PatchJacobians> jacobians();
  /// Smooths the changed patch and puts it back if its scaled Jacobians are at least the wanted
  /// ones and its elements face the way the surface does. Returns whether it did.
  ///
  /// kind  of the change, for observers
  bool putBack(const QuadPatch& changed, const PatchJacobians& wanted, FinishAct::Kind kind);
  /// The same with places in the chart where smoothing begins, by vertex of the changed patch.
  bool putBack(const QuadPatch& changed, std::vector<Point2> points, const PatchJacobians& wanted,
               FinishAct::Kind kind);
  /// The places of the vertices in the chart; none if the patch has no chart.
  const std::vector<Point2>& points();
  /// The vertices of the patch after putBack.
  const std::vector<VertexId>& vertices() const { return vertices_; }

 private:
  using Moved = std::vector<std::optional<SurfacePoint>>;  ///< by vertex of the changed patch

  struct Extent {
    int rings;
    std::size_t mostElements;
  };
  bool takeShown(VertexId seed, std::span<const std::size_t> elements, Extent extent);
  bool collect(VertexId seed, std::vector<std::size_t> elements, const Extent& extent);
  bool addRing(std::size_t firstVertex, std::size_t mostElements);
  bool number(std::size_t firstElement);
  void makePatch();
  bool openChart();
  bool openChartTo(VertexId end);
  bool isSound(const QuadPatch& patch, std::size_t element, const Moved* moved) const;
  bool staysSoundOnSurface(const QuadPatch& changed, const Moved& moved) const;
  bool joinsAgain(const QuadPatch& changed) const;
  bool isNew(const QuadPatch& changed, std::size_t element) const;
  void apply(const QuadPatch& changed, const Moved& moved, FinishAct::Kind kind);
  void move(VertexId v, const SurfacePoint& point);
  void addAngles(std::size_t element, int sign);

  MeshTopology& topology_;
  const Mesh& mesh_;
  const AF2LocalTransformMaker& maker_;
  ActRecorder* recorder_;
  std::vector<int> wanted_;  ///< by fixed vertex: the angle there
  std::vector<int> sums_;    ///< by vertex: the sum of its elements' ideal angles
  QuadPatch patch_;
  std::vector<VertexId> vertices_;          ///< by vertex of the patch
  std::vector<std::size_t> elements_;       ///< by element of the patch
  std::vector<QuadPatch::Vertex> numbers_;  ///< by vertex of the mesh: that of the patch, or kNone
  std::vector<std::uint8_t> isTaken_;       ///< by element of the mesh
  ChartSlot slot_;
  std::optional<StepChart> chart_;
  std::vector<Point2> points_;  ///< by vertex of the patch, in the chart; empty: no chart yet
};

}  // namespace af2
