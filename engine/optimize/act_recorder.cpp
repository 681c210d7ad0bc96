#include "engine/optimize/act_recorder.h"

#include <algorithm>
#include <array>

#include "engine/base/error.h"
#include "engine/mesh/element_shape.h"

namespace af2 {

const char* toString(FinishAct::Kind kind) {
  switch (kind) {
    case FinishAct::Kind::SwapForValence:
      return "swap for valence";
    case FinishAct::Kind::SwapForQuality:
      return "swap for quality";
    case FinishAct::Kind::Collapse:
      return "collapse";
    case FinishAct::Kind::Move:
      return "move";
    case FinishAct::Kind::Replacement:
      return "replacement";
    case FinishAct::Kind::Pairing:
      return "pairing";
    case FinishAct::Kind::Search:
      return "search";
  }
  throw InternalError("a change of a mesh has an unknown kind");
}

void ActRecorder::begin(std::span<const std::size_t> elements, VertexId vertex) {
  elements_.assign(elements.begin(), elements.end());
  act_.before.clear();
  for (const std::size_t e : elements) act_.before.push_back(mesh_.elements[e]);
  act_.worstBefore = worstOf(act_.before);
  act_.vertex = vertex;
  act_.from = vertex.isNone() ? Point3{} : mesh_.vertices[vertex.value].position;
}

void ActRecorder::begin(std::span<const Corner> star, VertexId vertex) {
  std::vector<std::size_t> elements;
  for (const Corner c : star) elements.push_back(c.element());
  begin(elements, vertex);
}

void ActRecorder::end(FinishAct::Kind kind, std::span<const std::size_t> elements) {
  act_.kind = kind;
  act_.after.clear();
  for (const std::size_t e : elements)
    if (!mesh_.elements[e].corners[0].isNone()) act_.after.push_back(mesh_.elements[e]);
  act_.worstAfter = worstOf(act_.after);
  act_.to = act_.vertex.isNone() ? Point3{} : mesh_.vertices[act_.vertex.value].position;
  observer_.actKept(act_);
}

double ActRecorder::worstOf(const std::vector<Element>& elements) const {
  double worst = 0;
  for (const Element& element : elements) worst = std::max(worst, badness_(element));
  return worst;
}

ActRecorder::Badness distortionIn(const Mesh& mesh) {
  return [&mesh](const Element& element) {
    std::array<const SurfacePoint*, 4> corners{};
    const auto vertices = element.vertices();
    for (std::size_t i = 0; i < vertices.size(); ++i)
      corners[i] = &mesh.vertices[vertices[i].value];
    return elementDistortion({corners.data(), vertices.size()});
  };
}

}  // namespace af2
