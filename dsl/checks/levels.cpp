// D2: a rule whose levels are never reached.
#include "dsl/checks/checks.h"

namespace af2::dsl {

void checkLevels(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules)
    if (rule.definition.firstLevel > rules.settings.maxLevel)
      findings.add(rule, Code::UnreachedLevels, rule.levelSpan,
                   "this rule is never tried: the quality levels end at " +
                       std::to_string(rules.settings.maxLevel),
                   "",
                   "lower its level, or write `classes 1.." +
                       std::to_string(rule.definition.firstLevel) + ";` in the rule set");
}

}  // namespace af2::dsl
