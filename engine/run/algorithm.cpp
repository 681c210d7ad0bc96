#include "engine/run/algorithm.h"

#include <algorithm>
#include <limits>

#include "engine/base/error.h"
#include "engine/front/front.h"
#include "engine/front/front_index.h"
#include "engine/front/front_queue.h"
#include "engine/front/input_check.h"
#include "engine/run/covered_area.h"
#include "engine/run/front_acts.h"
#include "engine/run/observed_step.h"
#include "engine/run/stall_watch.h"
#include "engine/step/candidate_choice.h"
#include "engine/step/compiled_rules.h"

namespace af2 {
namespace {

/// When the front is stuck, the number of remaining edges for which reasons are collected.
constexpr std::size_t kMaxExplained = 100;
/// And of how many the front around them is kept.
constexpr std::size_t kMaxPieces = 10;

class Run {
 public:
  Run(const CompiledRules& rules, const AF2LocalTransformMaker& maker, const FrontInput& input,
      const SizeField& size, const FrontOptions& options)
      : rules_(rules),
        maker_(maker),
        input_(input),
        size_(size),
        options_(options),
        index_(makeIndex(input)),
        queue_(*rules.set().definition().order),
        choice_(rules, front_, index_, size, valence_),
        watch_(options),
        covered_(options.areaUnit),
        acts_(rules, {front_, index_, queue_, result_.mesh, elements_, maker}, size, valence_,
              options.observer) {
    makeRoom(input.vertexCount);
    result_.mesh.vertices.resize(input.vertexCount);
    valence_.resize(input.vertexCount, 0);
    choice_.askAboutWelds(acts_);
    if (!options.acceptReflex) choice_.refuseReflex();
    if (const auto limits = limitsOfFlatRegion(input)) choice_.keepWithin(*limits);
    for (const auto& loop : input.loops) addLoop(loop);
    front_.untangle();
    front_.fix(input.vertexCount);
    if (rules.set().definition().parity == Parity::Even) front_.keepLoops();
    for (std::size_t i = 0; i < front_.capacity(); ++i) enter(PlaceId(i));
    for (const BoundaryCorner& corner : input.isolated) addIsolated(corner);
  }

  MeshingResult execute() {
    std::size_t gainsAtLastRound = 0;
    if (options_.observer) options_.observer->frontBegun(input_);
    do {
      gainsAtLastRound = gains();
      advance();
      // Edges that were stuck may have become free through later changes around them.
    } while (result_.outcome == Outcome::Complete && !front_.isEmpty() &&
             ((gains() > gainsAtLastRound && revive()) || layPath()));
    result_.candidates = choice_.examined();
    finish();
    acts_.dropDeadVertices(result_);
    result_.acts = acts_.counts();
    if (options_.observer) options_.observer->frontEnded(result_.stuck.size());
    return std::move(result_);
  }

 private:
  void makeRoom(std::size_t givenVertices) {
    constexpr double kMargin = 1.1, kMax = 1 << 20;  // beyond that an estimate is not trusted
    if (!(options_.expectedElements > 0)) return;
    const auto elements =
        static_cast<std::size_t>(std::min(kMargin * options_.expectedElements, kMax));
    result_.mesh.elements.reserve(elements);
    result_.mesh.origins.reserve(elements);
    result_.mesh.vertices.reserve(givenVertices + elements / 2);
    valence_.reserve(givenVertices + elements / 2);
  }

  void addLoop(const std::vector<BoundaryCorner>& loop) {
    std::vector<double> sizes;
    for (const BoundaryCorner& corner : loop) {
      sizes.push_back(checkedSizeAt(size_, corner.point));
      result_.mesh.vertices[corner.vertex.value] = corner.point;
    }
    front_.addLoop(loop, sizes);
  }

  void addIsolated(const BoundaryCorner& corner) {
    result_.mesh.vertices[corner.vertex.value] = corner.point;
    index_.insert(front_, front_.addIsolated(corner, checkedSizeAt(size_, corner.point)));
  }

  void enter(PlaceId id) {
    index_.insert(front_, id);
    queue_.push(front_, id);
  }

  void advance() {
    for (PlaceId base = queue_.pop(front_); !base.isNone(); base = queue_.pop(front_)) {
      if (options_.stop.stop_requested()) {
        result_.outcome = Outcome::Cancelled;
        return;
      }
      if (acts_.haveRows() && acts_.endsRow(base)) {
        queue_.push(front_, base);
        acts_.finishRow();
        continue;
      }
      step(base);
      ++result_.steps;
      if (!watch_.isReportDue(result_.steps, choice_.examined())) continue;
      if (options_.progress)
        options_.progress({result_.mesh.elements.size(), front_.edgeCount(), choice_.examined(),
                           covered_.of(result_.mesh)});
      if (watch_.isStalled({result_.steps, choice_.examined(), gains(), front_.edgeCount()})) {
        result_.outcome = Outcome::Stuck;
        return;
      }
    }
  }

  /// What counts as progress: elements, and acts that shorten or divide loops.
  std::size_t gains() const {
    return result_.mesh.elements.size() + acts_.counts().welds + acts_.counts().paths;
  }

  void step(PlaceId base) {
    if (!options_.observer)
      return step(
          base, [](const StepChart&) {}, [](const Application&) {});
    ObservedStep observed(*options_.observer, front_, base);
    step(
        base, [&](const StepChart& chart) { observed.look(choice_, chart); },
        [&](const Application& application) { observed.note(application); });
    observed.tell(result_.mesh);
  }

  /// before  called with the chart, while the front is as it was
  /// chosen  called with what is about to be applied
  template <class Before, class Chosen>
  void step(PlaceId base, const Before& before, const Chosen& chosen) {
    bool isApplied = false;
    try {
      const StepChart chart = makeChart(base);
      before(chart);
      if (const Application* application = choice_.choose(chart, base)) {
        isApplied = true;
        chosen(*application);
        apply(base, *application);
      }
    } catch (const GeometryError&) {
      // There is no chart here: treat the edge like one that no rule takes.
    }
    if (!isApplied) refuse(base);
  }

  StepChart makeChart(PlaceId base) {
    const Place& a = front_[base];
    const Place& b = front_[a.next];
    const bool isWanted = rules_.set().definition().unit == ChartUnit::WantedLength;
    const double unit = isWanted ? 0.5 * (a.size + b.size) : front_.edgeLength(base);
    return {maker_.makeLocalTransformIn(slot_, a.point, b.point, unit), unit};
  }

  void refuse(PlaceId base) {
    ++result_.failedSteps;
    if (front_[base].level >= rules_.set().maxLevel()) return;
    front_.raiseLevel(base);
    queue_.push(front_, base);
  }

  void apply(PlaceId base, const Application& application) {
    if (application.rule->rule->definition().weld) {
      acts_.weld(change_);
    } else {
      const std::size_t firstNew = result_.mesh.vertices.size();
      const std::size_t firstElement = result_.mesh.elements.size();
      addVertices(application);
      addElements(application, front_[base].level, firstNew);
      acts_.enter(firstElement);
      const std::span<const WalkVertex> walk = makeWalk(base, application, firstNew);
      if (acts_.haveRows()) useUpCounts(base);
      index_.erase(base);
      front_.replace(base, walk, change_);
    }
    takeChange();
  }

  /// The front has changed as `change_` tells.
  void takeChange() {
    for (PlaceId id : change_.removed) index_.erase(id);
    front_.release(change_);
#ifdef AF2_DEBUG_CHECKS
    AF2_CHECK(!front_.loops().areNumbered() || front_.loops().areSound(front_),
              "loops have the sizes and colours that are kept for them");
#endif
    for (PlaceId id : change_.added) enter(id);
    if (!queue_.isRenewed() || change_.added.empty()) return;
    // The edges beside those that have just entered. Ages increase, so these are the older ones.
    const std::uint32_t entered = front_[change_.added.front()].age;
    for (PlaceId id : change_.added)
      for (const PlaceId beside : {front_.previous(id), front_.next(id)})
        if (front_[beside].age < entered) queue_.renew(front_, beside);
  }

  /// An element at each end of the base fills one of the parts that the end wants.
  void useUpCounts(PlaceId base) {
    for (const PlaceId end : {base, front_.next(base)})
      if (front_[end].ownCount > 0) --front_[end].ownCount;
  }

  /// Where no edge can be advanced: divides a loop by a path, if a rule says how.
  bool layPath() {
    if (!acts_.layPath(change_)) return false;
    takeChange();
    return revive();
  }

  void addVertices(const Application& application) {
    for (const LiftedPoint& lifted : application.newPoints) {
      result_.mesh.vertices.push_back(*lifted.point);
      valence_.push_back(0);
    }
  }

  void addElements(const Application& application, int level, std::size_t firstNew) {
    const CompiledRule& rule = *application.rule;
    constexpr int kMaxLevel = std::numeric_limits<std::uint8_t>::max();
    const ElementOrigin origin{static_cast<std::uint16_t>(rule.index),
                               static_cast<std::uint8_t>(std::min(level, kMaxLevel))};
    for (const RuleElement& wanted : rule.rule->definition().elements) {
      Element element;
      for (std::size_t i = 0; i < static_cast<std::size_t>(wanted.size()); ++i) {
        const int v = wanted.corners[i];
        element.corners[i] =
            v < rule.matchedCount
                ? front_[application.open.places[static_cast<std::size_t>(v)]].vertex
                : VertexId(firstNew + static_cast<std::size_t>(v - rule.matchedCount));
        std::uint8_t& valence = valence_[element.corners[i].value];
        if (valence < 255) ++valence;
      }
      result_.mesh.elements.push_back(element);
      result_.mesh.origins.push_back(origin);
    }
  }

  /// The layer of a new vertex on the walk. In sets that keep loops even, whose elements stand in
  /// rows, it is one above the vertex on which it stands; else one above the lower end of the base.
  std::int32_t newLayer(PlaceId base, const Application& application, std::size_t at) const {
    const std::int32_t layerA = front_[base].layer, layerB = front_[front_.next(base)].layer;
    if (!front_.loops().areNumbered()) return 1 + std::min(layerA, layerB);
    const auto& walk = application.rule->rule->replacement();
    std::int32_t lowest = std::max(layerA, layerB);
    const auto standsOn = [&](int v) {
      if (v < application.rule->matchedCount)
        lowest =
            std::min(lowest, front_[application.open.places[static_cast<std::size_t>(v)]].layer);
    };
    standsOn(at == 0 ? 0 : walk[at - 1]);
    standsOn(at + 1 == walk.size() ? 1 : walk[at + 1]);
    return 1 + lowest;
  }

  /// Writes over what earlier steps have left in `walk_`: to begin with empty vertices would cost
  /// as much again.
  std::span<const WalkVertex> makeWalk(PlaceId base, const Application& application,
                                       std::size_t firstNew) {
    const CompiledRule& rule = *application.rule;
    const auto& vertices = rule.rule->replacement();
    if (walk_.size() < vertices.size()) walk_.resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      WalkVertex& w = walk_[i];
      const int v = vertices[i];
      if (v < rule.matchedCount) {
        const Place& place = front_[application.open.places[static_cast<std::size_t>(v)]];
        w.existing = application.open.joined[i];
        w.vertex = place.vertex;
        w.point = place.point;
        w.size = place.size;
        w.layer = place.layer;
        continue;
      }
      const auto k = static_cast<std::size_t>(v - rule.matchedCount);
      w.existing = PlaceId();
      w.vertex = VertexId(firstNew + k);
      w.point = *application.newPoints[k].point;
      w.size = checkedSizeAt(size_, w.point);
      w.layer = newLayer(base, application, i);
    }
    return {walk_.data(), vertices.size()};
  }

  template <class Visit>
  void forEachEdge(Visit&& visit) const {
    for (std::size_t i = 0; i < front_.capacity(); ++i)
      if (front_.hasEdge(PlaceId(i))) visit(PlaceId(i));
  }

  bool revive() {
    std::vector<PlaceId> edges;
    forEachEdge([&](PlaceId id) { edges.push_back(id); });
    std::sort(edges.begin(), edges.end(),
              [&](PlaceId p, PlaceId q) { return front_[p].age < front_[q].age; });
    for (PlaceId id : edges) {
      front_[id].level = 1;
      queue_.push(front_, id);
    }
    return !edges.empty();
  }

  void finish() {
    for (std::size_t i = 0; i < front_.capacity(); ++i)
      if (front_.isUsed(PlaceId(i)) && front_.isIsolated(PlaceId(i)))
        result_.unused.push_back(front_[PlaceId(i)].vertex);
    if (result_.outcome == Outcome::Cancelled) {
      forEachEdge([&](PlaceId id) {
        const Place& from = front_[id];
        if (from.level > 1)
          result_.stuck.push_back({from.vertex, front_[from.next].vertex, from.level, {}, {}});
      });
      return;
    }
    if (front_.isEmpty() && result_.unused.empty()) return;
    result_.outcome = Outcome::Stuck;
    forEachEdge([&](PlaceId id) { result_.stuck.push_back(stuckEdge(id)); });
  }

  StuckEdge stuckEdge(PlaceId id) {
    StuckEdge edge{front_[id].vertex, front_[front_.next(id)].vertex, front_[id].level, {}, {}};
    if (result_.stuck.size() >= kMaxExplained) return edge;
    try {
      const StepChart chart = makeChart(id);
      edge.refusals = choice_.explain(chart, id);
      if (result_.stuck.size() < kMaxPieces) edge.around = frontAround(front_, chart, id);
    } catch (const GeometryError&) {
      for (std::size_t i = 0; i < rules_.rules().size(); ++i)
        edge.refusals.push_back({i, Refusal::Surface, {}, {}});
    }
    return edge;
  }

  const CompiledRules& rules_;
  const AF2LocalTransformMaker& maker_;
  const FrontInput& input_;
  const SizeField& size_;
  const FrontOptions& options_;
  Front front_;
  FrontIndex index_;
  FrontQueue queue_;
  std::vector<std::uint8_t> valence_;  // number of elements at each vertex, at most 255
  CandidateChoice choice_;
  StallWatch watch_;
  CoveredArea covered_;
  ChartSlot slot_;
  std::vector<WalkVertex> walk_;  // as many as the longest walk had
  Front::Change change_;
  VertexElements elements_;
  FrontActs acts_;
  MeshingResult result_;
};

}  // namespace

struct AF2Algorithm::Compiled {
  std::shared_ptr<const RuleSet> set;
  CompiledRules rules;
  explicit Compiled(std::shared_ptr<const RuleSet> s) : set(std::move(s)), rules(*set) {}
};

AF2Algorithm::AF2Algorithm(std::shared_ptr<const RuleSet> rules) {
  if (!rules) throw InputError("AF2Algorithm: no rule set is given");
  compiled_ = std::make_unique<const Compiled>(std::move(rules));
}

AF2Algorithm::~AF2Algorithm() = default;
AF2Algorithm::AF2Algorithm(AF2Algorithm&&) noexcept = default;
AF2Algorithm& AF2Algorithm::operator=(AF2Algorithm&&) noexcept = default;

const RuleSet& AF2Algorithm::rules() const { return *compiled_->set; }

MeshingResult AF2Algorithm::execute(const AF2LocalTransformMaker& maker, const FrontInput& input,
                                    const SizeField& size, const FrontOptions& options) const {
  checkInput(input);
  return Run(compiled_->rules, maker, input, size, options).execute();
}

}  // namespace af2
