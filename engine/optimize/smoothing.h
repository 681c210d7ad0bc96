// Moves inner vertices to positions where the elements around them are least distorted.
#pragma once

#include <span>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"
#include "engine/optimize/triangle_star.h"
#include "engine/step/neighborhood.h"
#include "engine/surface/local_transform.h"

namespace af2 {

/// The distortion of one corner as a function of a moving point x of the plane:
/// scale * (count |x|^2 - 2 sum.x + fixed) / (a.x + a0); the denominator is twice the area.
/// The cotangent of an angle has the same form.
struct DistortionTerm {
  double scale, count;
  Point2 sum;
  double fixed;
  Point2 a;
  double a0;
};

/// Smooths a mesh sweep by sweep. A vertex sleeps, i.e. is skipped, while its surroundings have
/// hardly changed since its last visit brought almost no gain, and before that if all triangles
/// around it are even.
class VertexSmoother {
 public:
  VertexSmoother(MeshTopology& topology, Mesh& mesh, const AF2LocalTransformMaker& maker,
                 ActRecorder* recorder = nullptr);

  /// One sweep over all inner vertices in order; ends early if a stop is requested. Returns the
  /// number of moved vertices.
  std::size_t sweep(const WorkWatch& watch = {});
  /// One sweep over some inner vertices that improves the worst element at each.
  std::size_t mend(std::span<const VertexId> vertices);
  /// Wakes these vertices, after swaps and collapses.
  void wake(std::span<const VertexId> vertices);

 private:
  enum class Goal { All, Worst };

  /// How far the vertex was moved, as a fraction of its shortest edge; 0: not at all.
  double smooth(VertexId v, Goal goal);
  bool collectStar(Corner first);
  double moveInChart(VertexId v, const StepChart& chart, Goal goal);
  Point2 stepInChart(const StepChart& chart, Goal goal);
  bool isImproved(SurfacePoint& here, const SurfacePoint& before, const StepChart& chart,
                  Goal goal) const;
  bool isFixed(Corner c) const;
  bool makeTerms(const StepChart& chart);
  template <class Drawing>
  bool makeTerms(const StepChart& chart, const Drawing& drawing);
  double worstDistortion() const;
  const SurfacePoint& at(Corner c) const { return mesh_.vertices[topology_.vertexAt(c).value]; }

  MeshTopology& topology_;
  Mesh& mesh_;
  const AF2LocalTransformMaker& maker_;
  ActRecorder* recorder_;
  ChartSlot slot_;
  std::vector<std::uint8_t> isAwake_;
  std::vector<Corner> star_;
  bool isBetweenTriangles_ = false;        ///< few enough for triangles_
  std::vector<const SurfacePoint*> ring_;  ///< around the vertex, if it is
  TriangleStar triangles_;
  std::vector<DistortionTerm> terms_;
  std::vector<DistortionTerm> upright_;  ///< for corners on the boundary
  double reach_ = 0;                     ///< length of the shortest edge at the vertex
};

}  // namespace af2
