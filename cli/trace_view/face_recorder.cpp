#include "cli/trace_view/face_recorder.h"

#include <algorithm>
#include <tuple>

#include "cli/trace_view/step_chart.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

/// Vertices of different numberings are the same if their positions are.
using Key = std::tuple<double, double, double>;
Key keyOf(const Point3& p) { return {p.x, p.y, p.z}; }

}  // namespace

void FaceRecorder::frontBegun(const FrontInput& input) {
  ViewFront front;
  front.firstVertex = record_.vertices.size();
  front.vertexCount = front.given = input.vertexCount;
  front.firstEvent = static_cast<std::int32_t>(record_.events.size());
  record_.vertices.resize(front.firstVertex + front.given);
  const auto place = [&](const BoundaryCorner& corner) {
    record_.vertices[front.firstVertex + corner.vertex.value] = corner.point.position;
  };
  for (const auto& loop : input.loops) std::ranges::for_each(loop, place);
  std::ranges::for_each(input.isolated, place);
  places_.assign(record_.vertices.end() - static_cast<std::ptrdiff_t>(front.given),
                 record_.vertices.end());
  isDead_.assign(front.given, false);
  record_.fronts.push_back(std::move(front));
  alive_.emplace_back();
  numbers_.emplace_back();
}

ViewEvent& FaceRecorder::addEvent(std::size_t kind, std::size_t front) {
  ViewEvent& event = record_.events.emplace_back();
  event.kind = static_cast<std::uint8_t>(kind);
  event.front = static_cast<std::int32_t>(front);
  return event;
}

void FaceRecorder::stepTaken(const StepReport& step) {
  ++step_;
  made_.clear();
  const auto first = static_cast<std::uint32_t>(record_.fronts.back().firstVertex);
  ViewEvent& event =
      addEvent(step.applied ? ViewEvent::kApplied : ViewEvent::kRefused, record_.fronts.size() - 1);
  event.level = static_cast<std::uint8_t>(std::min(step.level, 255));
  event.from = first + step.from.value;
  event.to = first + step.to.value;
  event.after = static_cast<float>(step.frontEdges);
  if (!step.applied) return;
  event.rule = static_cast<std::int32_t>(step.rule);
  event.before = static_cast<float>(step.score);
}

void FaceRecorder::takeVertices(const Mesh& mesh) {
  ViewFront& front = record_.fronts.back();
  for (; front.vertexCount < mesh.vertices.size(); ++front.vertexCount) {
    record_.vertices.push_back(mesh.vertices[front.vertexCount].position);
    places_.push_back(record_.vertices.back());
    isDead_.push_back(false);
  }
}

/// The last event moves a vertex.
void FaceRecorder::move(std::uint32_t number, const Point3& to) {
  ++record_.events.back().moves;
  record_.moved.push_back(number);
  record_.moves.push_back(to);
}

void FaceRecorder::frontActed(const FrontAct& act, const Mesh& mesh) {
  takeVertices(mesh);
  if (act.kind == FrontAct::Kind::Weld) welded_ = act;
  if (act.kind != FrontAct::Kind::Row || act.count == 0) return;
  ViewEvent& event = addEvent(ViewEvent::kRow, record_.fronts.size() - 1);
  event.from = event.to = ViewElement::kNoVertex;
  const auto first = static_cast<std::uint32_t>(record_.fronts.back().firstVertex);
  for (std::uint32_t v = 0; v < places_.size(); ++v) {
    const Point3& place = mesh.vertices[v].position;
    if (place == places_[v]) continue;
    places_[v] = place;
    move(first + v, place);
  }
}

/// Elements at the vertex that is gone have the other one instead, which may have moved.
void FaceRecorder::weld(const Mesh& mesh) {
  const std::size_t f = record_.fronts.size() - 1;
  const VertexId from = welded_->vertex, into = welded_->other;
  std::vector<Element> changed;
  for (const auto& [corners, number] : alive_[f])
    if (std::ranges::count(corners, from) > 0) changed.push_back({corners});
  for (Element element : changed) {
    bury(element, f);
    std::ranges::replace(element.corners, from, into);
    bear(element, f);
  }
  isDead_[from.value] = true;
  const Point3& place = mesh.vertices[into.value].position;
  if (place != places_[into.value]) move(numberOf(into, f), place);
  places_[into.value] = place;
  welded_.reset();
}

/// The mesh of the front has no vertices that were welded into others.
void FaceRecorder::frontEnded(std::size_t edgesLeft) {
  ViewFront& front = record_.fronts.back();
  front.edgesLeft = edgesLeft;
  std::vector<VertexId> renumbered(places_.size());
  for (std::size_t v = 0; v < places_.size(); ++v) {
    if (isDead_[v]) continue;
    renumbered[v] = VertexId(front.places.size());
    front.places.push_back(places_[v]);
    numbers_.back().push_back(static_cast<std::uint32_t>(front.firstVertex + v));
  }
  Alive alive;
  for (auto& [corners, number] : alive_.back()) {
    Corners now = corners;
    for (VertexId& v : now)
      if (!v.isNone()) v = renumbered[v.value];
    alive[now] = number;
  }
  alive_.back() = std::move(alive);
}

void FaceRecorder::meshGrown(const StepReport& step, const Mesh& mesh) {
  takeVertices(mesh);
  if (welded_) weld(mesh);
  const std::size_t count = rules_.rules()[step.rule].definition().elements.size();
  made_.assign(mesh.elements.end() - static_cast<std::ptrdiff_t>(count), mesh.elements.end());
  for (const Element& element : made_) bear(element, record_.fronts.size() - 1);
}

void FaceRecorder::frontAround(const StepReport& step, const LocalFront& around) {
  record_.events.back().chart = static_cast<std::int32_t>(record_.charts.size());
  record_.charts.push_back(stepChart(rules_, {step, around, refusals_, made_}));
}

void FaceRecorder::bear(const Element& element, std::size_t front) {
  alive_[front][element.corners] = record_.elements.size();
  ViewElement& made = record_.elements.emplace_back();
  made.corners.fill(ViewElement::kNoVertex);
  for (std::size_t i = 0; i < element.vertices().size(); ++i)
    made.corners[i] = numberOf(element.corners[i], front);
  made.birth = now();
}

void FaceRecorder::bury(const Element& element, std::size_t front) {
  const auto found = alive_[front].find(element.corners);
  if (found == alive_[front].end()) return;
  record_.elements[found->second].death = now();
  alive_[front].erase(found);
}

bool FaceRecorder::isOf(const Mesh& mesh, const ViewFront& front) const {
  return !front.isFinished &&
         std::ranges::equal(mesh.vertices, front.places, {}, &SurfacePoint::position);
}

/// The last front if it has most vertices of a mesh: inverted elements were turned round then,
/// which becomes an event. Vertices that moved are new ones of the record.
std::size_t FaceRecorder::turnedFront(const Mesh& mesh) {
  const std::size_t f = record_.fronts.size() - 1;
  if (record_.fronts.empty() || record_.fronts[f].isFinished) return kNone;
  ViewFront& front = record_.fronts[f];
  std::map<Key, std::uint32_t> known;
  for (std::size_t v = 0; v < front.places.size(); ++v)
    known.emplace(keyOf(front.places[v]), numbers_[f][v]);
  const auto isKnown = [&](const SurfacePoint& v) { return known.contains(keyOf(v.position)); };
  const auto found = static_cast<std::size_t>(std::ranges::count_if(mesh.vertices, isKnown));
  if (2 * found < mesh.vertices.size()) return kNone;
  numbers_[f].clear();
  front.places.clear();
  for (const SurfacePoint& vertex : mesh.vertices) {
    const auto next = static_cast<std::uint32_t>(record_.vertices.size());
    const auto number = known.emplace(keyOf(vertex.position), next).first->second;
    if (number == next) record_.vertices.push_back(vertex.position);
    numbers_[f].push_back(number);
    front.places.push_back(vertex.position);
  }
  addEvent(ViewEvent::kTurnedRound, f);
  replaceElements(mesh, f);
  return f;
}

/// The last event leaves a front with the elements of a mesh.
void FaceRecorder::replaceElements(const Mesh& mesh, std::size_t f) {
  std::map<std::array<std::uint32_t, 4>, std::size_t> old;
  for (const auto& [corners, element] : alive_[f])
    old.emplace(record_.elements[element].corners, element);
  alive_[f].clear();
  for (const Element& element : mesh.elements) {
    std::array<std::uint32_t, 4> corners;
    corners.fill(ViewElement::kNoVertex);
    std::ranges::transform(element.vertices(), corners.begin(),
                           [&](VertexId v) { return numbers_[f][v.value]; });
    const auto same = old.find(corners);
    if (same == old.end()) {
      bear(element, f);
      continue;
    }
    alive_[f][element.corners] = same->second;
    old.erase(same);
  }
  for (const auto& [corners, element] : old) record_.elements[element].death = now();
}

/// The best of several attempts is finished, which need not be the last one. A strip along a cut,
/// and a face that was laid out in a plane, belong to no front.
void FaceRecorder::finishBegun(const Mesh& mesh) {
  finishing_ = kNone;
  added_.clear();
  for (std::size_t f = record_.fronts.size(); f-- > 0 && finishing_ == kNone;)
    if (isOf(mesh, record_.fronts[f])) finishing_ = f;
  if (finishing_ == kNone) finishing_ = turnedFront(mesh);
  record_.missesChanges = record_.missesChanges || finishing_ == kNone;
  if (finishing_ == kNone) return;
  record_.fronts[finishing_].isFinished = true;
  const auto isNew = [&](const Element& e) { return !alive_[finishing_].contains(e.corners); };
  if (std::ranges::none_of(mesh.elements, isNew)) return;
  addEvent(ViewEvent::kClosedWithoutRule, finishing_);
  for (const Element& element : mesh.elements)
    if (isNew(element)) bear(element, finishing_);
}

void FaceRecorder::vertexAdded(VertexId v, const Point3& place) {
  if (finishing_ == kNone) return;
  AF2_CHECK(v.value == numbers_[finishing_].size() + added_.size(),
            "vertices are added one after the other");
  added_.push_back(record_.vertices.size());
  record_.vertices.push_back(place);
}

/// Of a vertex of the front that runs, or of the mesh of one that has ended. Vertices that were
/// added while the front was finished are apart from the others.
std::uint32_t FaceRecorder::numberOf(VertexId v, std::size_t front) const {
  const auto& numbers = numbers_[front];
  if (numbers.empty())
    return static_cast<std::uint32_t>(record_.fronts[front].firstVertex + v.value);
  return v.value < numbers.size() ? numbers[v.value]
                                  : static_cast<std::uint32_t>(added_[v.value - numbers.size()]);
}

void FaceRecorder::actKept(const FinishAct& act) {
  if (finishing_ == kNone) return;
  ViewEvent& event =
      addEvent(ViewEvent::kFirstAct + static_cast<std::size_t>(act.kind), finishing_);
  event.before = static_cast<float>(act.worstBefore);
  event.after = static_cast<float>(act.worstAfter);
  event.from = act.vertex.isNone() ? ViewElement::kNoVertex : numberOf(act.vertex, finishing_);
  if (act.kind == FinishAct::Kind::Move) return move(event.from, act.to);
  for (const Element& element : act.before) bury(element, finishing_);
  for (const Element& element : act.after) bear(element, finishing_);
}

void FaceRecorder::finishEnded(const Mesh& mesh, bool isSound) {
  if (finishing_ == kNone) return;
  ViewFront& front = record_.fronts[finishing_];
  front.places.clear();
  for (const SurfacePoint& vertex : mesh.vertices) front.places.push_back(vertex.position);
  if (!isSound) front.kept = ViewFront::Kept::No;
  finishing_ = kNone;
}

void FaceRecorder::addClosing(const geometry::ModelMesh& mesh) {
  for (std::size_t f = 0; f < record_.fronts.size(); ++f) {
    const ViewFront& front = record_.fronts[f];
    if (front.kept == ViewFront::Kept::Yes && front.edgesLeft > 0 && !front.isFinished)
      close(f, mesh);
  }
}

/// Vertices of the mesh are known by their positions.
void FaceRecorder::close(std::size_t f, const geometry::ModelMesh& mesh) {
  const ViewFront& front = record_.fronts[f];
  std::map<Key, VertexId> vertices;
  for (std::size_t v = 0; v < front.places.size(); ++v)
    vertices.emplace(keyOf(front.places[v]), VertexId(v));
  std::vector<Element> closing;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.face[e] != record_.face) continue;
    Element element;
    const auto corners = mesh.elements[e].vertices();
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (const auto found = vertices.find(keyOf(mesh.vertices[corners[i].value]));
          found != vertices.end())
        element.corners[i] = found->second;
    if (hasProperCorners(element, front.places.size()) && !alive_[f].contains(element.corners))
      closing.push_back(element);
  }
  if (closing.empty()) return;
  addEvent(ViewEvent::kClosedWithoutRule, f);
  for (const Element& element : closing) bear(element, f);
}

}  // namespace af2::cli
