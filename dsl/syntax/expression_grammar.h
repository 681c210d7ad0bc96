// The grammar of expressions. For grammar.cpp alone.
#pragma once

#include "dsl/syntax/token_parsers.h"

namespace af2::dsl::parsers {

#define AF2_RULE(id, attribute, text, ...) \
  struct id##_id __VA_ARGS__ {};           \
  const x3::rule<id##_id, attribute> id = text

AF2_RULE(expr, Expr, "an expression");
AF2_RULE(negation, Expr, "an expression");
AF2_RULE(comparison, Expr, "an expression");
AF2_RULE(unary, Expr, "an expression");
AF2_RULE(power, Expr, "an expression");
AF2_RULE(post, Expr, "an expression");
AF2_RULE(primary, Expr, "an expression");
AF2_RULE(call, Expr, "an expression");
AF2_RULE(arguments, std::vector<Expr>, "arguments in parentheses");
AF2_RULE(bracketed, Expr, "an expression");
AF2_RULE(choice, Expr, "an expression");
AF2_RULE(corner, Expr, "a corner");

constexpr const char* kExpression = kExpressionWanted;

Expr binary(const std::string& symbol, Expr left, Expr right) {
  Expr result;
  result.kind = ExprKind::Binary;
  result.name = symbol;
  result.span = cover(left.span, right.span);
  result.parts.push_back(std::move(left));
  result.parts.push_back(std::move(right));
  return result;
}

/// operand { operator operand }, grouped from the left.
template <class Operand>
struct LeftGrouped : TokenParser<LeftGrouped<Operand>, Expr> {
  LeftGrouped(Operand const& o, std::initializer_list<const char*> s) : operand(o), symbols(s) {}
  Operand operand;
  std::vector<const char*> symbols;

  bool isOperator(It first, It last) const {
    if (first == last) return false;
    for (const char* symbol : symbols)
      if (first->is(symbol)) return true;
    return false;
  }

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const& context, RContext& rcontext,
             Attribute& attribute) const {
    Expr left;
    if (!operand.parse(first, last, context, rcontext, left)) return false;
    while (isOperator(first, last)) {
      const std::string symbol = first->text;
      ++first;
      Expr right;
      if (!operand.parse(first, last, context, rcontext, right))
        boost::throw_exception(x3::expectation_failure<It>(first, kExpression));
      left = binary(symbol, std::move(left), std::move(right));
    }
    x3::traits::move_to(std::move(left), attribute);
    return true;
  }
};

template <class Operand>
auto leftGrouped(Operand const& operand, std::initializer_list<const char*> symbols) {
  return LeftGrouped<Operand>(operand, symbols);
}

const auto wrap = [](ExprKind kind) {
  return [kind](auto& context) {
    Expr& result = x3::_val(context);
    result.kind = kind;
    result.parts.push_back(std::move(x3::_attr(context)));
  };
};
/// Makes the expression read so far the first part of an expression of another kind.
const auto becomePart = [](Expr& value, ExprKind kind) {
  Expr part = std::move(value);
  value = Expr{};
  value.kind = kind;
  value.parts.push_back(std::move(part));
};
const auto addPart = [](auto& context) {
  x3::_val(context).parts.push_back(std::move(x3::_attr(context)));
};
const auto beginComparison = [](auto& context) {
  becomePart(x3::_val(context), ExprKind::Binary);
  x3::_val(context).name = x3::_attr(context).text;
};
const auto beginRange = [](auto& context) { becomePart(x3::_val(context), ExprKind::In); };
const auto beginFade = [](auto& context) { becomePart(x3::_val(context), ExprKind::Fade); };
const auto beginPower = [](auto& context) {
  becomePart(x3::_val(context), ExprKind::Binary);
  x3::_val(context).name = "^";
};

const auto sum = leftGrouped(leftGrouped(unary, {"*", "/"}), {"+", "-"});
const auto shapeSum = leftGrouped(sum, {"|", "&"});

const auto expr_def = leftGrouped(leftGrouped(negation, {"and"}), {"or"});
const auto negation_def = spanned(
    (word("not") >> need(comparison, kExpression)[wrap(ExprKind::Not)]) | comparison[assign]);

const OneOf compareWord{"<", "<=", ">", ">=", "==", "!="};
const auto comparison_def =
    spanned(shapeSum[assign] >>
            -((compareWord[beginComparison] >> need(shapeSum, kExpression)[addPart]) |
              (Word("in") >> x3::eps[beginRange] >> need(shapeSum, kExpression)[addPart] >>
               need("..") >> need(shapeSum, kExpression)[addPart])));

const auto unary_def =
    spanned((word("-") >> need(power, kExpression)[wrap(ExprKind::Negate)]) | power[assign]);
const auto power_def = spanned(
    post[assign] >> -(word("^") >> x3::eps[beginPower] >> need(unary, kExpression)[addPart]));

const auto takeMember = [](auto& context) {
  Expr& value = x3::_val(context);
  Name& member = x3::_attr(context);
  const bool isCoordinate = member.text == "x" || member.text == "y";
  if (value.kind == ExprKind::Name && !isCoordinate) {
    value.kind = ExprKind::Imported;
    value.qualifier = std::move(value.name);
  } else {
    const Span from = value.span;
    becomePart(value, ExprKind::Member);
    value.span = cover(from, member.span);
  }
  value.span = cover(value.span, member.span);
  value.name = std::move(member.text);
};
const auto takeArguments = [](auto& context) {
  Expr& value = x3::_val(context);
  if (value.kind != ExprKind::Imported) {
    x3::_pass(context) = false;  // only functions of a library are called after a dot
    return;
  }
  value.kind = ExprKind::Call;
  value.parts = std::move(x3::_attr(context));
};
const auto post_def =
    spanned(primary[assign] >>
            *(word(".") >> need(anyName, "x or y")[takeMember] >> -(arguments[takeArguments])));

const auto setName = [](ExprKind kind) {
  return [kind](auto& context) {
    x3::_val(context).kind = kind;
    x3::_val(context).name = std::move(x3::_attr(context).text);
    x3::_val(context).span = x3::_attr(context).span;
  };
};
const auto setArguments = [](auto& context) {
  x3::_val(context).kind = ExprKind::Call;
  x3::_val(context).parts = std::move(x3::_attr(context));
};
const auto closeBracket = [](auto& context) {
  Expr& value = x3::_val(context);
  value.kind = value.parts.size() == 1 ? ExprKind::Paren : ExprKind::Tuple;
};
const auto setIf = [](auto& context) { x3::_val(context).kind = ExprKind::If; };

const auto arguments_def = word("(") >>
                           (word(")") | (list(corner, push, kExpression) >> need(")")));
const auto call_def = name[setName(ExprKind::Name)] >> -(arguments[setArguments]);
const auto bracketed_def = word("(") >> list(corner, addPart, kExpression) >>
                           need(")") >> x3::eps[closeBracket];
const auto choice_def = word("if") >> x3::eps[setIf] >> need(expr, "a condition")[addPart] >>
                        need("then") >> need(expr, kExpression)[addPart] >> need("else") >>
                        need(expr, kExpression)[addPart];
const auto primary_def =
    spanned(number[assign] | choice[assign] | call[assign] | bracketed[assign]);

/// preferred => limit
const auto corner_def = spanned(expr[assign] >> -(word("=>") >> x3::eps[beginFade] >>
                                                  need(expr, kExpression)[addPart] >>
                                                  need(!word("=>"), kNoSecondFade)));

BOOST_SPIRIT_DEFINE(expr, negation, comparison, unary, power, post, primary, call, arguments,
                    bracketed, choice, corner)

}  // namespace af2::dsl::parsers
