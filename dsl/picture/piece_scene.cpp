#include "dsl/picture/piece_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "dsl/run/piece_match.h"

namespace af2::dsl::picture {
namespace {

/// The rule that is shown: by its title, or the one that was applied, or the one that came
/// farthest; of several, the one that would pass at the lowest level.
std::size_t shownRule(const RuleSet& rules, const StepExplanation& explained,
                      const std::string& title) {
  if (!title.empty())
    return static_cast<std::size_t>(&findRule(rules, title) - rules.rules().data());
  if (explained.applied) return *explained.applied;
  const auto rank = [&](const RuleExplanation& rule) {
    return std::pair(static_cast<int>(rule.reason),
                     -rule.passesAtLevel.value_or(std::numeric_limits<int>::max()));
  };
  const auto best = std::ranges::max_element(explained.rules, {}, rank);
  return static_cast<std::size_t>(best - explained.rules.begin());
}

/// Fills a scene step by step.
class PieceSceneMaker {
 public:
  PieceSceneMaker(const RuleSet& rules, const FrontPiece& piece,
                  const std::vector<std::string>& names, const StepExplanation& explained,
                  std::size_t rule)
      : piece_(piece),
        names_(names),
        explained_(explained),
        step_(explained.step),
        index_(rule),
        rule_(rules.rules()[rule]),
        frame_(rules, piece) {
    const auto refusal = std::ranges::find(step_.refusals, rule, &RuleRefusal::rule);
    if (refusal != step_.refusals.end()) refusal_ = &*refusal;
    match_ = matchInPiece(rules, piece, rule_, matchedIds());
  }

  PieceScene make() {
    for (const Point2 p : piece_.vertices) scene_.at.push_back(frame_(p));
    scene_.base = piece_.base;
    for (const auto& chain : piece_.chains)
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        scene_.edges.emplace_back(chain[i], chain[i + 1]);
    if (match_) addMatch();
    if (isApplied()) addResult();
    if (refusal_) addRefusal();
    addVertices();
    addReason();
    scene_.world = world();
    return std::move(scene_);
  }

 private:
  bool isApplied() const { return step_.rule == index_; }

  std::vector<VertexId> matchedIds() const {
    std::vector<VertexId> ids;
    if (isApplied())
      for (const std::size_t v : step_.matched) ids.emplace_back(v);
    else if (refusal_)
      ids = refusal_->matched;
    return ids;
  }

  void addMatch() {
    scene_.zones = match_->evaluated.zones;
    for (const PatternEdge& edge : rule_.definition().edges)
      scene_.pattern.emplace_back(match_->matched[static_cast<std::size_t>(edge.from)],
                                  match_->matched[static_cast<std::size_t>(edge.to)]);
  }

  void addResult() {
    for (const Point2 p : step_.newVertices) newAt_.push_back(frame_(p));
    for (const auto& element : step_.elements) {
      Loop loop;
      for (const std::size_t v : element) loop.push_back(anyAt(v));
      scene_.elements.push_back(std::move(loop));
    }
    for (const PieceScene::Edge& edge : step_.frontAfter)
      if (std::ranges::count(scene_.edges, edge) == 0)
        scene_.newFront.emplace_back(anyAt(edge.first), anyAt(edge.second));
  }

  Point2 anyAt(std::size_t v) const {
    return v < scene_.at.size() ? scene_.at[v] : newAt_[v - scene_.at.size()];
  }

  void addRefusal() {
    if (refusal_->reason == Refusal::ZoneHitByVertex) scene_.culprits = {refusal_->from.value};
    if (refusal_->reason == Refusal::ZoneHitByEdge)
      scene_.culprits = {refusal_->from.value, refusal_->to.value};
    if (refusal_->reason != Refusal::Pattern || !match_) return;
    const auto& vertices = rule_.definition().vertices;
    for (std::size_t v = 2; v < vertices.size(); ++v)
      scene_.deviations.emplace_back(vertices[v].reference.at(piece_.level),
                                     scene_.at[match_->matched[v]]);
  }

  void addVertices() {
    for (std::size_t v = 0; v < scene_.at.size(); ++v) {
      PieceScene::Vertex vertex{scene_.at[v], outwardAt(v), names_[v]};
      vertex.isCulprit = std::ranges::count(scene_.culprits, v) > 0;
      if (const std::string* inRule = nameInRule(v)) {
        vertex.isMatched = true;
        if (*inRule != vertex.name) vertex.name += " = " + *inRule;
      }
      scene_.vertices.push_back(std::move(vertex));
    }
    for (std::size_t i = 0; i < newAt_.size(); ++i)
      scene_.vertices.push_back(
          {newAt_[i], {0, 1}, rule_.definition().newVertexNames[i], true, true});
  }

  const std::string* nameInRule(std::size_t v) const {
    if (!match_) return nullptr;
    const auto found = std::ranges::find(match_->matched, v);
    if (found == match_->matched.end()) return nullptr;
    const auto i = static_cast<std::size_t>(found - match_->matched.begin());
    return &rule_.definition().vertices[i].name;
  }

  /// Towards the elements that are there, to the right of the edges.
  Point2 outwardAt(std::size_t v) const {
    Point2 sum{};
    for (const auto& [from, to] : scene_.edges) {
      if (from != v && to != v) continue;
      const Point2 along = scene_.at[to] - scene_.at[from];
      if (length(along) > 0) sum = sum + (1 / length(along)) * Point2{along.y, -along.x};
    }
    return length(sum) > 0.05 ? sum : Point2{0.6, 0.8};
  }

  void addReason() {
    scene_.reason = fmt::format("Rule \"{}\": {}", rule_.name(), toText(explained_.rules[index_]));
    if (explained_.applied && !isApplied())
      scene_.reason += fmt::format(". Rule \"{}\" was applied instead",
                                   explained_.rules[*explained_.applied].rule);
    scene_.reason += ".";
  }

  /// A front may be long; only what is near the base edge can concern a rule.
  Box2 world() const {
    constexpr double kNear = 4, kMargin = 0.3;
    Box2 box{{-0.5, -0.3}, {1.5, 0.9}};
    const auto include = [&](Point2 p) {
      box.low = {std::min(box.low.x, p.x - kMargin), std::min(box.low.y, p.y - kMargin)};
      box.high = {std::max(box.high.x, p.x + kMargin), std::max(box.high.y, p.y + kMargin)};
    };
    for (const PieceScene::Vertex& vertex : scene_.vertices)
      if (vertex.isMatched || vertex.isCulprit || distance(vertex.at, {0.5, 0}) < kNear)
        include(vertex.at);
    for (const std::size_t v : scene_.culprits) include(scene_.at[v]);
    for (const Loop& zone : scene_.zones)
      for (const Point2 p : zone) include(p);
    for (const auto& [wanted, found] : scene_.deviations) include(wanted);
    return box;
  }

  const FrontPiece& piece_;
  const std::vector<std::string>& names_;
  const StepExplanation& explained_;
  const SingleStep& step_;
  std::size_t index_;
  const AF2Rule& rule_;
  PieceFrame frame_;
  const RuleRefusal* refusal_ = nullptr;
  std::optional<PieceMatch> match_;
  std::vector<Point2> newAt_;
  PieceScene scene_;
};

}  // namespace

bool PieceScene::isInPattern(const Edge& edge) const {
  return edge == base || std::ranges::count(pattern, edge) > 0;
}

bool PieceScene::hasOtherFront() const {
  return !std::ranges::all_of(edges, [&](const Edge& edge) { return isInPattern(edge); });
}

PieceScene sceneOf(const RuleSet& rules, const FrontPiece& piece,
                   const std::vector<std::string>& names, const StepExplanation& explained,
                   const std::string& rule) {
  return PieceSceneMaker(rules, piece, names, explained, shownRule(rules, explained, rule)).make();
}

}  // namespace af2::dsl::picture
