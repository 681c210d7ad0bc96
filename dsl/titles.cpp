#include "dsl/titles.h"

namespace af2::dsl {

std::vector<const Name*> titlesOf(const Item& item) {
  if (const auto* instance = std::get_if<Instance>(&item.content)) return {&instance->title};
  const auto* rule = std::get_if<Rule>(&item.content);
  if (!rule) return {};
  std::vector<const Name*> titles{&rule->title};
  for (const Clause& clause : rule->clauses)
    if (const auto* mirror = std::get_if<MirrorClause>(&clause.content))
      titles.push_back(&mirror->title);
  return titles;
}

bool mayBecome(std::string_view written, std::string_view title) {
  if (written == title) return true;
  const std::size_t open = written.find('{'), close = written.rfind('}');
  if (open == written.npos || close == written.npos || close < open) return false;
  const std::string_view tail = written.substr(close + 1);
  return title.size() >= open + tail.size() && title.starts_with(written.substr(0, open)) &&
         title.ends_with(tail);
}

}  // namespace af2::dsl
