// Code actions: corrections for diagnostics, applied by the editor.
#include <algorithm>
#include <array>

#include "cli/lsp/server.h"
#include "dsl/format/printer.h"

namespace af2::lsp {
namespace {

using dsl::Diagnostic;

/// A text that replaces a span.
struct Fix {
  std::string title;
  dsl::Span span;
  std::string text;
};

/// The data that a fix may use.
struct Fault {
  const Document& document;
  const Analysis& analysis;
  const Diagnostic& diagnostic;
  dsl::Span span;
  bool isFromChecks = false;  ///< from the checks over many matches

  std::string_view text() const { return document.text; }
};

std::uint32_t endOf(const Fault& fault) {
  return static_cast<std::uint32_t>(fault.document.text.size());
}

/// The rule of the file that a diagnostic names, including families and mirrored rules.
const dsl::Rule* ruleOf(const Fault& fault) {
  for (const dsl::CompiledRule& rule : fault.analysis.loaded.file->rules)
    if (rule.definition.name == fault.diagnostic.rule && rule.home == &fault.analysis.main())
      return rule.text;
  return nullptr;
}

/// Adds a clause at the end of a rule.
std::optional<Fix> addClause(const Fault& fault, std::string title, const std::string& clause) {
  const dsl::Rule* rule = ruleOf(fault);
  if (!rule || rule->clauses.empty()) return std::nullopt;
  const std::uint32_t behind = rule->clauses.back().span.end;
  return Fix{std::move(title), {behind, behind}, "\n  " + clause};
}

/// `meta { allow ... }` is for findings that are intended.
std::optional<Fix> allow(const Fault& fault) {
  const bool isWarning = fault.isFromChecks && fault.diagnostic.severity == dsl::Severity::Warning;
  const dsl::Rule* rule = isWarning ? ruleOf(fault) : nullptr;
  const bool hasMeta = rule && std::ranges::any_of(rule->clauses, [](const dsl::Clause& c) {
                         return std::holds_alternative<dsl::MetaClause>(c.content);
                       });
  if (!rule || hasMeta) return std::nullopt;
  return addClause(fault, "this is intended: allow " + dsl::idOf(fault.diagnostic.code),
                   "meta { allow \"" + dsl::idOf(fault.diagnostic.code) + "\"; }");
}

/// Adds the counter-example as a formatted test at the end of the file.
std::optional<Fix> addTest(const Fault& fault) {
  for (const dsl::DiagnosticNote& note : fault.diagnostic.notes) {
    if (note.kind != dsl::DiagnosticNote::Kind::Test) continue;
    const dsl::Formatted formatted = dsl::format("", "af2 1;\n\n" + note.message);
    const std::size_t begin = formatted.text.find("test \"");
    if (begin == std::string::npos) continue;
    const bool endsLine = fault.text().ends_with('\n');
    return Fix{"add the counter-example as a test",
               {endOf(fault), endOf(fault)},
               (endsLine ? "\n" : "\n\n") + formatted.text.substr(begin)};
  }
  return std::nullopt;
}

constexpr std::array kFixes{addTest, allow};

class ActionList {
 public:
  ActionList(const Session& session, const Document& document, const Analysis& analysis,
             dsl::Span wanted)
      : document_(document),
        analysis_(analysis),
        map_(session.map(document.text)),
        wanted_(wanted) {}

  void add(const Diagnostic& diagnostic, bool isFromChecks) {
    if (!isHere(diagnostic.place)) return;
    const dsl::Span span = spanOf(diagnostic.place);
    // Uses whole lines, because the cursor need not be on the word itself.
    if (!touches(span, wanted_)) return;
    for (const dsl::SuggestedEdit& edit : diagnostic.edits)
      if (isHere(edit.place)) offer({edit.what, spanOf(edit.place), edit.replacement}, true);
    for (const auto fix : kFixes)
      if (const auto found = fix({document_, analysis_, diagnostic, span, isFromChecks}))
        offer(*found, false);
  }

  Json take() { return std::move(list_); }

 private:
  bool isHere(const dsl::DiagnosticPlace& place) const {
    return place.file == analysis_.main().source.name();
  }
  dsl::Span spanOf(const dsl::DiagnosticPlace& place) const {
    const dsl::SourceText& source = analysis_.main().source;
    return {source.offsetOf({place.line, place.column}),
            source.offsetOf({place.endLine, place.endColumn})};
  }

  /// Whether two spans share a line.
  bool touches(dsl::Span a, dsl::Span b) const {
    return map_.lineOf(a.begin) <= map_.lineOf(b.end) && map_.lineOf(b.begin) <= map_.lineOf(a.end);
  }

  void offer(const Fix& fix, bool isPreferred) {
    const Json edit{{"range", map_.range(fix.span)}, {"newText", fix.text}};
    Json action{{"title", fix.title},
                {"kind", "quickfix"},
                {"isPreferred", isPreferred},
                {"edit", {{"changes", {{document_.uri, Json::array({edit})}}}}}};
    if (std::ranges::find(list_, action) == list_.end()) list_.push_back(std::move(action));
  }

  const Document& document_;
  const Analysis& analysis_;
  TextMap map_;
  dsl::Span wanted_;
  Json list_ = Json::array();
};

bool wantsQuickFixes(const Json& params) {
  const Json context = params.value("context", Json::object());
  if (!context.contains("only") || !context["only"].is_array()) return true;
  return std::ranges::any_of(context["only"],
                             [](const Json& kind) { return kind == "quickfix" || kind == ""; });
}

std::optional<Json> codeActions(Session& session, const Json&, const Json& params) {
  if (!wantsQuickFixes(params)) return Json::array();
  const auto document = session.documentOf(params);
  const auto analysis = session.analysis(*document);
  const dsl::Span wanted = session.map(document->text).span(params.at("range"));
  ActionList list(session, *document, *analysis, wanted);
  for (const Diagnostic& d : analysis->loaded.diagnostics) list.add(d, false);
  for (const Diagnostic& d : document->checked) list.add(d, true);
  return list.take();
}

constexpr std::array kMethods{Method{"textDocument/codeAction", codeActions}};

}  // namespace

std::span<const Method> actionMethods() { return kMethods; }

}  // namespace af2::lsp
