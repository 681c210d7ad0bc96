#include "dsl/compile/rule_set_chain.h"

#include <algorithm>
#include <set>

#include "dsl/text/words.h"

namespace af2::dsl {
namespace {

class ChainFinder {
 public:
  ChainFinder(CompileContext& context, const Library& library, bool needsRuleSet)
      : context_(context),
        library_(library),
        main_(*library.modules().front()),
        needsRuleSet_(needsRuleSet) {}

  std::vector<PlacedRuleSet> find();

 private:
  bool isBroken() const;
  void warnOfRulesAlone();
  bool addBase(std::vector<PlacedRuleSet>& chain, std::set<const RuleSetBlock*>& seen);
  std::optional<PlacedRuleSet> findRuleSet(const std::string& name,
                                           const RuleSetBlock* except) const;

  CompileContext& context_;
  const Library& library_;
  const Module& main_;
  bool needsRuleSet_;
};

std::optional<PlacedRuleSet> ChainFinder::findRuleSet(const std::string& name,
                                                      const RuleSetBlock* except) const {
  for (const auto& module : library_.modules())
    for (const Item& item : module->parsed.file.items)
      if (const auto* block = std::get_if<RuleSetBlock>(&item.content))
        if (block->name.text == name && block != except) return PlacedRuleSet{block, module.get()};
  return std::nullopt;
}

/// Inserts the base of the first rule set before it.
bool ChainFinder::addBase(std::vector<PlacedRuleSet>& chain, std::set<const RuleSetBlock*>& seen) {
  const PlacedRuleSet first = chain.front();
  if (!first.block->base) return false;
  const auto base = findRuleSet(first.block->base->text, first.block);
  if (!base) {
    std::vector<std::string> known;
    for (const auto& module : library_.modules())
      for (const Item& item : module->parsed.file.items)
        if (const auto* block = std::get_if<RuleSetBlock>(&item.content))
          if (block != first.block) known.push_back(block->name.text);
    const Help help = didYouMean(first.block->base->text, known);
    context_.tell(*first.home, Code::UnknownName, first.block->base->span,
                  "there is no rule set \"" + first.block->base->text + "\"",
                  help.empty() ? "import the file that defines it" : help);
    return false;
  }
  if (!seen.insert(base->block).second) {
    context_.tell(*first.home, Code::CircularUse, first.block->base->span,
                  "these rule sets extend each other in a cycle");
    return false;
  }
  chain.insert(chain.begin(), *base);
  return true;
}

/// Whether a part of the file could not be read; the rule set may have been there.
bool ChainFinder::isBroken() const {
  const auto& items = main_.parsed.file.items;
  const bool misses = !main_.brokenNames.empty() || items.empty() ||
                      std::ranges::any_of(items, [](const Item& item) {
                        return std::holds_alternative<std::monostate>(item.content);
                      });
  return misses && context_.diagnostics.hasErrors();
}

/// A file with rules but without a rule set is either a library for other files, or incomplete.
void ChainFinder::warnOfRulesAlone() {
  if (isBroken()) return;
  for (const Item& item : main_.parsed.file.items) {
    if (!std::holds_alternative<Rule>(item.content)) continue;
    context_.tell(main_, Code::RuleSetCount, std::get<Rule>(item.content).title.span,
                  "this file has rules, but no rule set: only files that `use` them can run",
                  "add `ruleset \"name\" { ... }` if this file is to be run itself", {},
                  Severity::Warning);
    return;
  }
}

std::vector<PlacedRuleSet> ChainFinder::find() {
  std::vector<const RuleSetBlock*> own;
  std::set<std::string> extended;
  for (const Item& item : main_.parsed.file.items)
    if (const auto* block = std::get_if<RuleSetBlock>(&item.content)) {
      own.push_back(block);
      if (block->base) extended.insert(block->base->text);
    }
  std::vector<const RuleSetBlock*> heads;
  for (const RuleSetBlock* block : own)
    if (!extended.contains(block->name.text) || (own.size() == 1)) heads.push_back(block);
  if (heads.empty() && !own.empty()) heads.push_back(own.back());
  if (heads.empty() && !needsRuleSet_) {
    warnOfRulesAlone();
    return {};
  }
  if (heads.empty()) {
    const bool hasText = !main_.parsed.file.items.empty() || !main_.source.text().empty();
    if (!isBroken())
      context_.tell(main_, Code::RuleSetCount, {0, 0}, "this file has no rule set",
                    hasText ? "add `ruleset \"name\" { ... }`" : "the file is empty");
    return {};
  }
  for (std::size_t i = 1; i < heads.size(); ++i)
    context_.tell(main_, Code::RuleSetCount, heads[i]->name.span, "this file has a second rule set",
                  "keep one `ruleset` in the file that is run",
                  {{"the first one", placeOf(main_.source, heads[0]->name.span)}});
  std::vector<PlacedRuleSet> chain{{heads[0], &main_}};
  std::set<const RuleSetBlock*> seen{heads[0]};
  while (addBase(chain, seen)) {
  }
  return chain;
}

}  // namespace

std::vector<PlacedRuleSet> ruleSetChain(CompileContext& context, const Library& library,
                                        bool needsRuleSet) {
  return ChainFinder(context, library, needsRuleSet).find();
}

}  // namespace af2::dsl
