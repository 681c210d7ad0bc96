#include "dsl/netgen/rls_families.h"

#include <algorithm>
#include <array>
#include <map>

#include "dsl/text/characters.h"

namespace af2::dsl {
namespace {

using NumberTexts = std::vector<std::string>;

/// A text with its numbers removed: "a + (0, 0.5)" is {"a + (", ", ", ")"} with 0 and 0.5.
struct Skeleton {
  std::vector<std::string> words{""};
  NumberTexts numbers;
};

bool isPartOfName(char c) { return isNamePart(c) || c == '.'; }

void take(Skeleton& skeleton, const std::string& text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const bool isNumber = isDigit(text[i]) && (i == 0 || !isPartOfName(text[i - 1]));
    if (!isNumber) {
      skeleton.words.back() += text[i++];
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && (isDigit(text[end]) || text[end] == '.')) ++end;
    skeleton.numbers.push_back(text.substr(i, end - i));
    skeleton.words.emplace_back();
    i = end;
  }
}

/// Title, quality and clauses in sequence, with their numbers in the same order.
struct RuleSkeleton {
  Skeleton whole;
  std::size_t titleNumbers = 0;
};

RuleSkeleton skeletonOf(const RuleText& rule) {
  RuleSkeleton result;
  take(result.whole, rule.title + "\n");
  result.titleNumbers = result.whole.numbers.size();
  take(result.whole, std::to_string(rule.quality));
  for (const std::string& clause : rule.clauses) take(result.whole, "\n" + clause);
  return result;
}

/// The columns of numbers in which the rules of a family differ, and their parameter names.
class NetgenFamily {
 public:
  NetgenFamily(const RuleSkeleton& like, std::vector<NumberTexts> rows)
      : like_(like), rows_(std::move(rows)) {
    for (std::size_t column = 0; column < like.whole.numbers.size(); ++column) nameColumn(column);
  }

  std::size_t parameterCount() const { return columns_.size(); }
  bool titlesDiffer() const { return titlesDiffer_; }

  std::string text() const {
    std::string tuples;
    for (const NumberTexts& row : rows_) tuples += (tuples.empty() ? "" : ", ") + tuple(row);
    std::string names;
    for (std::size_t column : columns_) names += (names.empty() ? "" : ", ") + names_.at(column);
    const std::string body = filled();
    const std::size_t titleEnd = body.find('\n'), qualityEnd = body.find('\n', titleEnd + 1);
    std::string text = "rule \"" + body.substr(0, titleEnd) + "\" for (" + names + ") in " +
                       tuples + " quality " + body.substr(titleEnd + 1, qualityEnd - titleEnd - 1) +
                       " {\n";
    std::size_t at = qualityEnd;
    while (at != std::string::npos) {
      const std::size_t end = body.find('\n', at + 1);
      text += "  " + body.substr(at + 1, end == std::string::npos ? end : end - at - 1) + "\n";
      at = end;
    }
    return text + "}\n";
  }

 private:
  NumberTexts valuesOf(std::size_t column) const {
    NumberTexts values;
    for (const NumberTexts& row : rows_) values.push_back(row[column]);
    return values;
  }

  void nameColumn(std::size_t column) {
    const NumberTexts values = valuesOf(column);
    const bool differ =
        std::ranges::any_of(values, [&](const std::string& v) { return v != values[0]; });
    if (!differ) return;
    if (column < like_.titleNumbers) titlesDiffer_ = true;
    for (std::size_t earlier : columns_)
      if (valuesOf(earlier) == values) {
        names_[column] = names_.at(earlier);
        return;
      }
    constexpr std::array kNames{"k", "s", "t", "u", "v", "w"};
    names_[column] = kNames[std::min(columns_.size(), kNames.size() - 1)];
    columns_.push_back(column);
  }

  std::string tuple(const NumberTexts& row) const {
    if (columns_.size() == 1) return row[columns_[0]];
    std::string text;
    for (std::size_t column : columns_) text += (text.empty() ? "(" : ", ") + row[column];
    return text + ")";
  }

  std::string filled() const {
    std::string text;
    for (std::size_t i = 0; i < like_.whole.words.size(); ++i) {
      text += like_.whole.words[i];
      if (i == like_.whole.numbers.size()) break;
      const auto name = names_.find(i);
      if (name == names_.end())
        text += like_.whole.numbers[i];
      else
        text += i < like_.titleNumbers ? "{" + name->second + "}" : name->second;
    }
    return text;
  }

  const RuleSkeleton& like_;
  std::vector<NumberTexts> rows_;
  std::vector<std::size_t> columns_;  // the first of each parameter
  std::map<std::size_t, std::string> names_;
  bool titlesDiffer_ = false;
};

std::string plainText(const RuleText& rule) {
  std::string text = "rule \"" + rule.title + "\" quality " + std::to_string(rule.quality) + " {\n";
  for (const std::string& clause : rule.clauses) text += "  " + clause + "\n";
  return text + "}\n";
}

std::string remarksText(const RuleText& rule) {
  std::string text;
  for (const std::string& remark : rule.remarks) text += "# note: " + remark + "\n";
  return text;
}

}  // namespace

std::string writeRules(const std::vector<RuleText>& rules) {
  constexpr std::size_t kMaxParameters = 4;
  std::vector<RuleSkeleton> skeletons;
  for (const RuleText& rule : rules) skeletons.push_back(skeletonOf(rule));
  std::vector<bool> isWritten(rules.size());
  std::string text;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (isWritten[i]) continue;
    std::vector<std::size_t> members{i};
    std::vector<NumberTexts> rows{skeletons[i].whole.numbers};
    for (std::size_t j = i + 1; j < rules.size(); ++j) {
      const bool isLike = skeletons[j].whole.words == skeletons[i].whole.words &&
                          rules[i].remarks.empty() && rules[j].remarks.empty();
      if (isWritten[j] || !isLike || rules[i].hasMirror) continue;
      members.push_back(j);
      rows.push_back(skeletons[j].whole.numbers);
    }
    const NetgenFamily family(skeletons[i], rows);
    const bool isFamily =
        members.size() > 1 && family.titlesDiffer() && family.parameterCount() <= kMaxParameters;
    text += "\n" + remarksText(rules[i]) + (isFamily ? family.text() : plainText(rules[i]));
    if (isFamily)
      for (std::size_t member : members) isWritten[member] = true;
  }
  return text;
}

}  // namespace af2::dsl
