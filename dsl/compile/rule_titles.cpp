#include "dsl/compile/rule_titles.h"

#include <algorithm>
#include <map>

#include "dsl/syntax/titles.h"

namespace af2::dsl {
namespace {

/// A parameter that the title does not contain, parameters of the family first; empty if it
/// contains all of them.
std::string untoldParameter(const CompiledRule& rule, const std::string& title) {
  std::vector<std::string> names;
  if (rule.text->family)
    for (const Name& name : rule.text->family->names) names.push_back(name.text);
  for (const auto& [name, parameter] : rule.parameters) names.push_back(name);
  const auto untold = std::ranges::find_if(names, [&](const std::string& name) {
    return title.find("{" + name + "}") == std::string::npos;
  });
  return untold == names.end() ? std::string() : *untold;
}

/// Two rules with the same title: members of a family, or rules of two instances.
void tellSameTitle(const CompiledRule& known, const CompiledRule& rule,
                   DiagnosticList& diagnostics) {
  const bool isOfInstances = known.askedAt != rule.askedAt;
  if (!isOfInstances && !rule.text->family) return;
  const std::string& title = rule.definition.name;
  const bool isOwn = placeOf(rule.home->source, rule.text->title.span) == rule.titlePlace;
  const std::string written = rule.mirror ? rule.mirror->title.text
                              : isOwn     ? rule.text->title.text
                                          : title;
  const std::string parameter = untoldParameter(rule, written);
  Diagnostic d(Code::DuplicateName);
  d.place = rule.titlePlace;
  d.message = isOfInstances ? "two instances of one template make a rule \"" + title + "\""
                            : "several rules of this family have the title \"" + title + "\"";
  d.help = parameter.empty()
               ? "two of them have the same values; leave one out"
               : "write a parameter into the title, as in \"" + written + " {" + parameter + "}\"";
  if (isOfInstances) d.notes = {{"one of them", known.askedAt}, {"the other one", rule.askedAt}};
  diagnostics.add(std::move(d));
}

}  // namespace

std::vector<const Name*> titlesMadeBy(const Item& item, const Module& module) {
  std::vector<const Name*> titles = titlesOf(item);
  const auto* instance = std::get_if<Instance>(&item.content);
  if (!instance) return titles;
  const Module* home = &module;
  if (const auto& qualifier = instance->call.qualifier; !qualifier.empty()) {
    const auto library = module.imports.find(qualifier);
    home = library == module.imports.end() ? nullptr : library->second;
  }
  if (!home) return titles;
  const auto found = home->templates.find(instance->call.name);
  if (found == home->templates.end()) return titles;
  const auto written = titlesOf(found->second.text->rule);
  titles.insert(titles.end(), written.begin() + 1, written.end());
  return titles;
}

void checkTitles(const Module& main, std::span<const CompiledRule> rules,
                 DiagnosticList& diagnostics) {
  std::map<std::string, DiagnosticPlace> seen;
  const auto add = [&](const std::string& title, const DiagnosticPlace& at) {
    const auto [known, isNew] = seen.emplace(title, at);
    if (isNew || known->second == at) return;
    Diagnostic d(Code::DuplicateName);
    d.message = "there are two rules \"" + title + "\"";
    d.place = at;
    d.help =
        "give each rule a title of its own; in a family write a parameter into it, as in \"free "
        "{k}\"";
    d.notes = {{"the other one", known->second}};
    diagnostics.add(std::move(d));
  };
  // Checks the text first, because rules with errors are not among the compiled rules.
  const auto addText = [&](const Name& title) {
    if (title.text.find('{') == std::string::npos)
      add(title.text, placeOf(main.source, title.span));
  };
  for (const Item& item : main.parsed.file.items)
    for (const Name* title : titlesOf(item)) addText(*title);
  std::map<std::string, const CompiledRule*> first;
  for (const CompiledRule& rule : rules) {
    add(rule.definition.name, rule.titlePlace);
    const auto [known, isNew] = first.emplace(rule.definition.name, &rule);
    if (!isNew && known->second->titlePlace == rule.titlePlace)
      tellSameTitle(*known->second, rule, diagnostics);
  }
}

}  // namespace af2::dsl
