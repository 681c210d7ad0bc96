#include "dsl/proof/test_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace af2::dsl {
namespace {

std::string place(const std::string& name, Point2 at) {
  return fmt::format("{} ({}, {})", name, shortest(at.x), shortest(at.y));
}

class Writer {
 public:
  explicit Writer(const PatternMatch& match)
      : match_(match), rule_(match.rule().definition()), isPlaced_(rule_.vertices.size()) {}

  std::string write(const TestText& text) {
    std::string result = fmt::format("test \"{}\" {{\n", text.title);
    result += "  front " + chains() + ";\n";
    const std::string points = isolated(text.obstacles);
    if (!points.empty()) result += "  point " + points + ";\n";
    result += fmt::format("  base {} -> {};\n", rule_.vertices[0].name, rule_.vertices[1].name);
    if (match_.level() != 1) result += fmt::format("  class {};\n", match_.level());
    return result + fmt::format("  expect {};\n}}\n", text.expectation);
  }

 private:
  std::string vertex(int index) {
    const std::string& name = rule_.vertices[index].name;
    if (isPlaced_[index]) return name;
    isPlaced_[index] = true;
    return place(name, match_.vertices()[index]);
  }

  std::string chains() {
    std::string result;
    for (const std::vector<int>& chain : chainsOf(rule_)) {
      if (!result.empty()) result += ", ";
      for (std::size_t i = 0; i < chain.size(); ++i)
        result += (i == 0 ? "" : " -> ") + vertex(chain[i]);
    }
    return result;
  }

  std::string isolated(const std::vector<Point2>& obstacles) {
    std::vector<std::string> points;
    for (std::size_t i = 0; i < isPlaced_.size(); ++i)
      if (!isPlaced_[i]) points.push_back(vertex(static_cast<int>(i)));
    for (std::size_t i = 0; i < obstacles.size(); ++i)
      points.push_back(place(obstacleName(i, obstacles.size()), obstacles[i]));
    std::string result;
    for (const std::string& point : points) result += (result.empty() ? "" : ", ") + point;
    return result;
  }

  /// "o", or "o1", "o2", ...; with underscores if the rule has a vertex of that name.
  std::string obstacleName(std::size_t index, std::size_t count) const {
    std::string name = count == 1 ? "o" : fmt::format("o{}", index + 1);
    const auto isTaken = [&](const PatternVertex& v) { return v.name == name; };
    while (std::any_of(rule_.vertices.begin(), rule_.vertices.end(), isTaken)) name += '_';
    return name;
  }

  const PatternMatch& match_;
  const RuleDefinition& rule_;
  std::vector<bool> isPlaced_;
};

}  // namespace

std::string refusedOtherwise(const std::string& title) {
  return fmt::format(
      "not rule \"{}\" because pattern or require or class or inverted or score or beaten", title);
}

std::string percent(double share) {
  const double value = 100 * share;
  return value >= 10 || value == 0 ? fmt::format("{:.0f} %", value)
                                   : fmt::format("{:.2g} %", value);
}

std::string shortest(double number) { return fmt::format("{}", number == 0 ? 0.0 : number); }

std::string writeTest(const PatternMatch& match, const TestText& text) {
  return Writer(match).write(text);
}

}  // namespace af2::dsl
