#include "engine/optimize/patch_editor.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "engine/base/error.h"
#include "engine/mesh/element_shape.h"
#include "engine/optimize/ideal_angles.h"

namespace af2 {

using Vertex = QuadPatch::Vertex;

PatchEditor::PatchEditor(MeshTopology& topology, const AF2LocalTransformMaker& maker,
                         const std::vector<double>& anglesAtFixed, ActRecorder* recorder)
    : topology_(topology),
      mesh_(topology.mesh()),
      maker_(maker),
      recorder_(recorder),
      sums_(topology.mesh().vertices.size(), 0) {
  for (const double angle : anglesAtFixed) wanted_.push_back(angleInUnits(angle));
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) addAngles(e, 1);
}

void PatchEditor::addAngles(std::size_t element, int sign) {
  if (topology_.isDead(element)) return;
  sums_.resize(mesh_.vertices.size(), 0);
  for (const VertexId v : mesh_.elements[element].vertices())
    sums_[v.value] += sign * idealAngle(mesh_.elements[element]);
}

int PatchEditor::wantedAt(VertexId v) const {
  return v.value < wanted_.size() ? wanted_[v.value] : kFullTurn;
}

int PatchEditor::irregularity(VertexId v) const {
  const int sum = sums_[v.value], off = std::abs(sum - wantedAt(v));
  const bool isRegular = sum == 0 || (topology_.isFixed(v) && off <= 1);
  return isRegular ? 0 : off;
}

/// The elements at the vertices from `firstVertex` on; none of them if they are too many.
bool PatchEditor::addRing(std::size_t firstVertex, std::size_t mostElements) {
  const std::size_t end = vertices_.size(), before = elements_.size();
  for (std::size_t i = firstVertex; i < end; ++i)
    topology_.forEachCornerOf(vertices_[i], [&](Corner c) {
      if (std::exchange(isTaken_[c.element()], 1) == 0) elements_.push_back(c.element());
    });
  if (elements_.size() <= mostElements) return true;
  for (const std::size_t e : std::span(elements_).subspan(before)) isTaken_[e] = 0;
  elements_.resize(before);
  return false;
}

/// The vertices of the elements from `firstElement` on that have no number yet get one.
bool PatchEditor::number(std::size_t firstElement) {
  constexpr std::size_t kRoom = 8;  // for what acts add
  for (const std::size_t e : std::span(elements_).subspan(firstElement))
    for (const VertexId v : mesh_.elements[e].vertices()) {
      if (numbers_[v.value] != QuadPatch::kNone) continue;
      if (vertices_.size() + kRoom == QuadPatch::kMaxVertices) return false;
      numbers_[v.value] = static_cast<Vertex>(vertices_.size());
      vertices_.push_back(v);
    }
  return true;
}

/// Ring by ring around the seed and the elements, as far as there is room.
bool PatchEditor::collect(VertexId seed, std::vector<std::size_t> elements, const Extent& extent) {
  numbers_.resize(mesh_.vertices.size(), QuadPatch::kNone);
  isTaken_.resize(mesh_.elements.size(), 0);
  for (const VertexId v : vertices_) numbers_[v.value] = QuadPatch::kNone;
  for (const std::size_t e : elements_) isTaken_[e] = 0;
  elements_ = std::move(elements);
  for (const std::size_t e : elements_) isTaken_[e] = 1;
  vertices_.assign(1, seed);
  numbers_[seed.value] = 0;
  if (!number(0)) return false;
  std::size_t firstVertex = 0;
  for (int ring = 0; ring < extent.rings; ++ring) {
    const std::size_t firstElement = elements_.size(), nextVertex = vertices_.size();
    if (!addRing(firstVertex, extent.mostElements)) break;
    if (!number(firstElement)) return false;
    firstVertex = nextVertex;
  }
  return !elements_.empty();
}

bool PatchEditor::take(VertexId seed) { return takeShown(seed, {}, {3, 88}); }

bool PatchEditor::take(VertexId seed, std::span<const std::size_t> elements) {
  return takeShown(seed, elements, {2, QuadPatch::kMaxElements});
}

/// With as many rings as one chart shows.
bool PatchEditor::takeShown(VertexId seed, std::span<const std::size_t> elements, Extent extent) {
  for (; extent.rings >= 0; --extent.rings) {
    points_.clear();
    if (!collect(seed, {elements.begin(), elements.end()}, extent)) continue;
    makePatch();
    if (openChart()) return true;
  }
  return false;
}

void PatchEditor::makePatch() {
  std::vector<int> sums(vertices_.size(), 0);
  for (const std::size_t e : elements_)
    for (const VertexId v : mesh_.elements[e].vertices())
      sums[numbers_[v.value]] += idealAngle(mesh_.elements[e]);
  patch_ = {};
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const VertexId v = vertices_[i];
    constexpr int kMost = 100;
    PatchVertex vertex;
    vertex.wanted = static_cast<std::int8_t>(std::min(wantedAt(v), kMost));
    vertex.sum = static_cast<std::int8_t>(std::min(sums_[v.value], kMost));
    vertex.isFixed = topology_.isFixed(v);
    vertex.isInner = !vertex.isFixed && sums[i] == sums_[v.value];
    patch_.add(vertex);
  }
  for (const std::size_t e : elements_) {
    QuadPatch::Ring ring{QuadPatch::kNone, QuadPatch::kNone, QuadPatch::kNone, QuadPatch::kNone};
    const auto corners = mesh_.elements[e].vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) ring[i] = numbers_[corners[i].value];
    patch_.add(ring);
  }
  patch_.finish();
}

std::optional<std::size_t> PatchEditor::find(std::size_t element) const {
  const auto place = std::ranges::find(elements_, element);
  if (place == elements_.end()) return std::nullopt;
  return static_cast<std::size_t>(place - elements_.begin());
}

/// Along one of the sides at the seed: where the surface bends sharply beside it, charts of some
/// sides hide what those of others show.
bool PatchEditor::openChart() {
  if (!points_.empty()) return true;
  const Corner first = topology_.cornerOf(vertices_[0]);
  for (Corner c = first; !c.isNone();) {
    if (openChartTo(topology_.vertexAt(topology_.next(c)))) return true;
    c = topology_.aroundVertex(c);
    if (c == first) break;
  }
  return false;
}

bool PatchEditor::openChartTo(VertexId end) {
  const SurfacePoint& here = mesh_.vertices[vertices_[0].value];
  const SurfacePoint& neighbor = mesh_.vertices[end.value];
  const double unit = distance(here.position, neighbor.position);
  if (!(unit > 0)) return false;
  try {
    chart_.emplace(maker_.makeLocalTransformIn(slot_, here, neighbor, unit), unit);
    for (const VertexId v : vertices_) {
      const ChartPoint point = chart_->project(mesh_.vertices[v.value]);
      if (point.view == ChartView::Hidden) {
        points_.clear();
        return false;
      }
      points_.push_back(point.position);
    }
  } catch (const GeometryError&) {
    points_.clear();
    return false;  // there is no chart here: the patch stays as it is
  }
  return true;
}

const std::vector<Point2>& PatchEditor::points() {
  openChart();
  return points_;
}

std::optional<PatchJacobians> PatchEditor::jacobians() {
  if (!openChart()) return std::nullopt;
  return jacobiansOf(patch_, points_);
}

bool PatchEditor::putBack(const QuadPatch& changed, const PatchJacobians& wanted,
                          FinishAct::Kind kind) {
  if (!openChart()) return false;
  std::vector<Point2> points = points_;
  for (std::size_t v = points.size(); v < changed.vertexCount(); ++v)
    points.push_back(points[changed.originOf(static_cast<Vertex>(v))]);
  return putBack(changed, std::move(points), wanted, kind);
}

bool PatchEditor::putBack(const QuadPatch& changed, std::vector<Point2> points,
                          const PatchJacobians& wanted, FinishAct::Kind kind) {
  smoothPatch(changed, points);
  const auto isWanted = [&] { return jacobiansOf(changed, points).areAtLeast(wanted); };
  if (!isWanted()) return false;
  bool allMoved = true;
  Moved moved(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (v < points_.size() && points[v] == points_[v]) continue;
    moved[v] = chart_->lift(points[v]);
    if (moved[v]) continue;
    if (v >= points_.size()) return false;
    points[v] = points_[v];  // the surface cannot be found there: it stays where it was
    allMoved = false;
  }
  if (!allMoved && !isWanted()) return false;
  if (!staysSoundOnSurface(changed, moved) || joinsAgain(changed)) return false;
  apply(changed, moved, kind);
  return true;
}

/// moved  null: the vertices are where they were
bool PatchEditor::isSound(const QuadPatch& patch, std::size_t element, const Moved* moved) const {
  std::array<const SurfacePoint*, 4> corners{};
  std::size_t n = 0;
  for (const Vertex v : patch.cornersAt(element))
    corners[n++] = moved && (*moved)[v] ? &*(*moved)[v] : &mesh_.vertices[vertices_[v].value];
  return std::isfinite(elementDistortion(std::span(corners).first(n)));
}

/// Whether all elements are sound on the surface that were so, and no more new ones are unsound
/// than were replaced: where the surface bends sharply within an element, none may be sound.
bool PatchEditor::staysSoundOnSurface(const QuadPatch& changed, const Moved& moved) const {
  std::ptrdiff_t mayBeUnsound = 0;
  for (std::size_t e = 0; e < changed.elementCount(); ++e) {
    const bool isReplaced = e < elements_.size() && changed.ringAt(e) != patch_.ringAt(e);
    if (isReplaced && !isSound(patch_, e, nullptr)) ++mayBeUnsound;
    if (!changed.isAlive(e) || isSound(changed, e, &moved)) continue;
    if (isNew(changed, e))
      --mayBeUnsound;
    else if (isSound(patch_, e, nullptr))
      return false;
  }
  return mayBeUnsound >= 0;
}

bool PatchEditor::isNew(const QuadPatch& changed, std::size_t element) const {
  return changed.isAlive(element) &&
         (element >= elements_.size() || changed.ringAt(element) != patch_.ringAt(element));
}

/// Whether a new side exists already outside of the patch.
bool PatchEditor::joinsAgain(const QuadPatch& changed) const {
  const auto joins = [&](Vertex u, Vertex v) {
    return u < vertices_.size() && v < vertices_.size() && !patch_.areJoined(u, v) &&
           topology_.areJoined(vertices_[u], vertices_[v]);
  };
  for (std::size_t e = 0; e < changed.elementCount(); ++e) {
    if (!isNew(changed, e)) continue;
    const auto ring = changed.cornersAt(e);
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (joins(ring[i], ring[(i + 1) % ring.size()])) return true;
  }
  return false;
}

void PatchEditor::apply(const QuadPatch& changed, const Moved& moved, FinishAct::Kind kind) {
  const std::size_t known = vertices_.size();
  for (std::size_t v = known; v < changed.vertexCount(); ++v) {
    vertices_.push_back(topology_.addVertex(*moved[v]));
    if (recorder_) recorder_->added(vertices_[v]);
  }
  std::vector<std::size_t> places;
  std::vector<Element> elements;
  for (std::size_t e = 0; e < changed.elementCount(); ++e) {
    const bool isOld = e < elements_.size();
    if (isOld && changed.ringAt(e) == patch_.ringAt(e)) continue;
    if (isOld) places.push_back(elements_[e]);
    if (!changed.isAlive(e)) continue;
    const auto ring = changed.cornersAt(e);
    Element& element = elements.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) element.corners[i] = vertices_[ring[i]];
  }
  for (const std::size_t e : places) addAngles(e, -1);
  if (recorder_) recorder_->begin(places);
  const std::vector<std::size_t> replaced = topology_.replace(places, elements);
  if (recorder_) recorder_->end(kind, replaced);
  for (const std::size_t e : replaced) addAngles(e, 1);
  for (std::size_t v = 0; v < known; ++v)
    if (moved[v]) move(vertices_[v], *moved[v]);
  points_.clear();
}

void PatchEditor::move(VertexId v, const SurfacePoint& point) {
  if (recorder_) {
    std::vector<std::size_t> star;
    topology_.forEachCornerOf(v, [&](Corner c) { star.push_back(c.element()); });
    recorder_->begin(star, v);
  }
  topology_.move(v, point);
  if (recorder_) recorder_->end(FinishAct::Kind::Move);
}

}  // namespace af2
