#include "dsl/run/rule_tests.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "dsl/load/loaded_file.h"
#include "dsl/match/match_sampler.h"
#include "dsl/run/explain.h"

namespace af2::dsl {
namespace {

using Expected = CompiledExpectation;
using Edge = std::pair<std::size_t, std::size_t>;

/// Relative to the target size. Authors round coordinates to about this precision.
constexpr double kSamePlace = 1e-6;

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string shown(Point2 p) { return "(" + shown(p.x) + ", " + shown(p.y) + ")"; }

/// The result of the step of a test, and its description in words.
class Verdict {
 public:
  Verdict(const RuleSet& rules, const CompiledTest& test, const SingleStep& step)
      : rules_(rules), test_(test), step_(step) {}

  bool holds(const Expected& e) const {
    return std::visit([&](const auto& outcome) { return isMet(outcome, e.negated) != e.negated; },
                      e.outcome);
  }

  std::string got(const Expected& e) const {
    return std::visit([&](const auto& outcome) { return describe(outcome); }, e.outcome);
  }

 private:
  std::string vertexName(std::size_t v) const {
    const std::size_t count = test_.vertexNames.size();
    return v < count ? test_.vertexNames[v] : "new " + std::to_string(v - count + 1);
  }

  const AF2Rule* applied() const { return step_.rule ? &rules_.rules()[*step_.rule] : nullptr; }

  std::string appliedText() const {
    if (!applied()) return "no rule";
    return "rule \"" + applied()->name() + "\" (score " + shown(step_.score) + ")";
  }

  const RuleRefusal* refusalOf(const std::string& title) const {
    for (const RuleRefusal& refusal : step_.refusals)
      if (rules_.rules()[refusal.rule].name() == title) return &refusal;
    return nullptr;
  }

  std::string refusalText(const RuleRefusal& refusal) const {
    std::string text = toString(refusal.reason);
    if (refusal.reason == Refusal::ZoneHitByVertex) text += " " + vertexName(refusal.from.value);
    if (refusal.reason == Refusal::ZoneHitByEdge)
      text += " " + vertexName(refusal.from.value) + " -> " + vertexName(refusal.to.value);
    return text;
  }

  /// If several edges or vertices hit the zone, each of them is an accepted reason.
  bool isReason(const RuleRefusal& refusal, const Expected::Reason& expected) const {
    if (expected.words == "shape")
      return refusal.reason == Refusal::Shape || refusal.reason == Refusal::Convexity;
    if (!expected.vertices.empty())
      return (refusal.reason == Refusal::ZoneHitByVertex ||
              refusal.reason == Refusal::ZoneHitByEdge) &&
             isObstacle(refusal.rule, expected.vertices);
    return expected.words == toString(refusal.reason);
  }

  bool isObstacle(std::size_t rule, const std::vector<std::size_t>& vertices) const {
    const Refusal kind = vertices.size() == 1 ? Refusal::ZoneHitByVertex : Refusal::ZoneHitByEdge;
    const auto obstacles = SingleStepper(rules_).obstacles(test_.piece);
    return std::any_of(obstacles.begin(), obstacles.end(), [&](const RuleRefusal& obstacle) {
      return obstacle.rule == rule && obstacle.reason == kind &&
             obstacle.from.value == vertices[0] &&
             (vertices.size() == 1 || obstacle.to.value == vertices[1]);
    });
  }

  bool isBoundSo(const Expected::IsRule& expected) const {
    const auto& vertices = applied()->definition().vertices;
    return std::all_of(expected.bindings.begin(), expected.bindings.end(),
                       [&](const auto& binding) {
                         for (std::size_t i = 0; i < vertices.size(); ++i)
                           if (vertices[i].name == binding.first)
                             return step_.matched[i] == binding.second;
                         return false;
                       });
  }

  /// For `expect not rule ... because ...` the caller negates the answer.
  bool isMet(const Expected::IsRule& expected, bool negated) const {
    const bool isApplied = applied() && applied()->name() == expected.title && isBoundSo(expected);
    if (!negated || expected.reasons.empty() || isApplied) return isApplied;
    const RuleRefusal* refusal = refusalOf(expected.title);
    return !refusal || std::ranges::none_of(expected.reasons, [&](const Expected::Reason& reason) {
      return isReason(*refusal, reason);
    });
  }

  bool isMet(const Expected::NewAt& expected, bool) const {
    return expected.index < step_.newVertices.size() &&
           distance(step_.newVertices[expected.index], expected.at) <=
               kSamePlace * test_.piece.size;
  }

  std::set<Edge> edgesOf(const Expected::Front& expected) const {
    std::set<Edge> edges;
    for (const auto& chain : expected.chains)
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) edges.insert({chain[i], chain[i + 1]});
    return edges;
  }

  bool isMet(const Expected::Front& expected, bool) const {
    const std::set<Edge> wanted = edgesOf(expected),
                         there(step_.frontAfter.begin(), step_.frontAfter.end());
    return expected.only ? wanted == there
                         : std::includes(there.begin(), there.end(), wanted.begin(), wanted.end());
  }

  bool isMet(const Expected::Elements& expected, bool) const {
    return step_.elements.size() == expected.count;
  }
  bool isMet(const Expected::Weld& expected, bool) const {
    return step_.welded == std::pair(expected.from, expected.into);
  }
  bool isMet(const Expected::Stuck&, bool) const { return !applied(); }
  bool isMet(const Expected::Condition& expected, bool) const { return expected.holds; }

  bool isMet(const Expected::Score& expected, bool) const {
    const double s = step_.score, v = expected.value;
    if (!applied()) return false;
    if (expected.comparison == "<") return s < v;
    if (expected.comparison == "<=") return s <= v;
    if (expected.comparison == ">") return s > v;
    if (expected.comparison == ">=") return s >= v;
    const bool isEqual = std::abs(s - v) <= kSamePlace * std::max(1.0, std::abs(v));
    return expected.comparison == "==" ? isEqual : !isEqual;
  }

  std::string describe(const Expected::IsRule& expected) const {
    std::string text = appliedText();
    if (applied() && applied()->name() == expected.title) {
      for (std::size_t i = 2; i < step_.matched.size(); ++i)
        text += (i == 2 ? " with " : ", ") + applied()->definition().vertices[i].name + " = " +
                vertexName(step_.matched[i]);
      return text;
    }
    if (const RuleRefusal* refusal = refusalOf(expected.title))
      text += "; \"" + expected.title + "\" was refused: " + refusalText(*refusal);
    return text;
  }

  std::string describe(const Expected::NewAt& expected) const {
    if (expected.index < step_.newVertices.size())
      return "new " + std::to_string(expected.index + 1) + " at " +
             shown(step_.newVertices[expected.index]);
    const std::size_t made = step_.newVertices.size();
    return appliedText() + ", which makes " + std::to_string(made) +
           (made == 1 ? " new vertex" : " new vertices");
  }

  std::string describe(const Expected::Front&) const {
    if (step_.frontAfter.empty()) return "an empty front after " + appliedText();
    std::string text = "front ";
    for (const auto& [from, to] : step_.frontAfter)
      text += (text == "front " ? "" : ", ") + vertexName(from) + " -> " + vertexName(to);
    return text + " after " + appliedText();
  }

  std::string describe(const Expected::Elements&) const {
    const std::size_t made = step_.elements.size();
    return std::to_string(made) + (made == 1 ? " element by " : " elements by ") + appliedText();
  }
  std::string describe(const Expected::Weld&) const {
    if (!step_.welded) return "no weld by " + appliedText();
    return "weld " + vertexName(step_.welded->first) + " into " + vertexName(step_.welded->second) +
           " by " + appliedText();
  }
  std::string describe(const Expected::Stuck&) const { return appliedText(); }
  std::string describe(const Expected::Condition&) const { return "it does not hold"; }
  std::string describe(const Expected::Score&) const { return appliedText(); }

  const RuleSet& rules_;
  const CompiledTest& test_;
  const SingleStep& step_;
};

/// The clause as written, without `expect` and `;`.
std::string written(const SourceText& source, Span span) {
  std::string text(source.text().substr(span.begin, span.end - span.begin));
  std::string result;
  for (char c : text) {
    const bool isBlank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (isBlank && (result.empty() || result.back() == ' ')) continue;
    result += isBlank ? ' ' : c;
  }
  if (result.starts_with("expect ")) result = result.substr(7);
  while (!result.empty() && (result.back() == ';' || result.back() == ' ')) result.pop_back();
  return result;
}

/// " b = (1, 0) c = (1.5, 0.9)"
std::string shownMatch(const PatternMatch& match) {
  std::string text;
  for (std::size_t v = 1; v < match.vertices().size(); ++v)
    text += " " + match.rule().definition().vertices[v].name + " = " + shown(match.vertices()[v]);
  return text;
}

}  // namespace

TestResult runTest(const LoadedRules& rules, SingleStepper& stepper, const CompiledTest& test) {
  const SourceText& source = rules.file->main().source;
  TestResult result;
  result.title = test.title;
  result.place = placeOf(source, test.span);
  const SingleStep step = stepper.take(test.piece);
  if (step.rule) {
    result.appliedRule = rules.rules->rules()[*step.rule].name();
    result.score = step.score;
  }
  const Verdict verdict(*rules.rules, test, step);
  for (const CompiledExpectation& e : test.expectations)
    if (!verdict.holds(e))
      result.failures.push_back({placeOf(source, e.span), written(source, e.span), verdict.got(e)});
  if (!result.passed())
    result.explanation =
        toText(explainStep(*rules.rules, stepper, test.piece, test.vertexNames, true), "      ");
  return result;
}

TestResult runProperty(const LoadedRules& rules, const CompiledProperty& property) {
  constexpr int kMatchesPerLevel = 1000;
  const SourceText& source = rules.file->main().source;
  TestResult result;
  result.title = property.title;
  result.place = placeOf(source, property.span);
  result.isProperty = true;
  const auto& all = rules.rules->rules();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const AF2Rule& r) { return r.name() == property.rule; });
  if (found == all.end()) return result;
  std::vector<bool> failed(property.expectations.size());
  for (int level = property.firstLevel; level <= property.lastLevel; ++level) {
    MatchSampler sampler(*rules.rules, *found, level);
    for (int i = 0; i < kMatchesPerLevel; ++i) {
      const auto match = sampler.next();
      if (!match) break;
      ++result.samples;
      for (std::size_t e = 0; e < property.expectations.size(); ++e) {
        const auto value = property.expectations[e]->evaluate(match->binding());
        if (failed[e] || !value || *value != 0) continue;
        failed[e] = true;
        result.failures.push_back(
            {placeOf(source, property.expectationSpans[e]),
             written(source, property.expectationSpans[e]),
             "it fails at level " + std::to_string(level) + " for" + shownMatch(*match)});
      }
    }
  }
  if (result.samples == 0)
    result.failures.push_back(
        {result.place, "matches of \"" + property.rule + "\"", "none was found to try it on"});
  return result;
}

std::vector<TestResult> runRuleTests(const LoadedRules& rules, const std::string& filter) {
  std::vector<TestResult> results;
  if (!rules.rules) return results;
  SingleStepper stepper(*rules.rules);
  const auto isWanted = [&](const std::string& title) {
    return title.find(filter) != std::string::npos;
  };
  for (const CompiledTest& test : rules.file->tests)
    if (isWanted(test.title)) results.push_back(runTest(rules, stepper, test));
  for (const CompiledProperty& property : rules.file->properties)
    if (isWanted(property.title)) results.push_back(runProperty(rules, property));
  return results;
}

std::string toText(const TestResult& result) {
  if (result.passed()) return "ok    " + result.title + "\n";
  std::string text = "FAIL  " + result.title + "   " + result.place.file + ":" +
                     std::to_string(result.place.line) + "\n";
  for (const TestFailure& failure : result.failures) {
    text += "      expected: " + failure.expected + "   (line " +
            std::to_string(failure.place.line) + ")\n";
    text += "      got:      " + failure.got + "\n";
  }
  return text + result.explanation;
}

}  // namespace af2::dsl
