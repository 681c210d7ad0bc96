#include "cli/rules/match_arguments.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/program/usage_error.h"
#include "dsl/run/evaluate.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

double parseNumber(const std::string& option, std::string text, const std::string& whole) {
  std::erase(text, ' ');
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc() && stop == end && std::isfinite(value)) return value;
  throw UsageError(fmt::format("{} '{}': '{}' is not a number", option, whole, text));
}

std::vector<double> parseNumbers(const std::string& option, const std::string& text,
                                 std::size_t count, const char* form) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    numbers.push_back(parseNumber(option, part, text));
  }
  if (numbers.size() == count) return numbers;
  throw UsageError(fmt::format("{} '{}' is not of the form {}", option, text, form));
}

/// Splits "name=value".
std::pair<std::string, std::string> parseAssignment(const std::string& option,
                                                    const std::string& text, const char* form) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError(fmt::format("{} '{}' is not of the form {}", option, text, form));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace

Point2 parsePoint(const std::string& option, const std::string& text) {
  const auto numbers = parseNumbers(option, text, 2, "x,y");
  return {numbers[0], numbers[1]};
}

Point3 parsePoint3(const std::string& option, const std::string& text) {
  const auto numbers = parseNumbers(option, text, 3, "x,y,z");
  return {numbers[0], numbers[1], numbers[2]};
}

std::pair<Point2, Point2> parseSegment(const std::string& option, const std::string& text) {
  const auto numbers = parseNumbers(option, text, 4, "x,y,x,y");
  return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

std::map<std::string, Point2> parseMatch(const std::string& option,
                                         const std::vector<std::string>& texts) {
  std::map<std::string, Point2> match;
  for (const std::string& text : texts) {
    const auto [name, position] = parseAssignment(option, text, "vertex=x,y");
    if (!match.emplace(name, parsePoint(option, position)).second) {
      throw UsageError(fmt::format("{} places vertex '{}' twice", option, name));
    }
  }
  return match;
}

std::map<std::string, double> parseValues(const std::string& option,
                                          const std::vector<std::string>& texts) {
  std::map<std::string, double> values;
  for (const std::string& text : texts) {
    const auto [name, value] = parseAssignment(option, text, "name=number");
    values[name] = parseNumber(option, value, text);
  }
  return values;
}

const AF2Rule& findRule(const RuleSet& rules, const std::string& title) try {
  return dsl::findRule(rules, title);
} catch (const InputError& error) {
  throw UsageError(error.what());
}

std::vector<Point2> matchedVertices(const AF2Rule& rule, const std::map<std::string, Point2>& given,
                                    int level) try {
  return dsl::matchedPositions(rule.definition(), given, level);
} catch (const InputError& error) {
  throw UsageError(error.what());
}

}  // namespace af2::cli
