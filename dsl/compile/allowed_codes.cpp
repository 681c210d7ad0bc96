#include "dsl/compile/allowed_codes.h"

#include <algorithm>
#include <cctype>

namespace af2::dsl {
namespace {

bool isPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-'; }

}  // namespace

std::set<std::string> codesListedIn(const MetaEntry& entry) {
  std::set<std::string> codes;
  if (entry.key.text != "allow") return codes;
  const std::string& list = entry.value.text;
  for (auto at = list.begin(); at != list.end();) {
    at = std::find_if(at, list.end(), isPart);
    const auto end = std::find_if_not(at, list.end(), isPart);
    std::string code(at, end);
    for (char& c : code) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (code.starts_with("AF2-")) code = code.substr(4);
    if (!code.empty()) codes.insert(std::move(code));
    at = end;
  }
  return codes;
}

std::set<Code> allowedBy(const MetaClause& meta) {
  std::set<Code> codes;
  for (const MetaEntry& entry : meta.entries)
    for (const std::string& listed : codesListedIn(entry))
      if (const auto code = findCode(listed)) codes.insert(*code);
  return codes;
}

bool allows(const Rule& rule, Code code) {
  return std::ranges::any_of(rule.clauses, [&](const Clause& clause) {
    const auto* meta = std::get_if<MetaClause>(&clause.content);
    return meta && allowedBy(*meta).contains(code);
  });
}

}  // namespace af2::dsl
