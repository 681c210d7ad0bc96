// M1: a match at which the mirror image of a rule would apply, and no rule has the same effect.
#include <fmt/format.h>

#include <algorithm>

#include "dsl/load/loaded_file.h"
#include "dsl/match/match_sampler.h"
#include "dsl/proof/changed_rules.h"
#include "dsl/proof/match_diagnostics.h"
#include "dsl/proof/rule_sample.h"
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

/// Whether the image would be chosen at a match, and no rule does the same now.
bool isMissing(SingleStepper& stepper, ChangedRules& withImage, const PatternMatch& match) {
  const FrontPiece piece = pieceOf(match, match.level());
  return withImage.chooses(piece) && !isDone(stepper.take(piece), match.rule(), *match.placeAll());
}

/// The rule that a finding of M1 asks an image of, as its index in the rule set.
std::optional<std::size_t> ruleWithoutMirror(const LoadedRules& loaded, const Diagnostic& finding) {
  if (finding.code != Code::MissingMirror) return std::nullopt;
  const auto& compiled = loaded.file->rules;
  const auto rule = std::ranges::find_if(compiled, [&](const CompiledRule& one) {
    return one.definition.name == finding.rule && one.image;
  });
  const auto index = static_cast<std::size_t>(rule - compiled.begin());
  const bool isSound = index < loaded.rules->rules().size() &&
                       rule->definition.firstLevel <= loaded.rules->maxLevel();
  return isSound ? std::optional(index) : std::nullopt;
}

/// Whether no situation is found in which the image of a rule would be chosen.
bool isImageNeverChosen(const LoadedRules& loaded, std::size_t rule) {
  constexpr int kMatches = 600;
  SamplingOptions options;
  options.situations = 300;
  ChangedRules withImage =
      ChangedRules::adding(*loaded.rules, rule, *loaded.file->rules[rule].image);
  const auto levels = levelsOf(withImage.rules(), withImage.rules().rules()[withImage.index()]);
  if (levels.empty()) return false;
  const RuleSample sample =
      sampleRule(withImage.rules(), withImage.index(), levels.front(), kMatches, options.seed);
  return findNeverChosen(sample, withImage.stepper(), options).has_value();
}

}  // namespace

std::optional<MirrorExample> mirrorExampleOf(const LoadedRules& loaded, const Diagnostic& finding) {
  constexpr int kTries = 60;
  const auto rule = ruleWithoutMirror(loaded, finding);
  if (!rule) return std::nullopt;
  const RuleSet& rules = *loaded.rules;
  const RuleDefinition& definition = *loaded.file->rules[*rule].image;
  const int level = definition.firstLevel;
  MirrorExample example{std::make_shared<const AF2Rule>(definition), {}, {}};
  const AF2Rule& image = *example.image;
  SingleStepper stepper(rules);
  ChangedRules withImage = ChangedRules::adding(rules, *rule, definition);
  MatchSampler sampler(rules, image, level, 1);
  std::optional<PatternMatch> match = PatternMatch::atReference(image, level);
  for (int i = 0; match && !isMissing(stepper, withImage, *match); ++i)
    match = i < kTries ? sampler.next() : std::nullopt;
  if (!match) return std::nullopt;
  example.example = {match->vertices(), level, {}, {}};
  example.test = writeTest(*match, {fmt::format("{}: its mirror image is done alike", finding.rule),
                                    {},
                                    expectationOf(image, *match->placeAll())});
  return example;
}

void dropIdleMirrors(const LoadedRules& loaded, std::vector<Diagnostic>& told) {
  std::erase_if(told, [&](const Diagnostic& d) {
    const bool asksForMirror = d.notes.empty();  // else it is about two rules that are there
    const auto rule = asksForMirror ? ruleWithoutMirror(loaded, d) : std::nullopt;
    return rule && isImageNeverChosen(loaded, *rule);
  });
}

}  // namespace af2::dsl
