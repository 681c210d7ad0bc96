// M1: a match at which the mirror image of a rule would apply, and no rule has the same effect.
#include <fmt/format.h>

#include <algorithm>

#include "dsl/load/loaded_file.h"
#include "dsl/match/match_sampler.h"
#include "dsl/proof/match_diagnostics.h"
#include "dsl/proof/test_text.h"

namespace af2::dsl {
namespace {

/// The distance that tests can distinguish.
constexpr double kSamePlace = 1e-6;

/// The expectation of a test of the image: the position of its first new vertex, or the number of
/// its elements.
std::string expectationOf(const AF2Rule& image, const std::vector<Point2>& placed) {
  if (image.newCount() == 0) return fmt::format("elements {}", image.definition().elements.size());
  const Point2 at = placed[static_cast<std::size_t>(image.matchedCount())];
  return fmt::format("new 1 at ({}, {})", shortest(at.x), shortest(at.y));
}

bool isDone(const SingleStep& step, const AF2Rule& image, const std::vector<Point2>& placed) {
  if (!step.rule) return false;
  if (image.newCount() == 0) return step.elements.size() == image.definition().elements.size();
  return !step.newVertices.empty() &&
         distance(step.newVertices.front(),
                  placed[static_cast<std::size_t>(image.matchedCount())]) <= kSamePlace;
}

/// Whether the image would apply at a match, and no rule does the same.
bool isMissing(SingleStepper& stepper, const RuleSet& rules, const PatternMatch& match) {
  if (!evaluateMatch(rules, match.rule(), match.binding()).refused.isNone()) return false;
  const SingleStep step = stepper.take(pieceOf(match, match.level()));
  return !isDone(step, match.rule(), *match.placeAll());
}

}  // namespace

std::optional<MirrorExample> mirrorExampleOf(const LoadedRules& loaded, const Diagnostic& finding) {
  constexpr int kTries = 60;
  const auto& compiled = loaded.file->rules;
  const auto rule = std::ranges::find_if(compiled, [&](const CompiledRule& one) {
    return one.definition.name == finding.rule && one.image;
  });
  if (finding.code != Code::MissingMirror || rule == compiled.end()) return std::nullopt;
  const RuleSet& rules = *loaded.rules;
  const int level = rule->definition.firstLevel;
  if (level > rules.maxLevel()) return std::nullopt;
  MirrorExample example{std::make_shared<const AF2Rule>(*rule->image), {}, {}};
  const AF2Rule& image = *example.image;
  SingleStepper stepper(rules);
  MatchSampler sampler(rules, image, level, 1);
  std::optional<PatternMatch> match = PatternMatch::atReference(image, level);
  for (int i = 0; match && !isMissing(stepper, rules, *match); ++i)
    match = i < kTries ? sampler.next() : std::nullopt;
  if (!match) return std::nullopt;
  example.example = {match->vertices(), level, {}, {}};
  example.test = writeTest(*match, {fmt::format("{}: its mirror image is done alike", finding.rule),
                                    {},
                                    expectationOf(image, *match->placeAll())});
  return example;
}

}  // namespace af2::dsl
