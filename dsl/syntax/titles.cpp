#include "dsl/syntax/titles.h"

#include <algorithm>
#include <optional>

#include "dsl/syntax/names.h"

namespace af2::dsl {
namespace {

/// The values of the parameters, each as short as possible; nothing if the title does not match.
std::optional<std::vector<std::string>> valuesIn(const std::vector<std::string>& parts,
                                                 const std::string& title) {
  if (!title.starts_with(parts.front())) return std::nullopt;
  std::vector<std::string> values;
  std::size_t at = parts.front().size();
  for (std::size_t i = 1; i + 1 < parts.size(); i += 2) {
    const std::string& behind = parts[i + 1];
    const bool isLast = i + 2 == parts.size();
    std::size_t end = std::string::npos;
    if (!isLast) end = title.find(behind, at + 1);
    if (isLast && title.size() > at + behind.size() && title.ends_with(behind))
      end = title.size() - behind.size();
    if (end == std::string::npos) return std::nullopt;
    values.push_back(title.substr(at, end - at));
    at = end + behind.size();
  }
  if (at != title.size()) return std::nullopt;
  return values;
}

}  // namespace

std::vector<std::string> titleParts(const std::string& title) {
  std::vector<std::string> parts{""};
  for (std::size_t at = 0;;) {
    const std::size_t open = title.find('{', at);
    const std::size_t close = open == title.npos ? open : title.find('}', open);
    parts.back() = title.substr(at, close == title.npos ? close : open - at);
    if (close == title.npos) return parts;
    parts.push_back(title.substr(open + 1, close - open - 1));
    parts.emplace_back();
    at = close + 1;
  }
}

std::vector<const Name*> titlesOf(const Item& item) {
  using Titles = std::vector<const Name*>;
  return match(
      item.content, [](const Rule& rule) { return titlesOf(rule); },
      [](const Instance& instance) { return Titles{&instance.title}; },
      [](const AnyOf<std::monostate, Import, Use, Constant, Function, Metric, Extern, RuleSetBlock,
                     Template, Test, Property> auto&) { return Titles(); });
}

std::vector<const Name*> titlesOf(const Rule& rule) {
  std::vector<const Name*> titles = namesIn(rule, {NameRole::MirrorTitle});
  titles.insert(titles.begin(), &rule.title);
  return titles;
}

bool isTitleOf(const std::string& pattern, const std::string& title) {
  return valuesIn(titleParts(pattern), title).has_value();
}

std::string retitled(const std::string& pattern, const std::string& title,
                     const std::string& newPattern) {
  const std::vector<std::string> before = titleParts(pattern);
  const auto values = valuesIn(before, title);
  if (!values) return title;
  std::vector<std::string> after = titleParts(newPattern);
  for (std::size_t i = 1; i < after.size(); i += 2)
    for (std::size_t k = 1; k < before.size(); k += 2)
      if (before[k] == after[i]) {
        after[i] = (*values)[k / 2];
        break;
      }
  std::string result;
  for (const std::string& part : after) result += part;
  return result;
}

std::vector<std::string> titleParameters(const std::string& title) {
  const std::vector<std::string> parts = titleParts(title);
  std::vector<std::string> names;
  for (std::size_t i = 1; i < parts.size(); i += 2) names.push_back(parts[i]);
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace af2::dsl
