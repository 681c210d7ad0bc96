#include "dsl/proof/sampled_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "dsl/proof/proof.h"
#include "dsl/proof/rule_sample.h"

namespace af2::dsl {
namespace {

using Find = std::optional<SampledFinding> (*)(const RuleSample&);
using Proves = bool (*)(const RuleSet&, const AF2Rule&, int level, ProofEffort&);

bool provesAtAllLevels(const RuleSet& rules, const AF2Rule& rule, const std::vector<int>& levels,
                       ProofEffort effort, Proves proves) {
  for (int level = levels.front(); level <= levels.back(); ++level)
    if (!proves(rules, rule, level, effort)) return false;
  return true;
}

/// All checks of one rule.
class RuleChecks {
 public:
  RuleChecks(const RuleSet& rules, std::size_t index, SingleStepper& stepper,
             const SamplingOptions& options, std::vector<SampledFinding>& findings)
      : rules_(rules),
        index_(index),
        stepper_(stepper),
        options_(options),
        findings_(findings),
        levels_(levelsOf(rules, rules.rules()[index])) {}

  RuleAnswers run() {
    RuleAnswers answers;
    if (levels_.empty() || options_.unknown.contains(index_)) return answers;
    answers.isTried = true;
    const RuleDefinition& rule = rules_.rules()[index_].definition();
    if (rule.path) {  // it makes no elements, and is not tried at a base edge
      answers.positive = answers.covered = Answer::NotAsked;
      return answers;
    }
    if (options_.onlyErrors) levels_.erase(levels_.begin() + 1, levels_.end());
    if (!options_.onlyErrors)
      for (SampledFinding& finding : findIdleConditions(rules_, index_, options_))
        findings_.push_back(std::move(finding));
    const RuleSample sample =
        sampleRule(rules_, index_, levels_.front(), options_.samples, options_.seed);
    const bool hasMatches = !sample.matches.empty();
    if (!options_.onlyErrors && hasMatches) keep(findNeverChosen(sample, stepper_, options_));
    const auto& acceptance = rules_.definition().acceptance;
    answers.positive = acceptance && acceptance->needsMeasures()
                           ? Answer::NotAsked
                           : answer(sample, {findInverted, searchInverted}, provesPositive);
    answers.covered = answer(sample, {findUncovered}, provesCovered);
    if (options_.onlyErrors || !hasMatches) return answers;
    keep(findLost(sample));
    keep(findGrowing(sample));
    answers.lostMatches = shareOfLost(sample);
    return answers;
  }

 private:
  bool keep(std::optional<SampledFinding> finding) {
    if (finding) findings_.push_back(std::move(*finding));
    return finding.has_value();
  }

  /// Uses samples at the rule's first level, then a proof, and only then the expensive methods: a
  /// search, and samples at other levels.
  Answer answer(const RuleSample& sample, std::vector<Find> finds, Proves proves) {
    if (keep(finds.front()(sample))) return Answer::Refuted;
    if (provesAtAllLevels(rules_, sample.rule, levels_, options_.effort, proves))
      return Answer::Proven;
    for (std::size_t i = 1; i < finds.size(); ++i)
      if (keep(finds[i](sample))) return Answer::Refuted;
    return keep(laterFinding(finds)) ? Answer::Refuted : Answer::Sampled;
  }

  /// The finding at the lowest level after the first one that has a finding.
  std::optional<SampledFinding> laterFinding(const std::vector<Find>& finds) const {
    for (std::size_t i = 1; i < levels_.size(); ++i) {
      if (!findingAt(levels_[i], finds)) continue;
      for (int level = levels_[i - 1] + 1; level <= levels_[i]; ++level)
        if (auto finding = findingAt(level, finds)) return ofLaterLevel(std::move(*finding));
    }
    return std::nullopt;
  }

  std::optional<SampledFinding> findingAt(int level, const std::vector<Find>& finds) const {
    const RuleSample sample =
        sampleRule(rules_, index_, level, options_.samples / 4, options_.seed);
    for (const Find find : finds)
      if (auto finding = find(sample)) return finding;
    return std::nullopt;
  }

  /// At high levels, tolerances are so wide and zones so small that almost every rule fails at some
  /// match. A fault that occurs only there costs refused matches, but is not a fault of the
  /// geometry of the rule, so it is a warning.
  SampledFinding ofLaterLevel(SampledFinding finding) const {
    finding.severity = Severity::Warning;
    finding.message += fmt::format("; no fault was found below level {}", finding.example.level);
    finding.help += fmt::format(", or end the rule's levels: `quality {}..{}`", levels_.front(),
                                finding.example.level - 1);
    return finding;
  }

  const RuleSet& rules_;
  std::size_t index_;
  SingleStepper& stepper_;
  const SamplingOptions& options_;
  std::vector<SampledFinding>& findings_;
  std::vector<int> levels_;
};

std::string count(const SampledResult& result, Answer RuleAnswers::*question) {
  const auto number = [&](Answer answer) {
    return std::count_if(result.answers.begin(), result.answers.end(),
                         [&](const RuleAnswers& a) { return a.*question == answer; });
  };
  std::string text = fmt::format("proven for {}", number(Answer::Proven));
  if (number(Answer::Sampled)) text += fmt::format(", sampled for {}", number(Answer::Sampled));
  if (number(Answer::Refuted)) text += fmt::format(", false for {}", number(Answer::Refuted));
  return text;
}

}  // namespace

SampledResult runSampledChecks(const RuleSet& rules, const SamplingOptions& options) {
  SampledResult result;
  SingleStepper stepper(rules);
  const auto isCancelled = [&] { return options.isCancelled && options.isCancelled(); };
  for (std::size_t i = 0; i < rules.rules().size() && !isCancelled(); ++i)
    result.answers.push_back(RuleChecks(rules, i, stepper, options, result.findings).run());
  return result;
}

std::string summaryOf(const SampledResult& result) {
  return fmt::format("{} rules; elements positive (G2): {}; inside the free zone (Z1): {}",
                     result.answers.size(), count(result, &RuleAnswers::positive),
                     count(result, &RuleAnswers::covered));
}

}  // namespace af2::dsl
