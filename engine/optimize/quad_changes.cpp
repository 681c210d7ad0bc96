#include "engine/optimize/quad_changes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mesh/element_shape.h"
#include "engine/optimize/ideal_angles.h"

namespace af2 {
namespace {

/// Cost of a triangle, and of distortion, in squared units of missing angle.
constexpr double kTriangleCost = 12, kDistortionCost = 3;
/// Least gain of a change, so that rounding cannot undo and redo changes forever.
constexpr double kMinGain = 1e-6;
/// Larger connected groups of triangles are assumed to be intended.
constexpr std::size_t kLargestIsland = 12;

double costOfKind(const Element& element) { return element.isQuad() ? 0 : kTriangleCost; }

/// The change of the angle sum at a vertex, to be accumulated.
int& angleAt(std::vector<std::pair<VertexId, int>>& angles, VertexId v) {
  for (auto& [vertex, more] : angles)
    if (vertex == v) return more;
  return angles.emplace_back(v, 0).second;
}

}  // namespace

Element elementOf(std::span<const VertexId> ring) {
  Element element;
  std::ranges::copy(ring, element.corners.begin());
  return element;
}

bool areDifferent(std::span<const VertexId> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (vertices[i] == vertices[k]) return false;
  return true;
}

QuadChanges::QuadChanges(MeshTopology& topology, const std::vector<double>& anglesAtFixed,
                         std::optional<std::uint16_t> closingRule, ActRecorder* recorder)
    : topology_(topology),
      recorder_(recorder),
      wanted_(topology.mesh().vertices.size(), kFullTurn),
      sum_(wanted_.size(), 0),
      changed_(wanted_.size(), 0),
      lookedAt_(topology.mesh().elements.size(), 0),
      bestGain_(kMinGain) {
  for (std::size_t v = 0; v < anglesAtFixed.size(); ++v)
    wanted_[v] = angleInUnits(anglesAtFixed[v]);
  for (std::size_t e = 0; e < elementCount(); ++e) {
    distortion_.push_back(topology_.isDead(e) ? 0 : distortionOf(elementAt(e)));
    if (topology_.isDead(e)) continue;
    add(elementAt(e), 1);
    hasTriangles_ |= !elementAt(e).isQuad();
  }
  open(closingRule);
}

/// Opens for replacement: quadrilaterals, triangles that close a front, and small groups of
/// triangles connected by sides.
void QuadChanges::open(std::optional<std::uint16_t> closingRule) {
  isOpen_.assign(elementCount(), 0);
  std::vector<std::uint8_t> isSeen(elementCount(), 0);
  std::vector<std::size_t> island;
  for (std::size_t e = 0; e < elementCount(); ++e) {
    if (topology_.isDead(e)) continue;
    if (elementAt(e).isQuad() || mesh().origins[e].rule == closingRule) isOpen_[e] = 1;
    if (isSeen[e] || elementAt(e).isQuad()) continue;
    island.assign(1, e);
    isSeen[e] = 1;
    for (std::size_t i = 0; i < island.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner beyond = topology_.across(Corner(island[i], k));
        if (beyond.isNone() || isSeen[beyond.element()]) continue;
        if (elementAt(beyond.element()).isQuad()) continue;
        isSeen[beyond.element()] = 1;
        island.push_back(beyond.element());
      }
    if (island.size() > kLargestIsland) continue;
    for (const std::size_t triangle : island) isOpen_[triangle] = 1;
  }
}

std::vector<VertexId> QuadChanges::from(Corner c) const {
  std::vector<VertexId> vertices;
  for (int i = 0; i < topology_.sizeOf(c); ++i, c = topology_.next(c))
    vertices.push_back(topology_.vertexAt(c));
  return vertices;
}

double QuadChanges::distortionOf(const Element& element) const {
  std::array<const SurfacePoint*, 4> corners{};
  const auto vertices = element.vertices();
  for (std::size_t i = 0; i < vertices.size(); ++i)
    corners[i] = &mesh().vertices[vertices[i].value];
  return elementDistortion({corners.data(), vertices.size()});
}

bool QuadChanges::isNews(std::size_t e) const {
  return std::ranges::any_of(elementAt(e).vertices(),
                             [&](VertexId v) { return changed_[v.value] >= lookedAt_[e]; });
}

void QuadChanges::add(const Element& element, int sign) {
  for (const VertexId v : element.vertices()) {
    sum_[v.value] += sign * idealAngle(element);
    changed_[v.value] = clock_;
  }
}

double QuadChanges::costOfDistortion(double distortion) const {
  constexpr double kWorst = 20;
  const double excess = std::min(distortion, kWorst) - 1;
  return kDistortionCost * excess * excess;
}

/// Square of the vertex's excess or missing angle, in units; 0 if no element is left there.
double QuadChanges::costOf(VertexId v, int sum) const {
  const int off = sum == 0 ? 0 : sum - wanted_[v.value];
  return off * off;
}

double QuadChanges::gainOf(const Change& change) const {
  double gain = 0;
  angles_.clear();
  for (const std::size_t place : change.places) {
    const Element& element = elementAt(place);
    gain += costOfKind(element);
    for (const VertexId v : element.vertices()) angleAt(angles_, v) -= idealAngle(element);
  }
  for (const Element& element : change.elements) {
    gain -= costOfKind(element);
    for (const VertexId v : element.vertices()) angleAt(angles_, v) += idealAngle(element);
  }
  for (const auto& [v, more] : angles_)
    gain += costOf(v, sum_[v.value]) - costOf(v, sum_[v.value] + more);
  return gain;
}

void QuadChanges::offer(Change change, const Leniency& leniency) {
  if (keepsQuads_ && !std::ranges::all_of(change.elements, &Element::isQuad) &&
      std::ranges::all_of(change.places, [&](std::size_t e) { return isSoundAt(e); }))
    return;
  double gain = gainOf(change), worst = leniency.worst;
  for (const std::size_t place : change.places) {
    if (!isOpen_[place]) return;
    worst = std::max(worst, distortion_[place]);
    gain += leniency.shapeWeight * costOfDistortion(distortion_[place]);
  }
  if (gain <= bestGain_) return;  // rejects early: shapes take longer to compute
  for (const Element& element : change.elements) {
    const double here = distortionOf(element);
    if (here > worst || !std::isfinite(here)) return;
    gain -= leniency.shapeWeight * costOfDistortion(here);
  }
  if (gain <= bestGain_) return;
  bestGain_ = gain;
  best_ = std::move(change);
}

bool QuadChanges::apply(FinishAct::Kind kind) {
  bestGain_ = kMinGain;
  const Change change = std::exchange(best_, {});
  if (change.places.empty()) return false;
  for (const std::size_t place : change.places) add(elementAt(place), -1);
  for (const Element& element : change.elements) add(element, 1);
  if (recorder_) recorder_->begin(change.places);
  const std::vector<std::size_t> places = topology_.replace(change.places, change.elements);
  if (recorder_) recorder_->end(kind, places);
  isOpen_.resize(elementCount(), 1);
  lookedAt_.resize(elementCount(), 0);
  distortion_.resize(elementCount());
  for (const std::size_t place : places) distortion_[place] = distortionOf(elementAt(place));
  return true;
}

}  // namespace af2
