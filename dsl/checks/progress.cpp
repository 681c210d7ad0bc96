// F1: every step reduces the unmeshed area, so meshing ends.
#include "dsl/checks/checks.h"

namespace af2::dsl {

void checkProgress(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules)
    if (rule.definition.elements.empty() && !rule.actSpan)
      findings.add(rule, Code::NoProgress, rule.title, "this rule makes no element",
                   "applying it would change nothing", "add `tri a b c;` or `quad a b c d;`");
}

}  // namespace af2::dsl
