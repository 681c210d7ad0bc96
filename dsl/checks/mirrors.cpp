// M1, M2: every rule has exactly one mirror image.
#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "dsl/checks/checks.h"
#include "dsl/checks/rule_comparison.h"

namespace af2::dsl {
namespace {

/// The title of the mirror image: "left" and "right" are swapped, or ", mirrored" is added.
std::string twinTitle(const std::string& title, std::span<const CompiledRule> all) {
  std::string twin = title;
  for (const auto& [word, other] : {std::pair<std::string, std::string>{"right", "left"},
                                    {"Right", "Left"},
                                    {"left", "right"},
                                    {"Left", "Right"}}) {
    const std::size_t at = twin.find(word);
    if (at == std::string::npos) continue;
    twin.replace(at, word.size(), other);
    break;
  }
  if (twin == title) twin += ", mirrored";
  const auto isTaken = [&](const CompiledRule& rule) { return rule.definition.name == twin; };
  while (std::ranges::any_of(all, isTaken)) twin += ", 2";
  return twin;
}

/// An edit that adds a mirror clause at the end. There is none for a family or a template, because
/// the clause would apply to several rules.
std::vector<SuggestedEdit> withMirror(const CompiledRule& rule, std::span<const CompiledRule> all) {
  const bool isOne = !rule.text->family && rule.parameters.empty();
  if (!isOne || rule.text->clauses.empty()) return {};
  const std::uint32_t end = rule.text->clauses.back().span.end;
  const std::string twin = twinTitle(rule.definition.name, all);
  return {{placeOf(rule.home->source, {end, end}), "\n  mirror \"" + twin + "\";",
           "the mirror image \"" + twin + "\" added"}};
}

/// An edit that removes the mirror clause and the spaces before it.
std::vector<SuggestedEdit> withoutMirror(const CompiledRule& rule) {
  if (!rule.parameters.empty()) return {};
  const std::string_view text = rule.home->source.text();
  Span span = *rule.mirrorSpan;
  while (span.begin > 0 && std::isspace(static_cast<unsigned char>(text[span.begin - 1])) != 0)
    --span.begin;
  return {{placeOf(rule.home->source, span), "",
           "a mirror clause removed that did the same once more"}};
}

/// Whether the mirror clause changes the image: then it is another rule.
bool changesImage(const Rule& text) {
  return std::ranges::any_of(text.clauses, [](const Clause& clause) {
    const auto* mirror = std::get_if<MirrorClause>(&clause.content);
    return mirror && !mirror->overrides.empty();
  });
}

void checkMirror(const CompiledRule& rule, const RuleSetDefinition& settings, Findings& findings) {
  if (doTheSame(rule.definition, *rule.image))
    findings.add(rule, Code::RedundantMirror, *rule.mirrorSpan, "this rule is its own mirror image",
                 "its mirror image would be the same rule", "remove the `mirror` clause", {},
                 withoutMirror(rule));
  else if (!changesImage(*rule.text) && alwaysTie(rule.definition, *rule.image, settings))
    findings.add(rule, Code::RedundantMirror, *rule.mirrorSpan,
                 "the mirror image of this rule is never chosen",
                 "it applies at the same matches with the same score, and the first of them wins",
                 "remove the `mirror` clause, or let the two differ in their cost or conditions",
                 {}, withoutMirror(rule));
}

void checkOne(const CompiledRule& rule, std::span<const CompiledRule> all,
              const RuleSetDefinition& settings, Findings& findings) {
  // A path is sought from every vertex of a loop, in both directions.
  if (rule.isMirror || !rule.image || rule.definition.path) return;
  if (rule.mirrorSpan) return checkMirror(rule, settings, findings);
  // An image that always ties would never be chosen, so nobody should be asked for it.
  if (doTheSame(rule.definition, *rule.image) || alwaysTie(rule.definition, *rule.image, settings))
    return;
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
    findings.add(rule, Code::MissingMirror, rule.title,
                 "this rule is not quite its own mirror image",
                 "its image differs in " + differenceOf(rule.definition, *rule.image),
                 "make it symmetric, or add `mirror \"...\";`");
    return;
  }
  if (similar != all.end()) {
    findings.add(rule, Code::MissingMirror, rule.title,
                 "this rule and \"" + similar->definition.name + "\" are not quite mirror images",
                 "they differ in " + differenceOf(similar->definition, *rule.image),
                 "if they are meant to be, write one of them as `mirror`",
                 {{"the other rule", placeOf(similar->home->source, similar->title)}});
    return;
  }
  findings.add(rule, Code::MissingMirror, rule.title, "this rule has no mirror image", "",
               "add `mirror \"...\";` if the other side should work alike", {},
               withMirror(rule, all));
}

}  // namespace

void checkMirrors(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules)
    checkOne(rule, rules.rules, rules.settings, findings);
}

}  // namespace af2::dsl
