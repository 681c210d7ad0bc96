#include "cli/program/number_lists.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

/// A longer range than this is taken for a typing error.
constexpr int kLongestRange = 10'000'000;

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

struct Range {
  int first, last;
};

std::optional<Range> parseRange(std::string_view text) {
  const std::size_t dash = text.find('-');
  const auto first = parsed<int>(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parsed<int>(text.substr(dash + 1));
  if (!first || !last || *first < 1 || *last < *first) return std::nullopt;
  if (*last - *first >= kLongestRange) return std::nullopt;
  return Range{*first, *last};
}

}  // namespace

std::vector<int> parseIds(const std::string& option, const std::string& text) {
  std::set<int> ids;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const auto range = parseRange(part);
    if (!range) {
      throw UsageError(fmt::format(
          "{} '{}': '{}' is neither a number nor a range; write e.g. 3,7-9 (counted from 1)",
          option, text, part));
    }
    for (int id = range->first; id <= range->last; ++id) ids.insert(id);
    begin = end + 1;
  }
  return {ids.begin(), ids.end()};
}

FaceList parseFaces(const std::string& option, const std::string& text, const std::string& what) {
  FaceList list;
  std::string numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    if (part.empty())
      throw UsageError(fmt::format("{} '{}': a number or name of {} is missing", option, text,
                                   what == "edge" ? "an edge" : "a face"));
    if ((part[0] >= '0' && part[0] <= '9') || part[0] == '-')
      numbers += (numbers.empty() ? "" : ",") + part;
    else
      list.names.push_back(part);
    begin = end + 1;
  }
  if (!numbers.empty()) list.ids = parseIds(option, numbers);
  return list;
}

FaceSizeList parseFaceSizes(const std::string& option, const std::vector<std::string>& texts,
                            const std::string& what) {
  FaceSizeList sizes;
  for (const std::string& text : texts) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos)
      throw UsageError(fmt::format(
          "{} '{}': write {}s, '=' and a size, e.g. 3,7-9=0.1 or inlet=0.1", option, text, what));
    const double size = parseSize(option, text.substr(equals + 1));
    const FaceList faces = parseFaces(option, text.substr(0, equals), what);
    for (const int id : faces.ids) sizes.byId[id] = size;
    for (const std::string& name : faces.names) sizes.byName.emplace_back(name, size);
  }
  return sizes;
}

double parsePositive(const std::string& option, const std::string& text, const std::string& what) {
  const auto number = parsed<double>(text);
  if (!number || !std::isfinite(*number) || *number <= 0)
    throw UsageError(fmt::format(
        "{} '{}': {} must be a number greater than 0{}", option, text, what,
        text.find(',') == std::string::npos ? "" : "; write decimals with a point, such as 1.5"));
  return *number;
}

double parseSize(const std::string& option, const std::string& text) {
  return parsePositive(option, text, "the size, in the model's unit,");
}

}  // namespace af2::cli
