#include "cli/trace_view/step_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dsl/run/piece_match.h"

namespace af2::cli {
namespace {

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

/// Four digits are enough for a picture.
std::string shortNumber(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value == 0 ? 0.0 : value) : "null";
}

template <class List, class Text>
std::string listOf(const List& list, const Text& text) {
  std::string all;
  for (const auto& item : list) all += (all.empty() ? "" : ",") + text(item);
  return "[" + all + "]";
}

std::string indexText(std::size_t index) { return std::to_string(index); }

class ChartWriter {
 public:
  ChartWriter(const RuleSet& rules, const ObservedStep& step)
      : rules_(rules), step_(step), piece_(step.around.piece), frame_(rules, piece_) {}

  std::string write() const {
    const auto chain = [](const auto& vertices) { return listOf(vertices, indexText); };
    std::string vertices;
    for (std::size_t v = 0; v < piece_.vertices.size(); ++v) {
      const Point2 at = frame_(piece_.vertices[v]);
      vertices += fmt::format("{}[{},{},{}]", v == 0 ? "" : ",", step_.around.ids[v].value,
                              shortNumber(at.x), shortNumber(at.y));
    }
    return fmt::format(R"({{"v":[{}],"c":{},"i":{},"b":[{},{}],"s":{},"r":[{}]}})", vertices,
                       listOf(piece_.chains, chain), listOf(piece_.isolated, indexText),
                       piece_.base.first, piece_.base.second, shortNumber(piece_.size),
                       rulesText());
  }

 private:
  std::string rulesText() const {
    std::string text;
    if (step_.report.applied) {
      RuleRefusal applied;
      applied.rule = step_.report.rule;
      applied.matches = 1;
      applied.score = step_.report.score;
      applied.matched = matchedByApplied();
      text = entry(applied);
    }
    for (const RuleRefusal& refusal : step_.refusals)
      if (refusal.reason != Refusal::Class) text += (text.empty() ? "" : ",") + entry(refusal);
    return text;
  }

  /// The vertices of the applied rule, by its elements; empty if one of them is in no element.
  std::vector<VertexId> matchedByApplied() const {
    const RuleDefinition& rule = rules_.rules()[step_.report.rule].definition();
    std::vector<VertexId> matched(rule.vertices.size());
    for (std::size_t e = 0; e < step_.made.size(); ++e)
      for (std::size_t i = 0; i < static_cast<std::size_t>(step_.made[e].size()); ++i)
        if (const auto v = static_cast<std::size_t>(rule.elements[e].corners[i]);
            v < matched.size())
          matched[v] = step_.made[e].corners[i];
    if (std::ranges::any_of(matched, &VertexId::isNone)) matched.clear();
    return matched;
  }

  /// A vertex of the front may be in the piece twice, on both sheets of a seam: then the first.
  std::size_t localOf(VertexId id) const {
    const auto found = std::ranges::find(step_.around.ids, id);
    return found == step_.around.ids.end()
               ? kNowhere
               : static_cast<std::size_t>(found - step_.around.ids.begin());
  }

  /// Empty if the piece lacks one of them.
  std::vector<VertexId> localOf(const std::vector<VertexId>& ids) const {
    std::vector<VertexId> local;
    for (const VertexId id : ids) {
      const std::size_t v = localOf(id);
      if (v == kNowhere) return {};
      local.emplace_back(v);
    }
    return local;
  }

  std::string entry(const RuleRefusal& refusal) const {
    const AF2Rule& rule = rules_.rules()[refusal.rule];
    const auto match = dsl::matchInPiece(rules_, piece_, rule, localOf(refusal.matched));
    std::string text =
        fmt::format("[{},{},{},{}", refusal.rule, static_cast<int>(refusal.reason), refusal.matches,
                    refusal.score ? shortNumber(*refusal.score) : "null");
    if (!match) return text + "]";
    const bool isThere = refusal.reason != Refusal::Pattern;
    text += "," + listOf(match->matched, indexText) + "," +
            (isThere ? zonesText(match->evaluated) : "[]") + "," +
            (isThere ? newText(match->evaluated) : "[]");
    const RefusalCause& cause = match->evaluated.cause;
    const bool isHit =
        refusal.reason == Refusal::ZoneHitByVertex || refusal.reason == Refusal::ZoneHitByEdge;
    const bool isSame = cause.reason == refusal.reason && cause.index >= 0;
    if (isSame)
      text += fmt::format(",[{},{},{},{}]", cause.index, cause.isEdge ? 1 : 0,
                          shortNumber(cause.value), shortNumber(cause.limit));
    else if (isHit)
      text += ",null";
    return text + (isHit ? "," + hitText(refusal) : "") + "]";
  }

  static std::string zonesText(const dsl::EvalResult& result) {
    return listOf(result.zones, [](const std::vector<Point2>& loop) {
      return listOf(loop, [](Point2 p) { return shortNumber(p.x) + "," + shortNumber(p.y); });
    });
  }

  static std::string newText(const dsl::EvalResult& result) {
    return listOf(result.newVertices, [](const auto& vertex) {
      if (!vertex.second) return std::string("null");
      return fmt::format("[{},{}]", shortNumber(vertex.second->x), shortNumber(vertex.second->y));
    });
  }

  std::string hitText(const RuleRefusal& refusal) const {
    std::vector<std::size_t> hit{localOf(refusal.from)};
    if (refusal.reason == Refusal::ZoneHitByEdge) hit.push_back(localOf(refusal.to));
    std::erase(hit, kNowhere);
    return listOf(hit, indexText);
  }

  const RuleSet& rules_;
  const ObservedStep& step_;
  const FrontPiece& piece_;
  dsl::PieceFrame frame_;
};

}  // namespace

std::string stepChart(const RuleSet& rules, const ObservedStep& step) {
  return ChartWriter(rules, step).write();
}

}  // namespace af2::cli
