// Completion: which words and names fit at a place.
#include <algorithm>
#include <array>

#include "cli/lsp/completion_items.h"
#include "cli/lsp/server.h"
#include "dsl/text/words.h"

namespace af2::lsp {
namespace {

using dsl::BlockContext;
using dsl::BlockKind;
using dsl::TokenKind;

bool holds(const BlockContext& context, const char* word) {
  return std::ranges::any_of(context.statement, [&](const dsl::Token& t) { return t.is(word); });
}

bool followsString(const BlockContext& context) {
  return !context.statement.empty() && context.statement.back().kind == TokenKind::String;
}

bool isWithinParentheses(const BlockContext& context) {
  int depth = 0;
  for (const dsl::Token& t : context.statement) depth += t.is("(") ? 1 : t.is(")") ? -1 : 0;
  return depth > 0;
}

void addRuleHeader(ItemList& list) {
  const BlockContext& context = list.context();
  if (context.follows("=")) return addTemplates(list);
  if (holds(context, "=") || holds(context, "quality")) return addExpression(list);
  if (followsString(context)) return list.addWords({"quality", "for"});
  if (context.follows(")")) list.addWords({"in", "quality"});
}

void addInItem(ItemList& list) {
  const BlockContext& context = list.context();
  if (context.begins("import")) {
    if (followsString(context)) list.addWords({"as"});
  } else if (context.begins("use")) {
    if (context.statement.size() == 1) addImports(list);
    if (context.follows("*")) list.addWords({"except"});
  } else if (context.begins("const") || context.begins("def") || context.begins("metric")) {
    if (holds(context, "=")) addExpression(list);
  } else if (context.begins("ruleset")) {
    if (followsString(context)) list.addWords({"extends"});
  } else if (context.begins("template")) {
    if (context.follows(")") && !holds(context, "rule")) return list.addWords({"rule"});
    addRuleHeader(list);
  } else if (context.begins("rule")) {
    addRuleHeader(list);
  } else if (context.begins("property")) {
    if (followsString(context) && !holds(context, "forall")) list.addWords({"forall"});
    if (context.follows("forall")) list.addWords({"match"});
    if (context.follows("match")) list.addWords({"of"});
    if (holds(context, ",") && !context.follows(",") && !holds(context, "in"))
      list.addWords({"in"});
  }
}

void addInSetting(ItemList& list) {
  const BlockContext& context = list.context();
  const bool isSecond = context.statement.size() == 1;
  if (context.begins("elements")) return list.addWords({"tri", "quad"});
  if (context.begins("scale")) return list.addWords({"h", "base"});
  if (context.begins("parity")) return list.addWords({"even", "any"});
  if (context.begins("front") && isSecond) return list.addWords({"by", "rows"});
  if (context.begins("front") && holds(context, "rows"))
    return list.addWords({"start", "smallest_turn"});
  if (context.begins("score")) {
    if (isSecond) return list.addWords({"max", "sum", "mean"});
    if (!holds(context, "of")) return list.addWords({"of"});
    if (context.follows("of")) return addMetrics(list);
  }
  if (context.begins("accept")) list.addWords({"score"});
  if (context.begins("front"))  // the order may ask about the ends of each edge
    for (const char* end : {"a", "b"})
      list.add(ItemList::Rank::Local, ItemKind::Field, end, "an end of the edge");
  addExpression(list);
}

void addInClause(ItemList& list) {
  const BlockContext& context = list.context();
  if (context.follows("quality")) return addExpression(list);
  const bool namesVertices = context.begins("front") || context.begins("tri") ||
                             context.begins("quad") || context.begins("poly");
  const bool isExpression = isWithinParentheses(context) || holds(context, "=");
  if (namesVertices) return addVertices(list);
  if (context.follows("~")) list.addWords({"any"});
  const bool wantsVertex =
      (context.begins("at") || context.begins("slope")) && !isExpression && !holds(context, "~");
  if (wantsVertex) return addVertices(list);
  const bool givesName = (context.begins("let") || context.begins("new")) &&
                         (!isExpression || (context.follows(",") && !isWithinParentheses(context)));
  if (givesName || context.begins("mirror")) return;
  if (context.begins("zone")) list.addWords({"when"});
  addExpression(list);
}

void addOutcome(ItemList& list) {
  const BlockContext& context = list.context();
  if (holds(context, "because"))
    return list.addWords({"class", "pattern", "require", "novalue", "shape", "zone hit by edge",
                          "zone hit by vertex", "inverted", "score", "beaten"});
  if (holds(context, "with")) {
    if (context.follows("=")) return addVertices(list);
    if (context.follows("with") || context.follows(","))
      for (const dsl::Token& t : context.statement)
        if (t.kind == TokenKind::String) return addVerticesOfRule(list, t.text);
    return list.addWords({"because"});
  }
  if (followsString(context)) return list.addWords({"with", "because"});
  if (context.follows("front")) list.addWords({"only"});
  if (holds(context, "front")) {
    list.addWords({"new"});
    return addVertices(list);
  }
  if (context.follows("new") || context.follows("rule")) return;
  if (holds(context, "new") && !isWithinParentheses(context)) return list.addWords({"at"});
  const bool isFirst = context.follows("expect") || context.follows("not");
  if (context.follows("expect")) list.addWords({"not"});
  if (isFirst) list.addWords({"rule", "new", "front", "elements", "stuck", "score"});
  addExpression(list);
}

void addInTest(ItemList& list) {
  const BlockContext& context = list.context();
  if (context.begins("expect")) return addOutcome(list);
  if (isWithinParentheses(context) || context.begins("size")) return addExpression(list);
  if (context.begins("front") || context.begins("base")) addVertices(list);
}

void addInProperty(ItemList& list) {
  if (list.context().isAtBeginning()) return list.addWords({"expect"});
  addVerticesOfRule(list, list.context().title);
  addExpression(list);
}

void addAtBeginning(ItemList& list) {
  switch (list.context().block) {
    case BlockKind::File:
      if (list.place().document->text.find("af2 ") == std::string::npos) list.addWords({"af2 1;"});
      return list.addKeywords(dsl::itemWords());
    case BlockKind::Rule:
      return list.addKeywords(dsl::clauseWords());
    case BlockKind::RuleSet:
      return list.addKeywords(dsl::settingWords());
    case BlockKind::Test:
      return list.addKeywords(dsl::testWords());
    case BlockKind::Mirror:
      return list.addWords({"at", "quality", "cost"});
    case BlockKind::Meta:
      return list.addWords({"allow", "author", "note"});
    case BlockKind::Property:
      return addInProperty(list);
  }
}

void addItems(ItemList& list) {
  const BlockContext& context = list.context();
  if (context.isInComment) return;
  if (context.isInString) return addInString(list);
  if (context.isAtBeginning()) return addAtBeginning(list);
  const auto& words = context.statement;
  if (context.follows(".") && words.size() > 1)
    return addMembers(list, words[words.size() - 2].text);
  switch (context.block) {
    case BlockKind::File:
      return addInItem(list);
    case BlockKind::RuleSet:
      return addInSetting(list);
    case BlockKind::Rule:
    case BlockKind::Mirror:
      return addInClause(list);
    case BlockKind::Test:
      return addInTest(list);
    case BlockKind::Property:
      return addInProperty(list);
    case BlockKind::Meta:
      return;
  }
}

std::optional<Json> completion(Session& session, const Json&, const Json& params) {
  const Place place = session.placeOf(params);
  const BlockContext context = contextAt(place.analysis->main().source, place.offset);
  ItemList list(session, place, context);
  addItems(list);
  return list.take();
}

constexpr std::array kCompletionMethods{Method{"textDocument/completion", completion}};

}  // namespace

std::span<const Method> completionMethods() { return kCompletionMethods; }

}  // namespace af2::lsp
