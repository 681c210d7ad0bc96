#include "engine/run/front_acts.h"

#include <algorithm>

#include "engine/front/input_check.h"
#include "engine/run/columns.h"
#include "engine/run/loop_path.h"
#include "engine/run/row_smoothing.h"

namespace af2 {
namespace {

bool hasWelds(const RuleSetDefinition& set) {
  return std::ranges::any_of(
      set.rules, [](const AF2Rule& rule) { return rule.definition().weld.has_value(); });
}

void renumber(StuckEdge& edge, const auto& renumberVertex) {
  renumberVertex(edge.from);
  renumberVertex(edge.to);
  for (RuleRefusal& refusal : edge.refusals) {
    renumberVertex(refusal.from);
    renumberVertex(refusal.to);
    for (VertexId& v : refusal.matched) renumberVertex(v);
  }
  for (VertexId& v : edge.around.ids) renumberVertex(v);
}

}  // namespace

FrontActs::FrontActs(const CompiledRules& rules, const Advance& advance, const SizeField& size,
                     std::vector<std::uint8_t>& valence, AF2MeshingObserver* observer)
    : rules_(rules),
      set_(rules.set().definition()),
      advance_(advance),
      size_(size),
      valence_(valence),
      observer_(observer),
      needsElements_(set_.rowRounds > 0 || hasWelds(set_)) {}

bool FrontActs::endsRow(PlaceId base) {
  const Front& front = advance_.front;
  const std::int32_t row = (front[base].layer + front[front.next(base)].layer) / 2;
  if (row <= row_) return false;
  row_ = row;
  return true;
}

void FrontActs::finishRow() {
  ++counts_.rows;
  if (set_.rowRounds > 0) {
    const std::size_t moves = smoothRow(advance_, set_.rowRounds);
    counts_.moves += moves;
    tell({FrontAct::Kind::Row, {}, {}, moves});
  }
  if (!set_.columns) return;
  const std::size_t columns = planColumns(advance_.front, advance_.queue, *set_.columns, valence_);
  counts_.columns += columns;
  tell({FrontAct::Kind::Columns, {}, {}, columns});
}

bool FrontActs::allows(const StepChart& chart, PlaceId first, const Application& application) {
  const RuleDefinition& rule = application.rule->rule->definition();
  const PlaceId from = application.open.places[static_cast<std::size_t>(rule.weld->from)];
  weld_ = planWeld(advance_, chart, first, from == first, *application.newPoints[0].point);
  return weld_.has_value();
}

void FrontActs::weld(Front::Change& change) {
  af2::apply(advance_, *weld_, change);
  // These edges enter again with the change.
  for (const PlaceId id : change.added) advance_.index.erase(id);
  std::uint8_t& valence = valence_[weld_->into.value];
  valence = static_cast<std::uint8_t>(std::min(255, valence + valence_[weld_->from.value]));
  dead_.push_back(weld_->from);
  ++counts_.welds;
  tell({FrontAct::Kind::Weld, weld_->from, weld_->into, 1});
}

void FrontActs::dropDeadVertices(MeshingResult& result) {
  if (dead_.empty()) return;
  std::ranges::sort(dead_);
  Mesh& mesh = result.mesh;
  std::vector<VertexId> renumbered(mesh.vertices.size());
  std::size_t next = 0;
  auto dead = dead_.begin();
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (dead != dead_.end() && dead->value == v) {
      ++dead;
      continue;
    }
    mesh.vertices[next] = mesh.vertices[v];
    renumbered[v] = VertexId(next++);
  }
  mesh.vertices.resize(next);
  const auto renumberVertex = [&](VertexId& v) {
    if (!v.isNone()) v = renumbered[v.value];
  };
  for (Element& element : mesh.elements)
    for (VertexId& v : element.corners) renumberVertex(v);
  for (StuckEdge& edge : result.stuck) renumber(edge, renumberVertex);
}

bool FrontActs::layPath(Front::Change& change) {
  const auto path = bestPath(advance_, rules_, size_, valence_);
  if (!path) return false;
  const Place from = advance_.front[path->from], to = advance_.front[path->to];
  const std::int32_t layer = 1 + std::min(from.layer, to.layer);
  std::vector<WalkVertex> walk;
  for (const SurfacePoint& point : path->points) {
    walk.push_back({PlaceId(), VertexId(advance_.mesh.vertices.size()), point,
                    checkedSizeAt(size_, point), layer});
    advance_.mesh.vertices.push_back(point);
    valence_.push_back(0);
  }
  // There and back again.
  const std::vector<WalkVertex> there = walk;
  walk.push_back({path->to, to.vertex, to.point, to.size, to.layer});
  walk.insert(walk.end(), there.rbegin(), there.rend());
  walk.push_back({PlaceId(), from.vertex, from.point, from.size, from.layer});
  advance_.index.erase(path->from);
  advance_.front.replace(path->from, walk, change);
  ++counts_.paths;
  tell({FrontAct::Kind::Path, from.vertex, to.vertex, path->points.size() + 1});
  return true;
}

}  // namespace af2
