#include "dsl/diagnostic.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "dsl/characters.h"
#include "dsl/code_explanations.h"

namespace af2::dsl {
namespace {

using Json = nlohmann::ordered_json;

const char* word(Severity severity) { return severity == Severity::Error ? "error" : "warning"; }

std::string header(const Diagnostic& d) {
  return std::string(word(d.severity)) + "[AF2-" + d.code + "]: " + d.message;
}

std::string where(const DiagnosticPlace& place) {
  if (place.line == 0) return place.file;
  return place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

/// Characters, not bytes, so that carets stand where the eye expects them.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// `count` characters from the one at `from` on; what a terminal cannot show becomes a question
/// mark, and each character stays one.
std::string printable(std::string_view line, std::size_t from, std::size_t count) {
  std::string result;
  for (std::size_t at = 0, index = 0; at < line.size() && index < from + count;) {
    const auto first = static_cast<unsigned char>(line[at]);
    const std::size_t size = characterSize(line.substr(at));
    const bool isTrail = (first & 0xC0) == 0x80;  // astray: places do not count it either
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
  Excerpt result{place.text, static_cast<std::size_t>(place.column - 1), 1};
  const std::size_t width = characters(result.text);
  const std::size_t end =
      place.endLine == place.line ? static_cast<std::size_t>(place.endColumn - 1) : width;
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

void appendPicture(std::string& out, const DiagnosticPlace& place, const std::string& label) {
  if (place.line == 0) return;
  const std::string number = std::to_string(place.line);
  const std::string margin(number.size(), ' ');
  const Excerpt e = excerpt(place);
  out += margin + " |\n" + number + " | " + e.text + "\n";
  out += margin + " | " + std::string(e.caret, ' ') + std::string(e.length, '^');
  if (!label.empty()) out += " " + label;
  out += "\n";
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
            {"code", d.code},
            {"message", d.message},
            {"notes", notes},
            {"help", d.help}};
  return json;
}

std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json sarifRegion(const DiagnosticPlace& p) {
  return {{"startLine", std::max(1, p.line)},
          {"startColumn", std::max(1, p.column)},
          {"endLine", std::max(1, p.endLine)},
          {"endColumn", std::max(1, p.endColumn)}};
}

Json sarifResult(const Diagnostic& d) {
  std::string text = d.message;
  if (!d.label.empty()) text += ": " + d.label;
  if (!d.help.empty()) text += "\nhelp: " + d.help;
  return {{"ruleId", "AF2-" + d.code},
          {"level", word(d.severity)},
          {"message", {{"text", text}}},
          {"locations", Json::array({{{"physicalLocation",
                                       {{"artifactLocation", {{"uri", d.place.file}}},
                                        {"region", sarifRegion(d.place)}}}}})}};
}

}  // namespace

DiagnosticPlace placeOf(const SourceText& source, Span span) {
  const LinePlace from = source.place(span.begin);
  const LinePlace to = source.place(std::max(span.begin, span.end));
  return {source.name(), from.line, from.column,
          to.line,       to.column, std::string(source.line(from.line))};
}

bool hasErrors(std::span<const Diagnostic> diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

void DiagnosticList::add(Diagnostic diagnostic) {
  hasErrors_ = hasErrors_ || diagnostic.severity == Severity::Error;
  const bool isKnown = std::any_of(found_.begin(), found_.end(), [&](const Diagnostic& d) {
    return d.code == diagnostic.code && d.place.file == diagnostic.place.file &&
           d.place.line == diagnostic.place.line && d.place.column == diagnostic.place.column;
  });
  // Far more than are shown, so that sorting can still bring the first ones to the front.
  if (!isKnown && found_.size() < 20 * kMost) found_.push_back(std::move(diagnostic));
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
  if (found_.size() > kMost) {
    const std::size_t left = found_.size() - kMost;
    // Warnings give way first, so that a file with errors never looks clean.
    for (std::size_t i = found_.size(); i-- > 0 && found_.size() > kMost;)
      if (found_[i].severity == Severity::Warning)
        found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(i));
    if (found_.size() > kMost) found_.resize(kMost);
    found_.back().notes.push_back({std::to_string(left) + " more findings are not shown", {}});
  }
  return std::move(found_);
}

std::string toPretty(const Diagnostic& d) {
  std::string out = header(d) + "\n";
  const std::string indent = margin(d.place);
  out += indent + "--> " + where(d.place) + "\n";
  appendPicture(out, d.place, d.label);
  for (const DiagnosticNote& note : d.notes) {
    out += indent + " = note: " + note.message;
    if (note.place) out += " (" + where(*note.place) + ")";
    out += "\n";
  }
  if (!d.help.empty()) out += indent + " = help: " + d.help + "\n";
  return out;
}

std::string toPretty(std::span<const Diagnostic> diagnostics) {
  std::string out;
  for (const Diagnostic& d : diagnostics) out += toPretty(d) + "\n";
  return out;
}

std::string toGcc(std::span<const Diagnostic> diagnostics) {
  std::string out;
  for (const Diagnostic& d : diagnostics)
    out += where(d.place) + ": " + word(d.severity) + ": " + d.message + " [AF2-" + d.code + "]\n";
  return out;
}

std::string toJson(std::span<const Diagnostic> diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics) list.push_back(jsonOf(d));
  return dump(list);
}

std::string toSarif(std::span<const Diagnostic> diagnostics) {
  Json results = Json::array(), rules = Json::array();
  std::map<std::string, bool> seen;
  for (const Diagnostic& d : diagnostics) {
    results.push_back(sarifResult(d));
    if (!seen.emplace(d.code, true).second) continue;
    const CodeExplanation* explanation = findCodeExplanation(d.code);
    rules.push_back({{"id", "AF2-" + d.code},
                     {"shortDescription", {{"text", explanation ? explanation->title : d.code}}}});
  }
  return dump({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
               {"version", "2.1.0"},
               {"runs", Json::array({{{"tool", {{"driver", {{"name", "af2"}, {"rules", rules}}}}},
                                      {"results", results}}})}});
}

}  // namespace af2::dsl
