// Formatting: the layout of `af2 fmt`, as edits.
#include <array>

#include "cli/lsp/server.h"
#include "cli/program/line_difference.h"
#include "dsl/format/printer.h"

namespace af2::lsp {
namespace {

/// Keeps the kind of line breaks that the file has.
std::string withBreaksOf(const std::string& like, std::string text) {
  const std::size_t first = like.find('\n');
  if (first == std::string::npos || first == 0 || like[first - 1] != '\r') return text;
  std::string result;
  for (const char c : text) {
    if (c == '\n') result += '\r';
    result += c;
  }
  return result;
}

/// Returns no edits for a text that cannot be read; its diagnostics already report why.
std::vector<cli::LineChange> changesOf(const Session& session, const Document& document) {
  const dsl::Formatted formatted = dsl::format(document.path, document.text);
  if (dsl::hasErrors(formatted.diagnostics)) {
    session.notify(
        "window/logMessage",
        {{"type", 3}, {"message", "not formatted, because it cannot be read: " + document.path}});
    return {};
  }
  return cli::lineChanges(document.text, withBreaksOf(document.text, formatted.text));
}

Json editOf(const TextMap& map, const cli::LineChange& change) {
  return {
      {"range", map.range({map.startOf(change.first), map.startOf(change.first + change.count)})},
      {"newText", change.text}};
}

std::optional<Json> formatting(Session& session, const Json&, const Json& params) {
  const auto document = session.documentOf(params);
  const TextMap map = session.map(document->text);
  Json edits = Json::array();
  for (const cli::LineChange& change : changesOf(session, *document))
    edits.push_back(editOf(map, change));
  return edits;
}

/// The edits that touch the given lines.
std::optional<Json> rangeFormatting(Session& session, const Json&, const Json& params) {
  const auto document = session.documentOf(params);
  const TextMap map = session.map(document->text);
  const dsl::Span span = map.span(params.at("range"));
  const std::size_t first = map.lineOf(span.begin), last = map.lineOf(span.end);
  Json edits = Json::array();
  for (const cli::LineChange& change : changesOf(session, *document)) {
    const std::size_t end = change.first + std::max<std::size_t>(change.count, 1);
    if (change.first <= last && first < end) edits.push_back(editOf(map, change));
  }
  return edits;
}

constexpr std::array kFormattingMethods{
    Method{"textDocument/formatting", formatting},
    Method{"textDocument/rangeFormatting", rangeFormatting},
};

}  // namespace

std::span<const Method> formattingMethods() { return kFormattingMethods; }

}  // namespace af2::lsp
