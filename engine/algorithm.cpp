#include "engine/algorithm.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include "engine/candidate_choice.h"
#include "engine/compiled_rules.h"
#include "engine/error.h"
#include "engine/front.h"
#include "engine/front_index.h"
#include "engine/front_queue.h"

namespace af2 {
namespace {

// ---- input -------------------------------------------------------------------------------------

bool isFinite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::string nameOf(VertexId id) { return "vertex " + std::to_string(id.value); }

void checkCorner(const FrontInput& input, const BoundaryCorner& corner, std::vector<Point3>& at,
                 std::vector<bool>& isKnown) {
  const std::size_t v = corner.vertex.value;
  if (v >= input.vertexCount)
    throw InputError("boundary: " + nameOf(corner.vertex) + " is not below the vertex count " +
                     std::to_string(input.vertexCount));
  if (!isFinite(corner.point.position) || !isFinite(corner.point.normal))
    throw InputError("boundary: " + nameOf(corner.vertex) +
                     " has a coordinate that is not a finite number");
  if (isKnown[v] && at[v] != corner.point.position)
    throw InputError("boundary: " + nameOf(corner.vertex) + " is given with two positions");
  at[v] = corner.point.position;
  isKnown[v] = true;
}

void checkInput(const FrontInput& input) {
  std::vector<Point3> at(input.vertexCount);
  std::vector<bool> isKnown(input.vertexCount, false);
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (const auto& loop : input.loops) {
    if (loop.size() < 2) throw InputError("boundary: a loop has fewer than two corners");
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryCorner& corner = loop[i];
      const BoundaryCorner& next = loop[(i + 1) % loop.size()];
      checkCorner(input, corner, at, isKnown);
      if (corner.vertex == next.vertex || corner.point.position == next.point.position)
        throw InputError("boundary: the edge from " + nameOf(corner.vertex) + " to " +
                         nameOf(next.vertex) + " has length zero");
      edges.emplace_back(corner.vertex, next.vertex);
    }
  }
  for (const BoundaryCorner& corner : input.isolated) {
    const bool isTaken = corner.vertex.value < isKnown.size() && isKnown[corner.vertex.value];
    checkCorner(input, corner, at, isKnown);
    if (isTaken)
      throw InputError("boundary: " + nameOf(corner.vertex) +
                       " is given as isolated, but it is on a loop or given before");
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if (twice != edges.end())
    throw InputError("boundary: the edge from " + nameOf(twice->first) + " to " +
                     nameOf(twice->second) + " is given twice in the same direction");
}

double sizeAt(const SizeField& field, const SurfacePoint& point) {
  const double size = field.sizeAt(point);
  if (!(size > 0) || !std::isfinite(size))
    throw InputError("size field: the wanted length at (" + std::to_string(point.position.x) +
                     ", " + std::to_string(point.position.y) + ", " +
                     std::to_string(point.position.z) + ") is " + std::to_string(size) +
                     "; it must be a positive number");
  return size;
}

struct Extent {
  Box3 box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
  double lengthSum = 0;
  std::size_t edges = 0;
};

Extent extentOf(const FrontInput& input) {
  Extent extent;
  const auto include = [&](const Point3& p) {
    Box3& box = extent.box;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  };
  for (const auto& loop : input.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      include(loop[i].point.position);
      extent.lengthSum +=
          distance(loop[i].point.position, loop[(i + 1) % loop.size()].point.position);
      ++extent.edges;
    }
  }
  return extent;
}

/// A region all of whose boundary lies in one plane, with one normal.
bool isFlat(const FrontInput& input, double diagonal) {
  constexpr double kRounding = 1e-9;
  const SurfacePoint& first = input.loops[0][0].point;
  if (first.normal == Point3{}) return false;
  for (const auto& loop : input.loops)
    for (const BoundaryCorner& corner : loop)
      if (distance(corner.point.normal, first.normal) > kRounding ||
          std::abs(dot(corner.point.position - first.position, first.normal)) >
              kRounding * diagonal)
        return false;
  return true;
}

double flatArea(const FrontInput& input) {
  const SurfacePoint& first = input.loops[0][0].point;
  double area = 0;
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      area += 0.5 *
              dot(first.normal, cross(loop[i].point.position - first.position,
                                      loop[(i + 1) % loop.size()].point.position - first.position));
  return area;
}

/// Of a flat region it can be told beforehand whether its boundary runs the right way round, and
/// where no vertex can lie: a front that runs outwards would never end.
std::optional<Box3> limitsOfFlatRegion(const FrontInput& input) {
  const Extent extent = extentOf(input);
  if (extent.edges == 0) return std::nullopt;
  const double diagonal = distance(extent.box.low, extent.box.high);
  if (!isFlat(input, diagonal)) return std::nullopt;
  if (!(flatArea(input) > 1e-15 * diagonal * diagonal))
    throw InputError(
        "boundary: its loops bound no area on their left, seen against the normals; turn round the "
        "loops that run the wrong way");
  const Point3 margin{diagonal, diagonal, diagonal};
  return Box3{extent.box.low - margin, extent.box.high + margin};
}

FrontIndex makeIndex(const FrontInput& input) {
  const Extent extent = extentOf(input);
  if (extent.edges == 0) return FrontIndex({}, 1);
  return FrontIndex(extent.box, extent.lengthSum / static_cast<double>(extent.edges));
}

// ---- one run -----------------------------------------------------------------------------------

/// How often the progress callback is called, in steps.
constexpr std::size_t kProgressInterval = 4096;
/// How many of the edges that are left are explained, when the front is stuck.
constexpr std::size_t kMostExplained = 100;

class Run {
 public:
  Run(const CompiledRules& rules, const AF2LocalTransformMaker& maker, const FrontInput& input,
      const SizeField& size, const MeshingOptions& options)
      : rules_(rules),
        maker_(maker),
        size_(size),
        options_(options),
        index_(makeIndex(input)),
        queue_(*rules.set().definition().order),
        choice_(rules, front_, index_, size, valence_) {
    result_.mesh.vertices.resize(input.vertexCount);
    valence_.resize(input.vertexCount, 0);
    if (const auto limits = limitsOfFlatRegion(input)) choice_.keepWithin(*limits);
    for (const auto& loop : input.loops) addLoop(loop);
    front_.untangle();
    for (std::size_t i = 0; i < front_.capacity(); ++i) enter(PlaceId(i));
    for (const BoundaryCorner& corner : input.isolated) addIsolated(corner);
  }

  MeshingResult execute() {
    std::size_t elementsAtLastRound = 0;
    do {
      elementsAtLastRound = result_.mesh.elements.size();
      advance();
      // What was stuck may have come free by what happened around it since.
    } while (result_.outcome != Outcome::Cancelled && !front_.isEmpty() &&
             result_.mesh.elements.size() > elementsAtLastRound && revive());
    finish();
    return std::move(result_);
  }

 private:
  void addLoop(const std::vector<BoundaryCorner>& loop) {
    std::vector<double> sizes;
    for (const BoundaryCorner& corner : loop) {
      sizes.push_back(sizeAt(size_, corner.point));
      result_.mesh.vertices[corner.vertex.value] = corner.point;
    }
    front_.addLoop(loop, sizes);
  }

  void addIsolated(const BoundaryCorner& corner) {
    result_.mesh.vertices[corner.vertex.value] = corner.point;
    index_.insert(front_, front_.addIsolated(corner, sizeAt(size_, corner.point)));
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
      step(base);
      ++result_.steps;
      if (options_.progress && result_.steps % kProgressInterval == 0)
        options_.progress({result_.mesh.elements.size(), front_.edgeCount()});
    }
  }

  void step(PlaceId base) {
    StepReport report;
    report.from = front_[base].vertex;
    report.to = front_[front_.next(base)].vertex;
    report.level = front_[base].level;
    std::vector<RuleRefusal> refusals;
    try {
      const StepChart chart = makeChart(base);
      if (options_.observer && options_.observer->wantsRefusals())
        refusals = choice_.explain(chart, base);
      if (const Application* application = choice_.choose(chart, base)) {
        report.applied = true;
        report.rule = application->rule->index;
        report.score = application->score;
        apply(base, *application);
      }
    } catch (const GeometryError&) {
      // No chart here: like an edge that no rule takes.
    }
    if (!report.applied) refuse(base);
    tell(report, refusals);
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

  void tell(StepReport& report, std::vector<RuleRefusal>& refusals) {
    if (!options_.observer) return;
    report.elements = result_.mesh.elements.size();
    report.frontEdges = front_.edgeCount();
    options_.observer->stepTaken(report);
    if (!options_.observer->wantsRefusals()) return;
    if (report.applied)
      std::erase_if(refusals, [&](const RuleRefusal& r) { return r.rule == report.rule; });
    options_.observer->rulesRefused(report, refusals);
  }

  void apply(PlaceId base, const Application& application) {
    const std::size_t firstNew = result_.mesh.vertices.size();
    addVertices(application);
    addElements(application, firstNew);
    makeWalk(base, application, firstNew);
    index_.erase(base);
    front_.replace(base, walk_, change_);
    for (PlaceId id : change_.removed) index_.erase(id);
    front_.release(change_);
    for (PlaceId id : change_.added) enter(id);
  }

  void addVertices(const Application& application) {
    for (const SurfacePoint& point : application.newPoints) {
      result_.mesh.vertices.push_back(point);
      valence_.push_back(0);
    }
  }

  void addElements(const Application& application, std::size_t firstNew) {
    const CompiledRule& rule = *application.rule;
    for (const RuleElement& wanted : rule.rule->definition().elements) {
      Element element;
      for (std::size_t i = 0; i < static_cast<std::size_t>(wanted.size()); ++i) {
        const int v = wanted.corners[i];
        element.corners[i] =
            v < rule.matchedCount
                ? front_[application.places[static_cast<std::size_t>(v)]].vertex
                : VertexId(firstNew + static_cast<std::size_t>(v - rule.matchedCount));
        std::uint8_t& valence = valence_[element.corners[i].value];
        if (valence < 255) ++valence;
      }
      result_.mesh.elements.push_back(element);
      result_.mesh.rule.push_back(rule.index);
    }
  }

  void makeWalk(PlaceId base, const Application& application, std::size_t firstNew) {
    const CompiledRule& rule = *application.rule;
    const std::int32_t layer = 1 + std::min(front_[base].layer, front_[front_.next(base)].layer);
    walk_.clear();
    for (std::int8_t v : rule.rule->replacement()) {
      if (v < rule.matchedCount) {
        const PlaceId id = application.places[static_cast<std::size_t>(v)];
        const Place& place = front_[id];
        walk_.push_back({id, place.vertex, place.point, place.size, place.layer});
        continue;
      }
      const auto k = static_cast<std::size_t>(v - rule.matchedCount);
      const SurfacePoint& point = application.newPoints[k];
      walk_.push_back({PlaceId(), VertexId(firstNew + k), point, sizeAt(size_, point), layer});
    }
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
    if (result_.outcome == Outcome::Cancelled) return;
    if (front_.isEmpty() && result_.unused.empty()) return;
    result_.outcome = Outcome::Stuck;
    forEachEdge([&](PlaceId id) { result_.stuck.push_back(stuckEdge(id)); });
  }

  StuckEdge stuckEdge(PlaceId id) {
    StuckEdge edge{front_[id].vertex, front_[front_.next(id)].vertex, front_[id].level, {}};
    if (result_.stuck.size() >= kMostExplained) return edge;
    try {
      edge.refusals = choice_.explain(makeChart(id), id);
    } catch (const GeometryError&) {
      for (std::size_t i = 0; i < rules_.rules().size(); ++i)
        edge.refusals.push_back({i, Refusal::Surface, {}, {}});
    }
    return edge;
  }

  const CompiledRules& rules_;
  const AF2LocalTransformMaker& maker_;
  const SizeField& size_;
  const MeshingOptions& options_;
  Front front_;
  FrontIndex index_;
  FrontQueue queue_;
  std::vector<std::uint8_t> valence_;  // elements at each vertex, up to 255
  CandidateChoice choice_;
  ChartSlot slot_;
  std::vector<WalkVertex> walk_;
  Front::Change change_;
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
                                    const SizeField& size, const MeshingOptions& options) const {
  checkInput(input);
  return Run(compiled_->rules, maker, input, size, options).execute();
}

}  // namespace af2
