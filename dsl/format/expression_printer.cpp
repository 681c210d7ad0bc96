// Prints expressions as canonical text.
#include "dsl/format/printer.h"

namespace af2::dsl {
namespace {

std::string list(const std::vector<Expr>& parts) {
  std::string text;
  for (const Expr& part : parts) text += (text.empty() ? "" : ", ") + printExpression(part);
  return text;
}

/// Products are printed without spaces, sums with spaces: 0.5 + 0.3*q. If an operand is not a
/// single word, the product also has spaces.
bool isShort(const Expr& e) {
  switch (e.kind) {
    case ExprKind::Number:
    case ExprKind::Angle:
    case ExprKind::Name:
    case ExprKind::Imported:
    case ExprKind::Member:
      return true;
    case ExprKind::Paren:
      return isShort(e.parts[0]);
    case ExprKind::Binary:
      return (e.name == "^" || e.name == "*" || e.name == "/") && isShort(e.parts[0]) &&
             isShort(e.parts[1]);
    default:
      return false;
  }
}

std::string binary(const Expr& e) {
  const std::string left = printExpression(e.parts[0]), right = printExpression(e.parts[1]);
  const bool isClose = e.name == "^" || ((e.name == "*" || e.name == "/") && isShort(e.parts[0]) &&
                                         isShort(e.parts[1]));
  return isClose ? left + e.name + right : left + " " + e.name + " " + right;
}

}  // namespace

std::string printExpression(const Expr& e) {
  switch (e.kind) {
    case ExprKind::Missing:
      return "";
    case ExprKind::Number:
      return e.name;
    case ExprKind::Angle:
      return e.name + "deg";
    case ExprKind::Name:
      return e.name == "class" ? "q" : e.name;
    case ExprKind::Imported:
      return e.qualifier + "." + e.name;
    case ExprKind::Call:
      return (e.qualifier.empty() ? "" : e.qualifier + ".") + e.name + "(" + list(e.parts) + ")";
    case ExprKind::Paren:
    case ExprKind::Tuple:
      return "(" + list(e.parts) + ")";
    case ExprKind::Member:
      // A number needs the space: `1.x` is not a number.
      return printExpression(e.parts[0]) + (e.parts[0].kind == ExprKind::Number ? " ." : ".") +
             e.name;
    case ExprKind::Negate:
      return "-" + printExpression(e.parts[0]);
    case ExprKind::Not:
      return "not " + printExpression(e.parts[0]);
    case ExprKind::Binary:
      return binary(e);
    case ExprKind::In:
      return printExpression(e.parts[0]) + " in " + printExpression(e.parts[1]) + ".." +
             printExpression(e.parts[2]);
    case ExprKind::If:
      return "if " + printExpression(e.parts[0]) + " then " + printExpression(e.parts[1]) +
             " else " + printExpression(e.parts[2]);
    case ExprKind::Fade:
      return printExpression(e.parts[0]) + " => " + printExpression(e.parts[1]);
  }
  return "";
}

}  // namespace af2::dsl
