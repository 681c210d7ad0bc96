// M1, M2: every rule has its mirror image, once.
#include <algorithm>

#include "dsl/checks/checks.h"
#include "dsl/checks/rule_comparison.h"

namespace af2::dsl {
namespace {

void checkOne(const CompiledRule& rule, std::span<const CompiledRule> all, Findings& findings) {
  if (rule.isMirror || !rule.image) return;
  const bool isItsOwnMirror = doTheSame(rule.definition, *rule.image);
  if (rule.mirrorSpan) {
    if (isItsOwnMirror)
      findings.add(rule, Severity::Warning, "M2", *rule.mirrorSpan,
                   "this rule is its own mirror image", "the mirror does the same once more",
                   "remove the `mirror` clause");
    return;
  }
  if (isItsOwnMirror) return;
  const auto image = [&](const CompiledRule& other) {
    return &other != &rule && doTheSame(other.definition, *rule.image);
  };
  if (std::any_of(all.begin(), all.end(), image)) return;
  const auto isSimilar = [&](const CompiledRule& other) {
    return &other != &rule && areAlike(other.definition, *rule.image) &&
           !areAlike(other.definition, rule.definition);
  };
  auto similar = std::find_if(all.begin(), all.end(), [&](const CompiledRule& other) {
    return isSimilar(other) && other.definition.firstLevel == rule.definition.firstLevel;
  });
  if (similar == all.end()) similar = std::find_if(all.begin(), all.end(), isSimilar);
  if (areAlike(rule.definition, *rule.image)) {
    findings.add(rule, Severity::Warning, "M1", rule.title,
                 "this rule is not quite its own mirror image",
                 "its image differs in " + differenceOf(rule.definition, *rule.image),
                 "make it symmetric, or add `mirror \"...\";`");
    return;
  }
  if (similar != all.end()) {
    findings.add(rule, Severity::Warning, "M1", rule.title,
                 "this rule and \"" + similar->definition.name + "\" are not quite mirror images",
                 "they differ in " + differenceOf(similar->definition, *rule.image),
                 "if they are meant to be, write one of them as `mirror`",
                 {{"the other rule", placeOf(similar->home->source, similar->title)}});
    return;
  }
  findings.add(rule, Severity::Warning, "M1", rule.title, "this rule has no mirror image", "",
               "add `mirror \"...\";` if the other side should work alike");
}

}  // namespace

void checkMirrors(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) checkOne(rule, rules.rules, findings);
}

}  // namespace af2::dsl
