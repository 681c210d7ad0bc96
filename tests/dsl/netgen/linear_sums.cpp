#include "tests/dsl/netgen/linear_sums.h"

#include <cstdio>
#include <sstream>

namespace af2::dsl {
namespace {

LinearSum readSum(std::string_view text) {
  LinearSum sum;
  std::string term;
  const auto close = [&] {
    if (term.empty()) return;
    const std::size_t name = term.find_first_of("xy");
    std::string factor = term.substr(0, name);
    if (!factor.empty() && factor.back() == '*') factor.pop_back();
    if (factor.empty() || factor == "-") factor += "1";
    sum[name == std::string::npos ? "" : term.substr(name)] += std::stod(factor);
    term.clear();
  };
  for (char c : text) {
    if (c == ' ') continue;
    if (c == '+' || c == '-') close();
    if (c != '+') term += c;
  }
  close();
  return sum;
}

double valueOf(const LinearSum& sum, std::span<const Point2> matched) {
  double value = 0;
  for (const auto& [name, weight] : sum) {
    if (name.empty()) {
      value += weight;
      continue;
    }
    const Point2 p = matched[static_cast<std::size_t>(name[1] - '1')];
    value += weight * (name[0] == 'x' ? p.x : p.y);
  }
  return value;
}

/// Twelve decimals hold all the numbers of the classical rules exactly.
std::string decimal(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.12f", value);
  std::string result = text;
  result.erase(result.find_last_not_of('0') + 1);
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string row(const LinearSum& sum) {
  std::string text = "{";
  for (const auto& [name, weight] : sum) {
    if (name.empty()) continue;
    text += (text.size() > 1 ? ", " : " ") + decimal(weight) + ' ' + (name[0] == 'x' ? 'X' : 'Y') +
            name.substr(1);
  }
  return text + " }";
}

std::string pointText(const SumPoint& point, std::span<const Point2> references) {
  const Point2 p = point.at(references);
  return "(" + decimal(p.x) + ", " + decimal(p.y) + ") " + row(point.x) + " " + row(point.y) +
         ";\n";
}

std::string tupleText(const std::vector<int>& tuple) {
  std::string text;
  for (int number : tuple) text += (text.empty() ? "(" : ", ") + std::to_string(number);
  return text + ")";
}

/// The form of a point in "2: 0.5, 0, 1; 3: 0.6, 0, 0.8", in braces; empty: none.
std::string formOf(std::string_view forms, std::size_t point) {
  std::stringstream parts{std::string(forms)};
  for (std::string part; std::getline(parts, part, ';');) {
    const std::size_t colon = part.find(':');
    if (std::stoul(part.substr(0, colon)) == point) return " {" + part.substr(colon + 1) + "}";
  }
  return {};
}

}  // namespace

Point2 SumPoint::at(std::span<const Point2> matched) const {
  return {valueOf(x, matched), valueOf(y, matched)};
}

std::vector<SumPoint> readSums(std::string_view text) {
  std::vector<SumPoint> points;
  while (true) {
    const std::size_t open = text.find('('), comma = text.find(','), close = text.find(')');
    if (open == std::string_view::npos) return points;
    points.push_back({readSum(text.substr(open + 1, comma - open - 1)),
                      readSum(text.substr(comma + 1, close - comma - 1))});
    text.remove_prefix(close + 1);
  }
}

std::vector<std::vector<int>> readTuples(std::string_view text) {
  std::vector<std::vector<int>> tuples;
  std::stringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    std::vector<int> tuple;
    for (char c : word)
      if (c != '-') tuple.push_back(c - '0');
    tuples.push_back(std::move(tuple));
  }
  return tuples;
}

std::vector<Point2> references(const RuleNumbers& rule) {
  std::vector<Point2> points;
  for (const SumPoint& point : readSums(rule.points)) points.push_back(point.at({}));
  return points;
}

std::string rlsText(const RuleNumbers& rule) {
  const std::vector<Point2> reference = references(rule);
  std::string text = "rule \"" + std::string(rule.name) + "\"\n\nquality " +
                     std::to_string(rule.quality) + "\n\nmappoints\n";
  for (std::size_t i = 0; i < reference.size(); ++i)
    text += "(" + decimal(reference[i].x) + ", " + decimal(reference[i].y) + ")" +
            formOf(rule.forms, i + 1) + ";\n";
  text += "\nmaplines\n";
  for (const auto& edge : readTuples(rule.edges)) text += tupleText(edge) + " del;\n";
  const auto points = [&](const char* keyword, std::string_view sums) {
    if (!sums.empty()) text += std::string("\n") + keyword + "\n";
    for (const SumPoint& point : readSums(sums)) text += pointText(point, reference);
  };
  const auto tuples = [&](const char* keyword, std::string_view numbers) {
    if (!numbers.empty()) text += std::string("\n") + keyword + "\n";
    for (const auto& tuple : readTuples(numbers)) text += tupleText(tuple) + ";\n";
  };
  points("newpoints", rule.added);
  tuples("newlines", rule.newLines);
  points("freearea", rule.zone);
  points("freearea2", rule.limit);
  tuples("elements", rule.elements);
  tuples("orientations", rule.orientations);
  return text + "\nendrule\n\n";
}

}  // namespace af2::dsl
