// Tells an observer of the changes of a mesh that is being finished. Not installed.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/finish_observer.h"

namespace af2 {

/// Whoever changes the mesh has a pointer to one, which is null if nobody observes.
class ActRecorder {
 public:
  using Badness = std::function<double(const Element&)>;

  ActRecorder(FinishObserver& observer, const Mesh& mesh, Badness badness)
      : observer_(observer), mesh_(mesh), badness_(std::move(badness)) {}

  void added(VertexId v) { observer_.vertexAdded(v, mesh_.vertices[v.value].position); }
  /// Before a change that may be kept.
  ///
  /// vertex  the one that may move or vanish
  void begin(std::span<const std::size_t> elements, VertexId vertex = {});
  void begin(std::span<const Corner> star, VertexId vertex);
  /// After a change that was kept; those that vanished are left out of the elements.
  void end(FinishAct::Kind kind, std::span<const std::size_t> elements);
  /// The same for the elements that `begin` was given.
  void end(FinishAct::Kind kind) { end(kind, std::vector(elements_)); }

 private:
  double worstOf(const std::vector<Element>& elements) const;

  FinishObserver& observer_;
  const Mesh& mesh_;
  Badness badness_;
  std::vector<std::size_t> elements_;
  FinishAct act_;
};

/// The badness of meshes that are finished by shape.
ActRecorder::Badness distortionIn(const Mesh& mesh);

}  // namespace af2
