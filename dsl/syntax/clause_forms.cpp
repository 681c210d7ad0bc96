#include "dsl/syntax/clause_forms.h"

#include <array>

namespace af2::dsl {
namespace {

struct Form {
  SyntaxUnit unit;
  std::string_view word, example;
};

constexpr auto kForms = [] {
  using enum SyntaxUnit;
  return std::array{
      Form{Item, "import", "`import \"file.af2\" as lib;`"},
      Form{Item, "use", "`use lib.* except \"title\";`"},
      Form{Item, "const", "`const height = 0.866;`"},
      Form{Item, "def", "`def top(p, k) = p + (0, k);`"},
      Form{Item, "metric", "`metric mine(w, u, v, x) = w * dist(u, v);`"},
      Form{Item, "ruleset", "`ruleset \"name\" { elements tri; }`"},
      Form{Item, "rule", "`rule \"title\" quality 1 { ... }`"},
      Form{Item, "template", "`template name(k, h) rule \"title {k}\" quality k { ... }`"},
      Form{Item, "test", "`test \"title\" { front p (0, 0) -> r (1, 0); expect rule \"...\"; }`"},
      Form{Item, "property",
           "`property \"title\" forall match of \"rule\", q in 1..10 { expect ...; }`"},
      Form{RuleHeader, "rule",
           "`rule \"title\" for (k, h) in (1, 0.5), (2, 0.3) quality k { ... }`"},
      Form{Clause, "front", "`front a -> b -> c, d -> e;`"},
      Form{Clause, "at", "`at c (0.5, 0.866) ~ 1, d (1, 1) ~ any;`"},
      Form{Clause, "slope", "`slope b -> c ~ 1;`"},
      Form{Clause, "let", "`let m = mid(a, b), n = mid(b, c);`"},
      Form{Clause, "new", "`new c = mid(a, b) + (0, 0.866);`"},
      Form{Clause, "zone", "`zone a, b, c => mid(a, b) when q > 3;`"},
      Form{Clause, "tri", "`tri a b c, c b d;`"},
      Form{Clause, "quad", "`quad a b c d;`"},
      Form{Clause, "poly", "`poly a b c d;`"},
      Form{Clause, "require", "`require turn(b) < 120deg, dist(b, c) in 0.5..2;`"},
      Form{Clause, "cost", "`cost 0.1 * q;`"},
      Form{Clause, "priority", "`priority 2;`"},
      Form{Clause, "meta", "`meta { author \"name\"; }`"},
      Form{Clause, "mirror", "`mirror \"title\";` or `mirror \"title\" { at c ~ 2; }`"},
      Form{MirrorPart, "at", "`at c ~ 2, d ~ any;`"},
      Form{MirrorPart, "quality", "`quality 2;`"},
      Form{MirrorPart, "cost", "`cost 0.1 * q;`"},
      Form{Setting, "elements", "`elements tri, quad;`"},
      Form{Setting, "match", "`match 0.5 + 0.3*q;`"},
      Form{Setting, "fade", "`fade 1/q;`"},
      Form{Setting, "score", "`score max of shape_size(10);`"},
      Form{Setting, "accept", "`accept score < 2 + 0.5*q^2;`"},
      Form{Setting, "front", "`front by q, len(b - a);` or `front rows(start: smallest_turn);`"},
      Form{Setting, "classes", "`classes 1..50;`"},
      Form{Setting, "scale", "`scale h;` or `scale base;`"},
      Form{Setting, "parity", "`parity even;` or `parity any;`"},
      Form{Setting, "meta", "`meta { author \"name\"; }`"},
      Form{TestClause, "front", "`front p (0, 0) -> r (1, 0), s (0, 2) -> t (1, 2);`"},
      Form{TestClause, "point", "`point s (0.5, 0.9), t (1, 1);`"},
      Form{TestClause, "base", "`base p -> r;`"},
      Form{TestClause, "class", "`class 2;`"},
      Form{TestClause, "size", "`size 0.5;`"},
      Form{TestClause, "expect", "`expect not rule \"title\" because zone hit by edge u -> v;`"},
  };
}();

}  // namespace

std::string_view formOf(SyntaxUnit unit, std::string_view word) {
  for (const Form& form : kForms)
    if (form.unit == unit && form.word == word) return form.example;
  return {};
}

}  // namespace af2::dsl
