// Completion: which words and names fit at a place.
#include <algorithm>
#include <array>

#include "cli/lsp/completion_items.h"
#include "cli/lsp/server.h"
#include "dsl/text/keywords.h"

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

/// Completes after the first word of a clause whose parts are all of one kind.
void addBehind(ItemList& list, const dsl::Keyword& keyword) {
  const BlockContext& context = list.context();
  const bool isExpression = isWithinParentheses(context) || holds(context, "=");
  switch (keyword.follows) {
    case dsl::Follows::Nothing:
      return;
    case dsl::Follows::Words:
      return list.addWords(keyword.words);
    case dsl::Follows::Vertices:
      return addVertices(list);
    case dsl::Follows::VerticesAndForms:
      if (!isExpression && !holds(context, "~")) return addVertices(list);
      if (context.follows("~")) list.addWords({"any"});
      return addExpression(list);
    case dsl::Follows::Definitions: {
      const bool isNextName = context.follows(",") && !isWithinParentheses(context);
      if (isExpression && !isNextName) addExpression(list);
      return;
    }
    case dsl::Follows::Expression:
    case dsl::Follows::Header:
      list.addWords(keyword.words);
      return addExpression(list);
  }
}

void addScore(ItemList& list, const dsl::Keyword& keyword) {
  const BlockContext& context = list.context();
  if (context.statement.size() == 1) return list.addWords(keyword.words);
  if (!holds(context, "of")) return list.addWords({"of"});
  return context.follows("of") ? addMetrics(list) : addExpression(list);
}

void addFrontOrder(ItemList& list, const dsl::Keyword& keyword) {
  const BlockContext& context = list.context();
  if (context.statement.size() == 1) return list.addWords(keyword.words);
  if (context.follows(":")) return list.addWords(dsl::kRowStarts);
  if (holds(context, "rows")) return list.addWords({"start"});
  for (const char* end : {"a", "b"})  // the order may ask about the ends of each edge
    list.add(ItemList::Rank::Local, ItemKind::Field, end, "an end of the edge");
  addExpression(list);
}

void addInSetting(ItemList& list, const dsl::Keyword& keyword) {
  if (keyword.word == "score") return addScore(list, keyword);
  if (keyword.word == "front") return addFrontOrder(list, keyword);
  addBehind(list, keyword);
}

void addOutcome(ItemList& list) {
  const BlockContext& context = list.context();
  if (holds(context, "because")) {
    list.addWords(dsl::kReasons);
    return list.addWords({"zone hit by edge", "zone hit by vertex"});
  }
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
  if (isFirst) list.addWords(dsl::kOutcomes);
  addExpression(list);
}

void addInTest(ItemList& list, const dsl::Keyword& keyword) {
  if (keyword.word == "expect") return addOutcome(list);
  if (isWithinParentheses(list.context())) return addExpression(list);
  addBehind(list, keyword);
}

void addInProperty(ItemList& list) {
  addVerticesOfRule(list, list.context().title);
  addExpression(list);
}

void addAtBeginning(ItemList& list) {
  const BlockKind block = list.context().block;
  const bool isNew = list.place().document->text.find("af2 ") == std::string::npos;
  if (block == BlockKind::File && isNew) list.addWords({"af2 1;"});
  list.addKeywords(block);
}

void addItems(ItemList& list) {
  const BlockContext& context = list.context();
  if (context.isInComment) return;
  if (context.isInString) return addInString(list);
  if (context.isAtBeginning()) return addAtBeginning(list);
  const auto& words = context.statement;
  if (context.follows(".") && words.size() > 1)
    return addMembers(list, words[words.size() - 2].text);
  if (context.block == BlockKind::File) return addInItem(list);
  if (context.block == BlockKind::Property) return addInProperty(list);
  const dsl::Keyword* keyword = dsl::findKeyword(context.block, words[0].text);
  if (context.block == BlockKind::RuleSet && keyword) return addInSetting(list, *keyword);
  if (context.block == BlockKind::Test && keyword) return addInTest(list, *keyword);
  if (keyword) return addBehind(list, *keyword);
  if (context.block != BlockKind::Meta) addExpression(list);  // an unknown clause
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
