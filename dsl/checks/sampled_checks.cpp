#include "dsl/checks/sampled_checks.h"

#include "dsl/checks/proof.h"
#include "dsl/checks/rule_sample.h"

namespace af2::dsl {

SampledResult runSampledChecks(const RuleSet& rules, const SamplingOptions& options) {
  SampledResult result;
  for (std::size_t i = 0; i < rules.rules().size(); ++i) {
    const RuleSample sample = sampleRule(rules, i, options);
    RuleAnswers answers;
    if (sample.matches.empty()) {
      result.answers.push_back(answers);
      continue;
    }
    const auto keep = [&result](std::optional<SampledFinding> finding) {
      if (finding) result.findings.push_back(std::move(*finding));
      return finding.has_value();
    };
    keep(findNeverChosen(sample, options));
    if (keep(findInverted(sample)))
      answers.positive = Answer::Refuted;
    else if (provesPositive(rules, sample.rule, sample.level))
      answers.positive = Answer::Proven;
    if (keep(findUncovered(sample)))
      answers.covered = Answer::Refuted;
    else if (provesCovered(rules, sample.rule, sample.level))
      answers.covered = Answer::Proven;
    keep(findLost(sample));
    keep(findGrowing(sample));
    answers.lostMatches = shareOfLost(sample);
    result.answers.push_back(answers);
  }
  return result;
}

}  // namespace af2::dsl
