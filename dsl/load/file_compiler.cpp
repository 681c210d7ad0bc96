#include "dsl/load/file_compiler.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "dsl/checks/checks.h"
#include "dsl/compile/rule_set_chain.h"
#include "dsl/compile/rule_titles.h"
#include "dsl/syntax/titles.h"
#include "engine/base/error.h"

namespace af2::dsl {

void FileCompiler::append(std::vector<CompiledRule> compiled) {
  const std::vector<MissingName> missing = std::exchange(context_.missing, {});
  for (CompiledRule& rule : compiled) {
    rule.missing = missing;
    rules_.push_back(std::move(rule));
  }
}

/// The settings apply to all rules, so none can be evaluated without what they call. Tests and
/// properties need what they call only when they run.
void FileCompiler::keepMissing(LoadedFile& result, const std::vector<MissingName>& ofSettings,
                               const std::vector<MissingName>& ofTests) {
  const auto add = [](std::vector<MissingName>& all, const std::vector<MissingName>& more) {
    for (const MissingName& name : more)
      if (std::ranges::find(all, name) == all.end()) all.push_back(name);
  };
  add(result.missing, ofSettings);
  for (CompiledRule& rule : rules_) {
    add(rule.missing, ofSettings);
    add(result.missing, rule.missing);
  }
  add(result.missing, ofTests);
}

void FileCompiler::compileInstance(const Module& module, const Instance& instance) {
  ProgramBuilder builder;
  ExpressionCompiler values(context_, module, ExpressionPlace::Constant, Algebra(builder, {}));
  const Expr& call = instance.call;
  if (call.kind != ExprKind::Call) {
    if (!call.isMissing())
      values.tell(Code::UnexpectedText, call.span, "an instance is written `template(values)`", "",
                  "rule \"title\" = name(1, 2);");
    return;
  }
  const Module* home = &module;
  if (!call.qualifier.empty()) {
    const auto library = module.imports.find(call.qualifier);
    if (library == module.imports.end())
      return values.tell(Code::UnknownName, call.span,
                         "nothing is imported as '" + call.qualifier + "'");
    if (!library->second) return;
    home = library->second;
  }
  const auto found = home->templates.find(call.name);
  if (found == home->templates.end()) {
    if (home->brokenNames.contains(call.name) || home->hasBrokenImport) return;
    std::vector<std::string> known;
    if (context_.mayGuess())
      for (const auto& [name, t] : home->templates) known.push_back(name);
    return values.tell(Code::UnknownName, call.span, "there is no template '" + call.name + "'", "",
                       guessAmong(call.name, known, "templates"));
  }
  if (home == &module && found->second.span.begin > call.span.begin &&
      found->second.home == &module)
    return values.tell(Code::UnknownName, call.span,
                       "the template '" + call.name + "' is used before it is defined", "",
                       "move the template up");
  const Template& text = *found->second.text;
  if (call.parts.size() != text.parameters.size()) {
    std::string usage = text.name.text + "(";
    for (const Name& p : text.parameters) usage += (usage.back() == '(' ? "" : ", ") + p.text;
    return values.tell(Code::ArgumentCount, call.span,
                       "'" + call.name + "' is instantiated with " +
                           std::to_string(call.parts.size()) +
                           (call.parts.size() == 1 ? " value" : " values"),
                       "", "the template is " + usage + ")");
  }
  Parameters parameters;
  for (std::size_t i = 0; i < call.parts.size(); ++i) {
    const Value value = values.evaluate(call.parts[i]);
    RuleCompiler::Parameter p;
    p.span = text.parameters[i].span;
    p.value.type = value.type;
    const auto known = [&](Node node) {
      return node < 0 ? 0.0 : builder.constantValue(node).value_or(0);
    };
    p.value.number = known(value.number);
    p.value.x = known(value.at.x);
    p.value.y = known(value.at.y);
    if (value.type == Type::Shape) {
      values.tell(Code::WrongType, call.parts[i].span, "a template's value cannot be a shape", "",
                  "give numbers, angles or vectors");
      p.value.type = Type::Any;
    }
    parameters[text.parameters[i].text] = p;
  }
  const RuleCompiler::InstanceTitle title{instance.title, &module};
  append(RuleCompiler(context_, *found->second.home, settings_->shared())
             .compile(text.rule, parameters, &title));
}

/// A template is also checked without an instance, so that its faults are found before it is used.
void FileCompiler::checkTemplate(const Module& module, const Template& item) {
  Parameters parameters;
  std::set<std::string> seen;
  for (const Name& name : item.parameters) {
    if (!seen.insert(name.text).second)
      context_.tell(module, Code::DuplicateName, name.span,
                    "the parameter '" + name.text + "' is given twice", "choose another name");
    RuleCompiler::Parameter p;
    p.span = name.span;
    parameters[name.text] = p;
  }
  RuleCompiler(context_, module, settings_->shared()).compile(item.rule, parameters);
  context_.missing.clear();  // only its instances are rules
}

bool FileCompiler::holdsRule(const Module& module, const std::string& title) const {
  return std::ranges::any_of(module.parsed.file.items, [&](const Item& item) {
    return std::ranges::any_of(titlesMadeBy(item, module),
                               [&](const Name* name) { return isTitleOf(name->text, title); });
  });
}

void FileCompiler::compileUse(const Module& module, const Use& use) {
  const auto library = module.imports.find(use.library.text);
  if (library == module.imports.end()) {
    std::vector<std::string> known;
    for (const auto& [name, m] : module.imports) known.push_back(name);
    const Help help = didYouMean(use.library.text, known);
    if (!module.brokenNames.contains(use.library.text) && !module.hasBrokenImport)
      context_.tell(module, Code::UnknownName, use.library.span,
                    "nothing is imported as '" + use.library.text + "'",
                    help.empty() ? "import the file first: `import \"" + use.library.text +
                                       ".af2\" as " + use.library.text + ";`"
                                 : help);
    return;
  }
  if (!library->second || library->second == &module) return;
  const std::vector<CompiledRule>& made = rulesOf(*library->second);
  if (use.rule) checkTitle(module, use, *use.rule);
  std::set<std::string_view> except;
  for (const Name& name : use.except) {
    checkTitle(module, use, name);
    except.insert(name.text);
  }
  const auto isThere = [&](const CompiledRule& rule) {
    return std::ranges::any_of(rules_, [&](const CompiledRule& other) {
      return other.definition.name == rule.definition.name && other.titlePlace == rule.titlePlace &&
             other.askedAt == rule.askedAt;
    });
  };
  for (const CompiledRule& rule : made) {
    const std::string& title = rule.definition.name;
    const bool isWanted = use.rule ? use.rule->text == title : !except.contains(title);
    if (isWanted && !isThere(rule)) rules_.push_back(rule);
  }
}

/// Reports that the imported file has no rule with this title.
void FileCompiler::checkTitle(const Module& module, const Use& use, const Name& name) {
  const Module& library = *module.imports.at(use.library.text);
  std::vector<std::string> titles;
  for (const CompiledRule& rule : rulesOf(library)) {
    if (rule.definition.name == name.text) return;
    titles.push_back(rule.definition.name);
  }
  if (holdsRule(library, name.text)) return;  // it has errors of its own
  context_.tell(module, Code::UnknownName, name.span,
                "'" + use.library.text + "' has no rule \"" + name.text + "\"",
                guessAmong(name.text, titles, "rules of that file"));
}

/// The rules that a file defines and uses, computed once. Empty for a cycle of imports, which is
/// reported at the import.
const std::vector<CompiledRule>& FileCompiler::rulesOf(const Module& library) {
  const auto [known, isNew] = libraryRules_.try_emplace(&library);
  if (!isNew) return known->second;
  std::vector<CompiledRule> outer = std::exchange(rules_, {});
  compileItems(library);
  known->second = std::exchange(rules_, std::move(outer));
  return known->second;
}

void FileCompiler::compileItems(const Module& module) {
  for (const Item& item : module.parsed.file.items) {
    if (context_.rulesLeft == 0) return;
    match(
        item.content,
        [&](const Rule& rule) {
          append(RuleCompiler(context_, module, settings_->shared()).compile(rule, {}));
        },
        [&](const Instance& instance) { compileInstance(module, instance); },
        [&](const Template& text) { checkTemplate(module, text); },
        [&](const Use& use) { compileUse(module, use); },
        // Settings and names are read before the rules; tests and properties need all rules, so
        // they follow.
        [](const AnyOf<std::monostate, Import, Constant, Function, Metric, Extern, RuleSetBlock,
                       Test, Property> auto&) {});
  }
}

void FileCompiler::checkKinds(const RuleSetCompiler& settings) {
  if (settings.kinds().empty() || settings.kinds().contains("poly")) return;
  for (const CompiledRule& rule : rules_)
    for (std::size_t i = 0; i < rule.definition.elements.size(); ++i) {
      const std::string kind = rule.definition.elements[i].size() == 3 ? "tri" : "quad";
      if (!settings.kinds().contains(kind))
        context_.tell(*rule.home, Code::MalformedPattern, rule.elementSpans[i],
                      "this rule makes a " + kind + ", which the rule set does not list",
                      "add '" + kind + "' to the `elements` of the rule set");
    }
}

std::set<int> FileCompiler::sizesMade() const {
  std::set<int> sizes;
  for (const CompiledRule& rule : rules_)
    for (const RuleElement& element : rule.definition.elements) sizes.insert(element.size());
  return sizes;
}

void FileCompiler::compileProperty(const Property& property, LoadedFile& result) {
  const auto rule = std::find_if(rules_.begin(), rules_.end(), [&](const CompiledRule& r) {
    return r.definition.name == property.rule.text;
  });
  if (rule == rules_.end()) {
    if (holdsRule(main_, property.rule.text)) return;  // it has errors of its own
    std::vector<std::string> titles;
    for (const CompiledRule& r : rules_) titles.push_back(r.definition.name);
    return context_.tell(main_, Code::UnknownName, property.rule.span,
                         "there is no rule \"" + property.rule.text + "\"",
                         guessAmong(property.rule.text, titles, "rules of this file"));
  }
  auto compiled = RuleCompiler(context_, *rule->home, settings_->shared())
                      .compileProperty(property, main_, *rule);
  if (compiled) result.properties.push_back(std::move(*compiled));
}

void FileCompiler::compileTests(LoadedFile& result) {
  std::map<std::string, Span> titles, properties;
  const auto tellIfTaken = [&](std::map<std::string, Span>& taken, const Name& title,
                               const std::string& plural, const std::string& one) {
    const auto [known, isNew] = taken.emplace(title.text, title.span);
    if (isNew) return;
    context_.tell(main_, Code::DuplicateName, title.span,
                  "there are two " + plural + " \"" + title.text + "\"",
                  "give each " + one + " a title of its own",
                  {{"the other one", placeOf(main_.source, known->second)}});
  };
  const auto addTest = [&](const Test& test) {
    tellIfTaken(titles, test.title, "tests", "test");
    auto compiled = compileTest(context_, main_, test, rules_, settings_->shared().maxLevel);
    if (compiled) result.tests.push_back(std::move(*compiled));
  };
  const auto addProperty = [&](const Property& property) {
    tellIfTaken(properties, property.title, "properties", "property");
    compileProperty(property, result);
  };
  for (const Item& item : main_.parsed.file.items)
    match(item.content, addTest, addProperty,
          [](const AnyOf<std::monostate, Import, Use, Constant, Function, Metric, Extern,
                         RuleSetBlock, Rule, Template, Instance> auto&) {});
}

/// Makes the rules for the engine, and removes from `rules` those that the engine would refuse.
std::shared_ptr<const RuleSet> FileCompiler::ruleSetOf(std::vector<CompiledRule>& rules,
                                                       RuleSetDefinition definition) {
  std::erase_if(rules, [&](const CompiledRule& rule) {
    try {
      definition.rules.emplace_back(rule.definition);
      return false;
    } catch (const InputError& error) {
      const bool isNeverTried = rule.definition.firstLevel > definition.maxLevel;  // reported as D2
      if (!isNeverTried) context_.tell(*rule.home, Code::OpenTopology, rule.title, error.what());
      return true;
    }
  });
  try {
    return std::make_shared<const RuleSet>(std::move(definition));
  } catch (const InputError& error) {
    if (!context_.diagnostics.hasErrors())
      context_.tell(main_, Code::RuleSetCount, {0, 0}, error.what());
    return nullptr;
  }
}

std::shared_ptr<const RuleSet> FileCompiler::compile(LoadedFile& result) {
  std::vector<PlacedRuleSet> sets = ruleSetChain(context_, library_, needsRuleSet_);
  const bool hasRuleSet = !sets.empty(), needsRules = needsRuleSet_ || hasRuleSet;
  context_.missing.clear();  // definitions that no rule calls need no implementation
  settings_ = std::make_unique<RuleSetCompiler>(context_, main_, std::move(sets));
  std::vector<MissingName> missing = std::exchange(context_.missing, {});
  result.allowed = settings_->allowed();
  compileItems(main_);
  checkTitles(main_, rules_, context_.diagnostics);
  checkKinds(*settings_);
  compileTests(result);
  const std::vector<MissingName> ofTests = std::exchange(context_.missing, {});
  RuleSetDefinition definition = settings_->finish(sizesMade());
  std::ranges::move(std::exchange(context_.missing, {}), std::back_inserter(missing));
  keepMissing(result, missing, ofTests);
  std::set<Code> allowed = settings_->allowed();
  allowed.insert(allowed_.begin(), allowed_.end());
  std::vector<CompiledRule> sound =
      runChecks({rules_, definition, main_, std::move(allowed), settings_->acceptancePlace()},
                context_.diagnostics);
  if (rules_.empty() && !context_.diagnostics.hasErrors() && needsRules)
    context_.tell(main_, Code::RuleSetCount, {0, 0}, "this file has no rules",
                  "add `rule \"title\" quality 1 { ... }`");
  if (!context_.diagnostics.hasErrors()) sound = rules_;  // including rules that are never tried
  const bool isUsable = hasRuleSet || !context_.diagnostics.hasErrors();
  if (isUsable && !sound.empty()) result.soundRules = ruleSetOf(sound, std::move(definition));
  std::set<std::string> titles;
  for (const CompiledRule& rule : sound) titles.insert(rule.definition.name);
  result.rules = std::move(sound);
  for (CompiledRule& rule : rules_)
    if (!titles.contains(rule.definition.name)) result.rules.push_back(std::move(rule));
  return context_.diagnostics.hasErrors() ? nullptr : result.soundRules;
}

}  // namespace af2::dsl
