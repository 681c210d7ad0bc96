// The names in clauses, by their role.
#pragma once

#include <initializer_list>
#include <vector>

#include "dsl/syntax/ast.h"

namespace af2::dsl {

/// Calls `visit(role, name, whole)` for every name in a clause; `whole` is empty if the clause does
/// not define the name.
template <class Content>
void visitNames(const Content& content, auto&& visit) {
  visitParts(content,
             Overloaded{[](const Expr&) {}, [&](NameRole role, const Name& name,
                                                Span whole = {}) { visit(role, name, whole); }});
}

/// The names with one of these roles in the clauses of a rule, in the order of the text.
std::vector<const Name*> namesIn(const Rule& rule, std::initializer_list<NameRole> roles);

}  // namespace af2::dsl
