#include "cli/program/line_difference.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

namespace af2::cli {
namespace {

constexpr std::size_t kContext = 3;

/// Beyond this number of line pairs the changed middle is shown as one replacement.
constexpr std::size_t kMaxPairs = 4'000'000;

using Lines = std::span<const std::string_view>;

struct Line {
  char mark;  ///< ' ' in both texts, '-' only in the old one, '+' only in the new one
  std::string_view text;
};

enum class Breaks { Dropped, Kept };

std::vector<std::string_view> linesOf(std::string_view text, Breaks breaks = Breaks::Dropped) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::size_t next = std::min(end + 1, text.size());
    lines.push_back(text.substr(0, breaks == Breaks::Kept ? next : end));
    text.remove_prefix(next);
  }
  return lines;
}

/// Lengths of the longest common subsequences of all pairs of tails, row by row.
class Tails {
 public:
  Tails(Lines a, Lines b) : width_(b.size() + 1), lengths_((a.size() + 1) * width_) {
    for (std::size_t i = a.size(); i-- > 0;) {
      for (std::size_t j = b.size(); j-- > 0;) {
        lengths_[i * width_ + j] =
            a[i] == b[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
      }
    }
  }
  unsigned at(std::size_t i, std::size_t j) const { return lengths_[i * width_ + j]; }

 private:
  std::size_t width_;
  std::vector<unsigned> lengths_;
};

void appendMiddle(Lines a, Lines b, std::vector<Line>& lines) {
  if (a.size() * b.size() > kMaxPairs) {
    for (const std::string_view text : a) lines.push_back({'-', text});
    for (const std::string_view text : b) lines.push_back({'+', text});
    return;
  }
  const Tails tails(a, b);
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      lines.push_back({' ', a[i]});
      ++i, ++j;
    } else if (i < a.size() && (j == b.size() || tails.at(i + 1, j) >= tails.at(i, j + 1))) {
      lines.push_back({'-', a[i++]});
    } else {
      lines.push_back({'+', b[j++]});
    }
  }
}

std::vector<Line> align(Lines a, Lines b) {
  const auto begin = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
  const auto head = static_cast<std::size_t>(begin);
  std::size_t tail = 0;
  while (tail < std::min(a.size(), b.size()) - head &&
         a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) {
    ++tail;
  }
  std::vector<Line> lines;
  for (const std::string_view text : a.first(head)) lines.push_back({' ', text});
  appendMiddle(a.subspan(head, a.size() - head - tail), b.subspan(head, b.size() - head - tail),
               lines);
  for (const std::string_view text : a.last(tail)) lines.push_back({' ', text});
  return lines;
}

bool isNearChange(const std::vector<Line>& lines, std::size_t at) {
  const std::size_t from = at > kContext ? at - kContext : 0;
  const std::size_t to = std::min(lines.size(), at + kContext + 1);
  return std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(from),
                     lines.begin() + static_cast<std::ptrdiff_t>(to),
                     [](const Line& line) { return line.mark != ' '; });
}

}  // namespace

std::string lineDifference(const std::string& name, const std::string& before,
                           const std::string& after) {
  if (before == after) return {};
  const auto old = linesOf(before), now = linesOf(after);
  const std::vector<Line> lines = align(old, now);
  std::string text = fmt::format("--- {}\n+++ {} (formatted)\n", name, name);
  std::size_t oldLine = 1, newLine = 1;
  bool inHunk = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool shown = isNearChange(lines, i);
    if (shown && !inHunk) text += fmt::format("@@ -{} +{} @@\n", oldLine, newLine);
    if (shown) text += fmt::format("{}{}\n", lines[i].mark, lines[i].text);
    inHunk = shown;
    if (lines[i].mark != '+') ++oldLine;
    if (lines[i].mark != '-') ++newLine;
  }
  return text;
}

std::vector<LineChange> lineChanges(std::string_view before, std::string_view after) {
  const auto old = linesOf(before, Breaks::Kept), now = linesOf(after, Breaks::Kept);
  std::vector<LineChange> changes;
  std::size_t line = 0;
  bool isOpen = false;
  for (const Line& l : align(old, now)) {
    if (l.mark == ' ') {
      isOpen = false;
      ++line;
      continue;
    }
    if (!isOpen) changes.push_back({line, 0, ""});
    isOpen = true;
    if (l.mark == '+') {
      changes.back().text += l.text;
    } else {
      ++changes.back().count;
      ++line;
    }
  }
  return changes;
}

}  // namespace af2::cli
