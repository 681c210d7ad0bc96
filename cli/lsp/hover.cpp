// Hover: the meaning of a name or a word.
#include <algorithm>
#include <array>

#include "cli/lsp/pictures.h"
#include "cli/lsp/rule_facts.h"
#include "cli/lsp/server.h"
#include "dsl/symbols/block_context.h"
#include "dsl/symbols/word_help.h"
#include "dsl/text/characters.h"

namespace af2::lsp {
namespace {

using dsl::Symbol;
using dsl::SymbolKind;

std::string sourceOf(const Symbol& symbol, dsl::Span span) {
  return std::string(symbol.home->source.text().substr(span.begin, span.end - span.begin));
}

std::string code(const std::string& text) { return "```af2\n" + text + "\n```\n"; }

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// The lines of a doc comment, or nothing.
std::string paragraph(const std::string& doc) { return doc.empty() ? "" : "\n" + doc + "\n"; }

std::string shortNumber(double value) {
  std::string text = std::to_string(value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string constantText(const Symbol& symbol) {
  const auto found = symbol.home->constants.find(symbol.name);
  if (found == symbol.home->constants.end()) return {};
  const dsl::ConstantName& c = found->second;
  if (c.type == dsl::Type::Number) return "= " + shortNumber(c.number);
  if (c.type == dsl::Type::Angle) return "= " + shortNumber(c.number * 57.29577951308232) + "deg";
  if (c.type == dsl::Type::Geometric)
    return "= (" + shortNumber(c.x) + ", " + shortNumber(c.y) + ")";
  return {};
}

std::string factsText(const AF2Rule& rule) {
  const RuleFacts facts = factsOf(rule);
  std::string made;
  if (facts.triangles > 0) made += counted(facts.triangles, "triangle");
  if (facts.quads > 0) made += (made.empty() ? "" : ", ") + counted(facts.quads, "quad");
  return "\n- consumed edges: " + joined(facts.consumed) + "\n- kept edges: " + joined(facts.kept) +
         "\n- new edges: " + joined(facts.made) + "\n- new vertices: " + joined(facts.newVertices) +
         "\n- makes: " + made + "\n";
}

std::string levelsText(const AF2Rule& rule) {
  const RuleDefinition& d = rule.definition();
  if (!d.lastLevel) return "from quality level " + std::to_string(d.firstLevel);
  return "quality levels " + std::to_string(d.firstLevel) + " to " + std::to_string(*d.lastLevel);
}

std::string testsText(const Analysis& analysis, std::size_t rule) {
  const std::size_t count = analysis.symbols.testsOf(rule).size();
  return "- tests that name it: " + (count == 0 ? "none" : std::to_string(count)) + "\n";
}

std::string ruleText(const Session& session, const Analysis& analysis, std::size_t id,
                     const std::string& written) {
  const Symbol& symbol = analysis.symbols[id];
  std::string text = code("rule \"" + symbol.name + "\"");
  if (symbol.isMirror) text += "the mirror image of the rule that contains it\n";
  text += paragraph(symbol.doc);
  const auto rules = analysis.soundRules();
  const auto compiled = analysis.rulesOf(symbol);
  if (compiled.size() > 1)
    text += "\n" + counted(compiled.size(), "rule") + ", one for each tuple\n";
  // For a family, the member that is written, or else the first one.
  std::string title = compiled.empty() ? symbol.name : compiled.front()->definition.name;
  if (rules && findSound(*rules, written)) title = written;
  const AF2Rule* rule = rules ? findSound(*rules, title) : nullptr;
  if (!rule) return text + "\nThe rule has errors, so its edges and vertices are not known.\n";
  text += "\n" + levelsText(*rule) + "\n";
  text += factsText(*rule) + testsText(analysis, id);
  if (session.client.showsPictures) text += "\n" + pictureLink(*rules, *rule) + "\n";
  return text;
}

std::string symbolText(const Session& session, const Place& place, const dsl::Occurrence& found) {
  const Analysis& analysis = *place.analysis;
  const Symbol& symbol = analysis.symbols[found.symbol];
  const std::string& whole = place.document->text;
  if (symbol.kind == SymbolKind::Rule) {
    std::string written = whole.substr(found.span.begin, found.span.end - found.span.begin);
    if (written.size() > 2) written = written.substr(1, written.size() - 2);
    return ruleText(session, analysis, found.symbol, written);
  }
  std::string text;
  switch (symbol.kind) {
    case SymbolKind::RuleSet:
    case SymbolKind::Test:
    case SymbolKind::Property:
      text = code(std::string(wordFor(symbol.kind)) + " \"" + symbol.name + "\"");
      break;
    case SymbolKind::Constant:
    case SymbolKind::Function:
    case SymbolKind::Metric:
      text = code(sourceOf(symbol, symbol.whole)) + constantText(symbol) + "\n";
      break;
    case SymbolKind::Template:
      text = code(sourceOf(symbol, {symbol.whole.begin, symbol.definition.end}) + "(...)");
      break;
    case SymbolKind::Import:
      text = code(sourceOf(symbol, symbol.whole));
      if (!symbol.target) text += "The file cannot be read.\n";
      break;
    default: {
      const bool isWritten = symbol.definition.end > symbol.definition.begin;
      text = code(std::string(wordFor(symbol.kind)) + " " +
                  (isWritten ? sourceOf(symbol, symbol.whole) : symbol.name));
      if (!isWritten) text += "An end of the base edge a -> b.\n";
      if (symbol.owner != dsl::kNoSymbol) {
        const Symbol& owner = analysis.symbols[symbol.owner];
        text += std::string("of ") + wordFor(owner.kind) + " '" + owner.name + "'\n";
      }
    }
  }
  if (symbol.home != &analysis.main()) text += "\nfrom " + symbol.home->source.name() + "\n";
  return text + paragraph(symbol.doc);
}

std::string helpText(std::string_view usage, std::string_view meaning) {
  return code(std::string(usage)) + std::string(meaning) + "\n";
}

/// The start and end of the word at an offset.
dsl::Span wordAt(std::string_view text, std::uint32_t offset) {
  const auto isPart = [&](std::size_t i) { return i < text.size() && dsl::isNamePart(text[i]); };
  dsl::Span span{offset, offset};
  while (span.begin > 0 && isPart(span.begin - 1)) --span.begin;
  while (isPart(span.end)) ++span.end;
  return span;
}

/// Keywords and built-in functions. A word that begins a clause counts as a keyword.
std::string wordText(const Place& place, dsl::Span span) {
  const std::string_view text = place.document->text;
  const std::string_view word = text.substr(span.begin, span.end - span.begin);
  const dsl::BlockContext context = contextAt(place.analysis->main().source, span.begin);
  if (context.isInComment || context.isInString) return {};
  const dsl::Keyword* keyword = dsl::helpForKeyword(context.block, word);
  const auto builtin = dsl::helpForBuiltin(word);
  const bool isCalled = span.end < text.size() && text[span.end] == '(';
  const bool isKeyword = keyword && (context.isAtBeginning() || !builtin) && !isCalled;
  if (isKeyword) return helpText(keyword->form, keyword->help);
  return builtin ? helpText(builtin->usage, builtin->meaning) : std::string();
}

/// Removes the Markdown markup.
std::string plain(const std::string& markdown) {
  std::string text;
  std::size_t at = 0;
  while (at < markdown.size()) {
    const std::size_t end = std::min(markdown.find('\n', at), markdown.size());
    const std::string line = markdown.substr(at, end - at);
    if (!line.starts_with("```")) text += line + "\n";
    at = end + 1;
  }
  return text;
}

std::optional<Json> hover(Session& session, const Json&, const Json& params) {
  const Place place = session.placeOf(params);
  const auto found = place.analysis->symbols.at(place.analysis->main(), place.offset);
  dsl::Span span = found ? found->span : wordAt(place.document->text, place.offset);
  std::string text = found ? symbolText(session, place, *found) : wordText(place, span);
  if (text.empty()) return Json(nullptr);
  const bool isMarkdown = session.client.readsMarkdown;
  return Json{{"contents",
               {{"kind", isMarkdown ? "markdown" : "plaintext"},
                {"value", isMarkdown ? text : plain(text)}}},
              {"range", session.map(place.document->text).range(span)}};
}

constexpr std::array kHoverMethods{
    Method{"textDocument/hover", hover},
};

}  // namespace

std::span<const Method> hoverMethods() { return kHoverMethods; }

}  // namespace af2::lsp
