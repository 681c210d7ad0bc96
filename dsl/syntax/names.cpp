#include "dsl/syntax/names.h"

#include <algorithm>

namespace af2::dsl {

std::vector<const Name*> namesIn(const Rule& rule, std::initializer_list<NameRole> roles) {
  std::vector<const Name*> names;
  for (const Clause& clause : rule.clauses)
    visitNames(clause.content, [&](NameRole role, const Name& name, Span) {
      if (std::ranges::find(roles, role) != roles.end()) names.push_back(&name);
    });
  return names;
}

}  // namespace af2::dsl
