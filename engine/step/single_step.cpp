#include "engine/step/single_step.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "engine/base/error.h"
#include "engine/step/candidate_choice.h"
#include "engine/surface/plane_chart.h"

namespace af2 {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

BoundaryCorner cornerAt(const FrontPiece& piece, std::size_t v) {
  if (v >= piece.vertices.size())
    throw InputError("piece of front: there is no vertex " + std::to_string(v));
  const Point2 p = piece.vertices[v];
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw InputError("piece of front: vertex " + std::to_string(v) +
                     " is not at a finite position");
  return {VertexId(v), {{p.x, p.y, 0}, {0, 0, 1}, p.x, p.y}};
}

bool isClosed(const std::vector<std::size_t>& chain) {
  return chain.size() > 2 && chain.front() == chain.back();
}

/// A front, its index, and the place of each edge.
struct Scene {
  Front front;
  FrontIndex index;
  std::set<Edge> edges;
  std::vector<std::pair<PlaceId, bool>> colours;  ///< of the piece, by place
  PlaceId base;

  explicit Scene(const FrontPiece& piece) : index({}, piece.size) {
    for (const auto& chain : piece.chains) addChain(piece, chain);
    for (std::size_t v : piece.isolated)
      index.insert(front, front.addIsolated(cornerAt(piece, v), piece.size));
    if (base.isNone()) throw InputError("piece of front: the base is not one of the edges");
    front[base].level = piece.level;
  }

  void addChain(const FrontPiece& piece, const std::vector<std::size_t>& chain) {
    if (chain.size() < 2) throw InputError("piece of front: a chain has fewer than two vertices");
    const std::size_t count = isClosed(chain) ? chain.size() - 1 : chain.size();
    std::vector<BoundaryCorner> corners;
    for (std::size_t i = 0; i < count; ++i) corners.push_back(cornerAt(piece, chain[i]));
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Edge edge{chain[i], chain[i + 1]};
      if (cornerAt(piece, edge.first).point.position == cornerAt(piece, edge.second).point.position)
        throw InputError("piece of front: an edge has length zero");
      if (!edges.insert(edge).second) throw InputError("piece of front: an edge is given twice");
    }
    const std::vector<double> sizes(count, piece.size);
    const PlaceId first =
        isClosed(chain) ? front.addLoop(corners, sizes) : front.addOpenChain(corners, sizes);
    for (std::size_t i = 0; i < count; ++i) {
      const PlaceId id(first.value + i);
      index.insert(front, id);
      if (i + 1 < chain.size() && Edge{chain[i], chain[i + 1]} == piece.base) base = id;
      for (const auto& [vertex, colour] : piece.colours)
        if (vertex == chain[i] && !isClosed(chain)) colours.emplace_back(id, colour);
    }
  }
};

/// The directed edges after the new elements have consumed theirs and added their reverses.
std::vector<Edge> frontAfter(std::set<Edge> edges,
                             const std::vector<std::vector<std::size_t>>& elements) {
  for (const auto& element : elements) {
    for (std::size_t i = 0; i < element.size(); ++i) {
      const Edge edge{element[i], element[(i + 1) % element.size()]};
      if (edges.erase(edge) == 0) edges.insert({edge.second, edge.first});
    }
  }
  return {edges.begin(), edges.end()};
}

/// The same after a weld: the edges at the middle vertex are gone.
std::vector<Edge> frontAfterWeld(const std::set<Edge>& edges, std::size_t middle, std::size_t from,
                                 std::size_t into) {
  std::set<Edge> after;
  for (auto [start, end] : edges) {
    if ((start == middle && (end == from || end == into)) ||
        (end == middle && (start == from || start == into)))
      continue;
    after.insert({start == from ? into : start, end == from ? into : end});
  }
  return {after.begin(), after.end()};
}

void describe(SingleStep& step, const Scene& scene, const FrontPiece& piece,
              const Application& application) {
  const CompiledRule& rule = *application.rule;
  step.rule = rule.index;
  step.score = application.score;
  for (PlaceId id : application.open.places) step.matched.push_back(scene.front[id].vertex.value);
  for (const LiftedPoint& lifted : application.newPoints)
    step.newVertices.push_back({lifted.point->position.x, lifted.point->position.y});
  if (const auto& weld = rule.rule->definition().weld)
    step.welded.emplace(step.matched[static_cast<std::size_t>(weld->from)],
                        step.matched[static_cast<std::size_t>(weld->into)]);
  for (const RuleElement& wanted : rule.rule->definition().elements) {
    std::vector<std::size_t> element;
    for (std::size_t i = 0; i < static_cast<std::size_t>(wanted.size()); ++i) {
      const auto v = static_cast<std::size_t>(wanted.corners[i]);
      const auto matched = static_cast<std::size_t>(rule.matchedCount);
      element.push_back(v < matched ? step.matched[v] : piece.vertices.size() + v - matched);
    }
    step.elements.push_back(std::move(element));
  }
}

/// The query at the base edge of a piece.
class Question {
 public:
  Question(const CompiledRules& rules, const FrontPiece& piece)
      : scene_(piece),
        size_(piece.size),
        valence_(piece.vertices.size(), 0),
        unit_(rules.set().definition().unit == ChartUnit::WantedLength
                  ? piece.size
                  : scene_.front.edgeLength(scene_.base)),
        plane_(scene_.front[scene_.base].point, scene_.front[scene_.front.next(scene_.base)].point,
               {0, 0, 1}, unit_),
        chart_(plane_, unit_),
        choice_(rules, scene_.front, scene_.index, size_, valence_) {
    scene_.front.fix(piece.vertices.size());
    if (rules.set().definition().parity == Parity::Even) {
      scene_.front.keepLoops();
      scene_.front.joinChains(scene_.colours);
    }
  }

  const Scene& scene() const { return scene_; }
  const Application* choose() { return choice_.choose(chart_, scene_.base); }
  std::vector<RuleRefusal> explain() { return choice_.explain(chart_, scene_.base); }
  std::vector<RuleRefusal> obstacles() { return choice_.obstacles(chart_, scene_.base); }

 private:
  Scene scene_;
  UniformSize size_;
  std::vector<std::uint8_t> valence_;
  double unit_;
  PlaneChart plane_;
  StepChart chart_;
  CandidateChoice choice_;
};

}  // namespace

SingleStepper::SingleStepper(const RuleSet& rules)
    : compiled_(std::make_unique<const CompiledRules>(rules)) {}

SingleStepper::~SingleStepper() = default;

const CompiledRules& SingleStepper::compiledFor(const FrontPiece& piece) const {
  const int maxLevel = compiled_->set().maxLevel();
  if (!(piece.size > 0) || !std::isfinite(piece.size))
    throw InputError("piece of front: the size must be a positive number");
  if (piece.level < 1 || piece.level > maxLevel)
    throw InputError("piece of front: the level must be between 1 and " + std::to_string(maxLevel));
  return *compiled_;
}

std::optional<std::size_t> SingleStepper::chosenRule(const FrontPiece& piece) const {
  Question question(compiledFor(piece), piece);
  const Application* application = question.choose();
  if (!application) return std::nullopt;
  return application->rule->index;
}

std::vector<RuleRefusal> SingleStepper::obstacles(const FrontPiece& piece) const {
  return Question(compiledFor(piece), piece).obstacles();
}

SingleStep SingleStepper::take(const FrontPiece& piece) const {
  Question question(compiledFor(piece), piece);
  SingleStep step;
  step.refusals = question.explain();
  if (const Application* application = question.choose()) {
    describe(step, question.scene(), piece, *application);
    std::erase_if(step.refusals, [&](const RuleRefusal& r) { return r.rule == *step.rule; });
  }
  const auto& edges = question.scene().edges;
  if (step.welded) {
    const auto middle = static_cast<std::size_t>(compiled_->set().rules()[*step.rule].weldMiddle());
    step.frontAfter =
        frontAfterWeld(edges, step.matched[middle], step.welded->first, step.welded->second);
  } else {
    step.frontAfter = frontAfter(edges, step.elements);
  }
  return step;
}

SingleStep takeSingleStep(const RuleSet& rules, const FrontPiece& piece) {
  return SingleStepper(rules).take(piece);
}

}  // namespace af2
