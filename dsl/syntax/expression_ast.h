// Names and expressions of the syntax tree, and how the parts of a clause are visited. See ast.h.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "dsl/syntax/match.h"
#include "dsl/text/keywords.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

/// A name or a string with its span.
struct Name {
  std::string text;
  Span span;
};

enum class ExprKind {
  Missing,   ///< could not be read
  Number,    ///< 12; `name` keeps the digits as written
  Angle,     ///< 60deg, in degrees
  Name,      ///< a
  Imported,  ///< lib.H: `qualifier`.`name`
  Call,      ///< f(x, ...), or lib.f(x, ...)
  Paren,     ///< (x)
  Tuple,     ///< (x, y): a vector; with three parts a tolerance form; more only in families
  Member,    ///< p.x: `name` is x or y
  Negate,
  Not,
  Binary,  ///< `name` is the operator: + - * / ^ < <= > >= == != and or | &
  In,      ///< x in from..to
  If,      ///< if c then x else y
  Fade,    ///< preferred => limit, in zones only
};

struct Expr {
  ExprKind kind = ExprKind::Missing;
  Span span;
  std::string name, qualifier;
  double number = 0;
  std::vector<Expr> parts;

  bool isMissing() const { return kind == ExprKind::Missing; }
};

struct Tolerance {
  bool any = false;
  Expr form;  ///< a weight, or a Tuple of three; not read if `any`
  Span span;
};

// Each clause, setting and clause of a test lists its parts with `visitParts(part)`, in the order
// of the text. Code that needs the names or expressions of any clause, such as the symbol index,
// uses this list. `part` is called with
//
//     part(expr)                an expression that the clause evaluates
//     part(role, name)          a name and its role
//     part(role, name, whole)   a name that the clause defines, and the text of the definition

/// The parts of the clause in `content`. A clause that could not be read has none.
template <class... Contents>
void visitParts(const std::variant<std::monostate, Contents...>& content, auto&& part) {
  match(
      content, [](std::monostate) {},
      [&](const AnyOf<Contents...> auto& held) { held.visitParts(part); });
}

}  // namespace af2::dsl
