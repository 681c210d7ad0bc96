#include "dsl/text/diagnostic.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "dsl/text/characters.h"

namespace af2::dsl {
namespace {

using Json = nlohmann::ordered_json;

const char* word(Severity severity) { return severity == Severity::Error ? "error" : "warning"; }

/// Colours and styles of the parts of a message on a terminal.
class Paint {
 public:
  Paint(Colour colour, Severity severity)
      : isOn_(colour == Colour::Terminal),
        loud_(severity == Severity::Error ? "\x1b[1;31m" : "\x1b[1;33m") {}

  std::string loud(const std::string& text) const { return in(loud_, text); }
  std::string strong(const std::string& text) const { return in("\x1b[1m", text); }
  std::string frame(const std::string& text) const { return in("\x1b[1;34m", text); }
  std::string aside(const std::string& text) const { return in("\x1b[1;36m", text); }

 private:
  std::string in(const char* style, const std::string& text) const {
    return isOn_ ? style + text + "\x1b[0m" : text;
  }

  bool isOn_;
  const char* loud_;
};

std::string where(const DiagnosticPlace& place) {
  if (place.line == 0) return place.file;
  return place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

/// Counts characters, not bytes, so that the caret is below the right character.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// `count` characters of the line from number `from` on. A character that a terminal cannot show
/// becomes one question mark, so that columns stay aligned.
std::string printable(std::string_view line, std::size_t from, std::size_t count) {
  std::string result;
  for (std::size_t at = 0, index = 0; at < line.size() && index < from + count;) {
    const auto first = static_cast<unsigned char>(line[at]);
    const std::size_t size = characterSize(line.substr(at));
    const bool isTrail = (first & 0xC0) == 0x80;  // stray byte; columns do not count it either
    const bool isShown = first >= 0x80 ? size > 1 : first >= 0x20 && first != 0x7F;
    if (!isTrail && index++ >= from) {
      if (isShown)
        result += line.substr(at, size);
      else
        result += first == '\t' ? ' ' : '?';
    }
    at += size;
  }
  return result;
}

/// Long lines are cut around the place, so that garbage does not flood the terminal.
struct Excerpt {
  std::string text;
  std::size_t caret = 0, length = 1;
};

Excerpt excerpt(const DiagnosticPlace& place) {
  constexpr std::size_t kWidest = 160;
  Excerpt result{place.text, static_cast<std::size_t>(place.column - place.textColumn), 1};
  const std::size_t width = characters(result.text);
  const std::size_t end = place.endLine == place.line
                              ? static_cast<std::size_t>(place.endColumn - place.textColumn)
                              : width;
  if (end > result.caret) result.length = end - result.caret;
  std::size_t from = 0;
  if (width > kWidest) {
    from = result.caret > kWidest / 2 ? result.caret - kWidest / 2 : 0;
    result.caret -= from;
    result.length = std::min(result.length, kWidest - std::min(kWidest - 1, result.caret));
  }
  result.text = printable(place.text, from, kWidest);
  return result;
}

void appendPicture(std::string& out, const Diagnostic& d, const Paint& paint) {
  if (d.place.line == 0) return;
  const std::string number = std::to_string(d.place.line);
  const std::string margin(number.size(), ' ');
  const Excerpt e = excerpt(d.place);
  out += paint.frame(margin + " |") + "\n" + paint.frame(number + " |") + " " + e.text + "\n";
  out += paint.frame(margin + " |") + " " + std::string(e.caret, ' ') +
         paint.loud(std::string(e.length, '^') + (d.label.empty() ? "" : " " + d.label)) + "\n";
}

std::string margin(const DiagnosticPlace& place) {
  return std::string(std::to_string(std::max(1, place.line)).size(), ' ');
}

Json jsonOf(const Diagnostic& d) {
  Json notes = Json::array();
  if (!d.label.empty()) notes.push_back(d.label);
  for (const DiagnosticNote& note : d.notes) {
    std::string text = note.message;
    if (note.place) text += " (" + where(*note.place) + ")";
    notes.push_back(text);
  }
  Json json{{"file", d.place.file},
            {"line", d.place.line},
            {"column", d.place.column},
            {"end_line", d.place.endLine},
            {"end_column", d.place.endColumn},
            {"severity", word(d.severity)},
            {"code", idOf(d.code)},
            {"message", d.message},
            {"notes", notes},
            {"help", d.help}};
  return json;
}

std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

DiagnosticPlace placeOf(const SourceText& source, Span span) {
  const LinePlace from = source.place(span.begin);
  const LinePlace to = source.place(std::max(span.begin, span.end));
  DiagnosticPlace place{source.name(), from.line, from.column, to.line, to.column, {}};
  const std::string_view line = source.line(from.line);
  constexpr std::size_t kLongest = 4000, kBefore = 400;
  const std::size_t column =
      std::min<std::size_t>(span.begin - source.startOf(from.line), line.size());
  std::size_t first = line.size() > kLongest && column > kBefore ? column - kBefore : 0;
  while (first > 0 && (static_cast<unsigned char>(line[first]) & 0xC0) == 0x80) --first;
  place.text = line.substr(first, kLongest);
  if (first > 0)
    place.textColumn =
        from.column - static_cast<int>(characters(line.substr(first, column - first)));
  return place;
}

bool hasErrors(std::span<const Diagnostic> diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

bool DiagnosticList::takes(Severity severity) {
  const bool isError = severity == Severity::Error;
  hasErrors_ = hasErrors_ || isError;
  if (!isFull()) return true;
  // Errors push warnings out, so that a file with errors never looks clean.
  const auto warning = std::find_if(found_.rbegin(), found_.rend(), [](const Diagnostic& d) {
    return d.severity == Severity::Warning;
  });
  if (!isError || warning == found_.rend()) return false;
  found_.erase(std::next(warning).base());
  return true;
}

void DiagnosticList::add(Diagnostic diagnostic) {
  const bool isKnown = std::any_of(found_.begin(), found_.end(), [&](const Diagnostic& d) {
    return d.code == diagnostic.code && d.place.file == diagnostic.place.file &&
           d.place.line == diagnostic.place.line && d.place.column == diagnostic.place.column;
  });
  if (!isKnown && takes(diagnostic.severity)) found_.push_back(std::move(diagnostic));
}

void DiagnosticList::append(DiagnosticList others) {
  for (Diagnostic& diagnostic : others.found_) add(std::move(diagnostic));
}

std::vector<Diagnostic> DiagnosticList::take() {
  std::map<std::string, std::size_t> fileOrder;
  for (const Diagnostic& d : found_) fileOrder.emplace(d.place.file, fileOrder.size());
  std::stable_sort(found_.begin(), found_.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(fileOrder[a.place.file], a.place.line, a.place.column) <
           std::tuple(fileOrder[b.place.file], b.place.line, b.place.column);
  });
  if (found_.size() > kMax) {
    const std::size_t left = found_.size() - kMax;
    // Warnings give way first, so that a file with errors never looks clean.
    for (std::size_t i = found_.size(); i-- > 0 && found_.size() > kMax;)
      if (found_[i].severity == Severity::Warning)
        found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(i));
    if (found_.size() > kMax) found_.erase(found_.begin() + kMax, found_.end());
    const bool isAll = left + kMax < kKept;
    found_.back().notes.push_back(
        {std::to_string(left) + (isAll ? "" : " or more") + " further findings are not shown", {}});
  }
  return std::move(found_);
}

std::string toPretty(const Diagnostic& d, Colour colour) {
  const Paint paint(colour, d.severity);
  std::string out = paint.loud(std::string(word(d.severity)) + "[" + fullIdOf(d.code) + "]") +
                    paint.strong(": " + d.message) + "\n";
  const std::string indent = margin(d.place);
  out += indent + paint.frame("-->") + " " + where(d.place) + "\n";
  appendPicture(out, d, paint);
  for (const DiagnosticNote& note : d.notes) {
    out += indent + paint.frame(" =") + " " + paint.aside("note") + ": " + note.message;
    if (note.place) out += " (" + where(*note.place) + ")";
    out += "\n";
  }
  if (!d.help.empty())
    out += indent + paint.frame(" =") + " " + paint.aside("help") + ": " + d.help + "\n";
  return out;
}

std::string toPretty(std::span<const Diagnostic> diagnostics, Colour colour) {
  std::string out;
  for (const Diagnostic& d : diagnostics) out += toPretty(d, colour) + "\n";
  return out;
}

std::string toGcc(std::span<const Diagnostic> diagnostics) {
  std::string out;
  for (const Diagnostic& d : diagnostics)
    out += where(d.place) + ": " + word(d.severity) + ": " + d.message + " [" + fullIdOf(d.code) +
           "]\n";
  return out;
}

std::string toJson(std::span<const Diagnostic> diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics) list.push_back(jsonOf(d));
  return dump(list);
}

}  // namespace af2::dsl
