#include "dsl/compile/rule_compiler.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "dsl/compile/clause_compiler.h"
#include "dsl/program/compiled_forms.h"
#include "dsl/syntax/titles.h"
#include "dsl/text/words.h"

namespace af2::dsl {

std::string shownNumber(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

/// Rounds to the number as written, because the conversion to radians and back leaves a rounding
/// error.
static double inDegrees(double radians) {
  constexpr double kDigits = 1e10;
  return std::round(radians * 180 / std::numbers::pi * kDigits) / kDigits;
}

static std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

static void tellUnknownParameter(ExpressionCompiler& expressions, const Name& title,
                                 const std::string& name) {
  std::vector<std::string> known;
  for (const auto& [text, local] : expressions.locals)
    if (local.kind == LocalKind::Parameter) known.push_back(text);
  const Help help = didYouMean(name, known);
  expressions.tell(Code::UnknownName, title.span,
                   "the title contains '{" + name + "}', which is not a parameter of this rule", "",
                   help.empty() ? "parameters come from `for (...)` or from a template" : help);
}

std::string filledTitle(ExpressionCompiler& expressions, const Name& title) {
  std::vector<std::string> parts = titleParts(title.text);
  for (std::size_t i = 1; i < parts.size(); i += 2) {
    const std::string name = std::exchange(parts[i], {});
    const auto local = expressions.locals.find(name);
    const bool isKnown = local != expressions.locals.end();
    const bool isParameter = isKnown && local->second.kind == LocalKind::Parameter;
    const Value value = isParameter ? local->second.value : Value{};
    const auto number = value.isAny() || value.type == Type::Geometric || value.type == Type::Shape
                            ? std::nullopt
                            : expressions.builder().constantValue(value.number);
    if (number) parts[i] = shownNumber(value.type == Type::Angle ? inDegrees(*number) : *number);
    if (isParameter || (isKnown && local->second.kind == LocalKind::Broken)) continue;
    tellUnknownParameter(expressions, title, name);
    break;  // only one finding per place is kept
  }
  return std::accumulate(parts.begin(), parts.end(), std::string());
}

/// The exact mirror image of a rule without errors, with or without a `mirror` clause.
std::shared_ptr<const RuleDefinition> RuleCompiler::imageOf(
    const Rule& rule, const std::map<std::string, Parameter>& parameters) {
  DiagnosticList silent;
  CompileContext quiet{silent, context_.registry};
  quiet.guesses = false;
  const MirrorClause plain;
  ClauseCompiler compiler(quiet, home_, settings_, rule, &plain);
  for (const auto& [name, parameter] : parameters) compiler.define(name, parameter);
  auto compiled = compiler.compile(rule.title.text, rule.title.span);
  if (!compiled) return nullptr;
  return std::make_shared<const RuleDefinition>(std::move(compiled->definition));
}

/// The `mirror` clause; null if there is none.
static const Clause* mirrorOf(const Rule& rule) {
  const auto found = std::ranges::find_if(rule.clauses, [](const Clause& clause) {
    return std::holds_alternative<MirrorClause>(clause.content);
  });
  return found == rule.clauses.end() ? nullptr : &*found;
}

void RuleCompiler::tellFurtherMirrors(const Rule& rule) {
  const Clause* first = mirrorOf(rule);
  for (const Clause& clause : rule.clauses)
    if (std::holds_alternative<MirrorClause>(clause.content) && &clause != first)
      context_.tell(home_, Code::DuplicateName, clause.span, "a rule has one mirror image",
                    "remove this clause");
}

void RuleCompiler::compileOne(const Rule& rule, const std::map<std::string, Parameter>& parameters,
                              const InstanceTitle& title, std::vector<CompiledRule>& result) {
  if (context_.rulesLeft == 0) return;
  if (--context_.rulesLeft == 0) return tellTooMany(title);
  const Clause* mirrorClause = mirrorOf(rule);
  std::vector<const MirrorClause*> forms{nullptr};
  if (mirrorClause) forms.push_back(&std::get<MirrorClause>(mirrorClause->content));
  for (const MirrorClause* mirror : forms) {
    ClauseCompiler compiler(context_, home_, settings_, rule, mirror);
    for (const auto& [name, parameter] : parameters) compiler.define(name, parameter);
    const InstanceTitle ownTitle = mirror ? InstanceTitle{mirror->title, &home_} : title;
    const std::string filled = filledTitle(compiler.expressions(), ownTitle.title);
    const bool isWritten = ownTitle.title.span.end > ownTitle.title.span.begin;
    if (ownTitle.title.text.empty() && isWritten)
      context_.tell(*ownTitle.home, Code::UnexpectedText, ownTitle.title.span,
                    "this title is empty", "name the situation, as in \"right 60\"");
    const Span titleSpan = ownTitle.home == &home_ ? ownTitle.title.span : rule.title.span;
    auto compiled = compiler.compile(filled, titleSpan);
    if (!compiled) continue;
    compiled->doc = rule.doc;
    compiled->titlePlace = placeOf(ownTitle.home->source, ownTitle.title.span);
    compiled->askedAt = placeOf(title.home->source, title.title.span);
    if (ownTitle.home != &home_)
      compiled->definition.source = {ownTitle.home->source.name(), compiled->titlePlace.line,
                                     false};
    compiled->parameters = parameters;
    compiled->mirror = mirror;
    if (!mirror) compiled->image = imageOf(rule, parameters);
    if (mirrorClause) compiled->mirrorSpan = mirrorClause->span;
    result.push_back(std::move(*compiled));
  }
}

void RuleCompiler::tellTooMany(const InstanceTitle& title) {
  context_.tell(
      *title.home, Code::LimitExceeded, title.title.span, "there are too many rules",
      "at most 5000 are possible, including members of families and rules of other files");
}

std::vector<CompiledRule> RuleCompiler::compile(const Rule& rule,
                                                const std::map<std::string, Parameter>& parameters,
                                                const InstanceTitle* instance) {
  std::vector<CompiledRule> result;
  const InstanceTitle ownTitle = instance ? *instance : InstanceTitle{rule.title, &home_};
  tellFurtherMirrors(rule);
  if (!rule.family) {
    compileOne(rule, parameters, ownTitle, result);
    return result;
  }
  ProgramBuilder builder;
  ExpressionCompiler values(context_, home_, ExpressionPlace::Constant, Algebra(builder, {}));
  std::set<std::string> names;
  for (const Name& name : rule.family->names)
    if (!names.insert(name.text).second || parameters.contains(name.text))
      values.tell(Code::DuplicateName, name.span,
                  "the parameter '" + name.text + "' is given twice", "", "choose another name");
  for (const Expr& tuple : rule.family->tuples) {
    if (context_.rulesLeft == 0) break;
    const bool isTuple = tuple.kind == ExprKind::Tuple || tuple.kind == ExprKind::Paren;
    const std::span<const Expr> parts =
        isTuple ? std::span<const Expr>(tuple.parts) : std::span<const Expr>(&tuple, 1);
    if (parts.size() != rule.family->names.size()) {
      values.tell(Code::ArgumentCount, tuple.span,
                  "this gives " + counted(parts.size(), "value") + " for " +
                      counted(rule.family->names.size(), "parameter"),
                  "", "give one value for each parameter");
      continue;
    }
    std::map<std::string, Parameter> all = parameters;
    bool isRight = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Value value = values.evaluate(parts[i]);
      const bool isScalar = value.type == Type::Number || value.type == Type::Angle;
      const auto constant = isScalar ? values.builder().constantValue(value.number) : std::nullopt;
      if (!constant) {
        isRight = false;
        if (!value.isAny())
          values.tell(Code::WrongType, parts[i].span,
                      "a family's value must be a number or an angle",
                      "this is " + describe(value));
        continue;
      }
      Parameter p;
      p.value.type = value.type;
      p.value.number = *constant;
      p.span = rule.family->names[i].span;
      all[rule.family->names[i].text] = p;
    }
    if (isRight) compileOne(rule, all, ownTitle, result);
  }
  return result;
}

std::optional<CompiledProperty> RuleCompiler::compileProperty(const Property& property,
                                                              const Module& written,
                                                              const CompiledRule& rule) {
  ClauseCompiler compiler(context_, *rule.home, settings_, *rule.text, rule.mirror);
  for (const auto& [name, parameter] : rule.parameters) compiler.define(name, parameter);
  if (!compiler.compile(rule.definition.name, rule.title)) return std::nullopt;
  ExpressionCompiler& expressions = compiler.expressions();
  expressions.readIn(written);
  expressions.ruleTitle.clear();
  CompiledProperty result;
  result.title = property.title.text;
  result.span = property.title.span;
  result.rule = rule.definition.name;
  result.firstLevel = result.lastLevel = rule.definition.firstLevel;
  bool isRight = true;
  if (property.variable) {
    const auto first = expressions.constantNumber(property.first, "the first level");
    const auto last = expressions.constantNumber(property.last, "the last level");
    const bool isRange = first && last && *first >= 1 && *first <= *last &&
                         *last <= settings_.maxLevel && *first == std::floor(*first) &&
                         *last == std::floor(*last);
    isRight = isRange;
    if (first && last && !isRange)
      expressions.tell(
          Code::NotConstant, cover(property.first.span, property.last.span),
          "the levels must be whole numbers from 1 to " + std::to_string(settings_.maxLevel));
    if (isRange) {
      result.firstLevel = static_cast<int>(*first);
      result.lastLevel = static_cast<int>(*last);
    }
    Local level;
    level.kind = LocalKind::Parameter;
    level.value = expressions.algebra().scalar(
        Type::Number, expressions.builder().make(Op::Level, std::initializer_list<Node>{}));
    expressions.locals[property.variable->text] = level;
  }
  for (const Expr& expr : property.expectations) {
    const Value value = expressions.truth(expr, "the argument of `expect`");
    isRight = isRight && !value.isAny();
    if (value.isAny()) continue;
    result.expectations.push_back(makeFunction(expressions.builder(), value.number));
    result.expectationSpans.push_back(expr.span);
  }
  if (property.expectations.empty())
    context_.tell(written, Code::IncompleteTest, property.title.span,
                  "this property expects nothing", "add `expect dist(a, b) > 0;`", {},
                  Severity::Warning);
  if (!isRight) return std::nullopt;
  return result;
}

}  // namespace af2::dsl
