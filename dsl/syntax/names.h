// The names in clauses, by what they stand for.
#pragma once

#include <initializer_list>
#include <vector>

#include "dsl/syntax/ast.h"

namespace af2::dsl {

/// Calls `visit(role, name, whole)` for every name in a clause; `whole` is empty where the clause
/// gives the name no meaning.
template <class Content>
void visitNames(const Content& content, auto&& visit) {
  visitParts(content,
             Overloaded{[](const Expr&) {}, [&](NameRole role, const Name& name,
                                                Span whole = {}) { visit(role, name, whole); }});
}

/// The names in the clauses of a rule that stand for one of these, in the order of the text.
std::vector<const Name*> namesIn(const Rule& rule, std::initializer_list<NameRole> roles);

}  // namespace af2::dsl
