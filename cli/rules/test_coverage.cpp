#include "cli/rules/test_coverage.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <variant>

#include "dsl/load/loaded_file.h"
#include "engine/step/single_step.h"

namespace af2::cli {
namespace {

/// What happened to one rule in all tests.
struct Seen {
  bool applied = false, requireRefused = false, zoneRefused = false;
};

void note(Refusal reason, Seen& seen) {
  switch (reason) {
    case Refusal::Require:
      seen.requireRefused = true;
      break;
    case Refusal::Shape:
    case Refusal::Convexity:
    case Refusal::ZoneHitByVertex:
    case Refusal::ZoneHitByEdge:
      seen.zoneRefused = true;
      break;
    default:
      break;
  }
}

std::vector<Seen> runAll(const dsl::LoadedRules& loaded) {
  std::vector<Seen> seen(loaded.rules->rules().size());
  SingleStepper stepper(*loaded.rules);
  for (const dsl::CompiledTest& test : loaded.file->tests) {
    const SingleStep step = stepper.take(test.piece);
    if (step.rule) seen[*step.rule].applied = true;
    for (const RuleRefusal& refusal : step.refusals) note(refusal.reason, seen[refusal.rule]);
  }
  return seen;
}

/// Whether a clause takes part in a match. Remarks name nothing, and a mirror clause makes another
/// rule.
bool takesPart(const dsl::Clause& clause) {
  if (std::holds_alternative<dsl::MirrorClause>(clause.content)) return false;
  bool namesSomething = false;
  dsl::visitParts(clause.content, [&](const auto&...) { namesSomething = true; });
  return namesSomething;
}

RuleCoverage coverageOf(const dsl::CompiledRule& rule, const Seen& seen) {
  RuleCoverage coverage;
  coverage.title = rule.definition.name;
  coverage.isChosen = seen.applied;
  const auto count = [&](bool exercised) {
    ++coverage.clauses;
    if (exercised) ++coverage.exercised;
  };
  const auto countGuard = [&](bool exercised, const char* keyword) {
    count(exercised);
    if (!exercised) coverage.missing.emplace_back(keyword);
  };
  for (const dsl::Clause& clause : rule.text->clauses) {
    if (std::holds_alternative<dsl::RequireClause>(clause.content)) {
      countGuard(seen.requireRefused, "require");
    } else if (std::holds_alternative<dsl::ZoneClause>(clause.content)) {
      countGuard(seen.zoneRefused, "zone");
    } else if (takesPart(clause)) {
      count(seen.applied);
    }
  }
  return coverage;
}

}  // namespace

std::vector<RuleCoverage> testCoverage(const dsl::LoadedRules& loaded) {
  const std::vector<Seen> seen = runAll(loaded);
  std::vector<RuleCoverage> coverage;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    coverage.push_back(coverageOf(loaded.file->rules[i], seen[i]));
  }
  return coverage;
}

std::string toText(const std::vector<RuleCoverage>& coverage) {
  std::size_t clauses = 0, exercised = 0;
  std::string neverChosen, unguarded;
  for (const RuleCoverage& rule : coverage) {
    clauses += rule.clauses;
    exercised += rule.exercised;
    if (!rule.isChosen) {
      neverChosen += fmt::format("  never chosen: \"{}\"\n", rule.title);
    } else if (!rule.missing.empty()) {
      unguarded +=
          fmt::format("  never refused a match: {} of \"{}\"\n", rule.missing.front(), rule.title);
    }
  }
  const std::size_t percent = clauses == 0 ? 100 : 100 * exercised / clauses;
  return fmt::format("clauses exercised {}/{} ({} %)\n{}{}", exercised, clauses, percent,
                     neverChosen, unguarded);
}

nlohmann::ordered_json toJson(const std::string& file, const std::vector<RuleCoverage>& coverage) {
  std::size_t clauses = 0, exercised = 0;
  auto rules = nlohmann::ordered_json::array();
  for (const RuleCoverage& rule : coverage) {
    clauses += rule.clauses;
    exercised += rule.exercised;
    rules.push_back({{"title", rule.title},
                     {"chosen", rule.isChosen},
                     {"clauses", rule.clauses},
                     {"exercised", rule.exercised},
                     {"never_refused", rule.missing}});
  }
  return {
      {"file", file}, {"clauses", clauses}, {"exercised", exercised}, {"rules", std::move(rules)}};
}

}  // namespace af2::cli
