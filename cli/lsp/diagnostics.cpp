// textDocument/publishDiagnostics: findings from the text at once, findings of the slow checks
// later.
#include <algorithm>
#include <set>

#include "cli/lsp/server.h"
#include "cli/lsp/uri.h"
#include "dsl/proof/coverage.h"
#include "dsl/proof/match_diagnostics.h"

namespace af2::lsp {
namespace {

using dsl::Diagnostic;

enum SeverityCode { kError = 1, kWarning = 2 };

std::string messageOf(const Diagnostic& d) {
  std::string text = d.message;
  if (!d.label.empty()) text += ": " + d.label;
  for (const dsl::DiagnosticNote& note : d.notes)
    if (!note.place) text += "\nnote: " + note.message;
  if (!d.help.empty()) text += "\nhelp: " + d.help;
  return text;
}

/// Turns the findings about one document into diagnostics of the protocol.
class Writer {
 public:
  Writer(const Session& session, const Document& document, const Analysis& analysis)
      : session_(session),
        document_(document),
        analysis_(analysis),
        map_(session.map(document.text)) {}

  void add(const Diagnostic& d) {
    if (d.place.file != analysis_.main().source.name()) return addImported(d);
    Json json{{"range", rangeOf(d.place)},
              {"severity", severityOf(d)},
              {"code", dsl::fullIdOf(d.code)},
              {"source", "af2"},
              {"message", messageOf(d)}};
    Json related = Json::array();
    for (const dsl::DiagnosticNote& note : d.notes)
      if (note.place) addRelated(related, *note.place, note.message);
    if (!related.empty()) json["relatedInformation"] = std::move(related);
    if (d.isUnused) json["tags"] = {1};  // shown faded
    json["data"] = {{"help", d.help}};
    if (!d.rule.empty()) json["data"]["rule"] = d.rule;
    for (const dsl::DiagnosticNote& note : d.notes)
      if (note.kind == dsl::DiagnosticNote::Kind::Test) json["data"]["test"] = note.message;
    list_.push_back(std::move(json));
  }

  Json take() {
    for (Json& json : imported_) list_.push_back(std::move(json));
    return std::move(list_);
  }

 private:
  static int severityOf(const Diagnostic& d) {
    return d.severity == dsl::Severity::Warning ? kWarning : kError;
  }

  Json rangeOf(const dsl::DiagnosticPlace& place) const {
    const dsl::SourceText& source = analysis_.main().source;
    if (place.line == 0) return map_.range(nameOfRuleSet());
    dsl::Span span{source.offsetOf({place.line, place.column}),
                   source.offsetOf({place.endLine, place.endColumn})};
    if (span.end <= span.begin) span.end = std::min(span.begin + 1, sizeOf(source));
    return map_.range(span);
  }

  static std::uint32_t sizeOf(const dsl::SourceText& source) {
    return static_cast<std::uint32_t>(source.text().size());
  }

  dsl::Span nameOfRuleSet() const {
    for (const dsl::Symbol& s : analysis_.symbols.symbols())
      if (s.kind == dsl::SymbolKind::RuleSet && s.home == &analysis_.main()) return s.definition;
    return {};
  }

  void addRelated(Json& list, const dsl::DiagnosticPlace& place, const std::string& message) const {
    for (const auto& module : analysis_.loaded.file->modules) {
      if (module->source.name() != place.file) continue;
      const std::string uri = session_.uriOfModule(document_, analysis_, *module);
      if (uri.empty() || place.line == 0) return;
      const dsl::SourceText& source = module->source;
      const dsl::Span span{source.offsetOf({place.line, place.column}),
                           source.offsetOf({place.endLine, place.endColumn})};
      const Json range = session_.map(source.text()).range(span);
      list.push_back({{"location", {{"uri", uri}, {"range", range}}}, {"message", message}});
      return;
    }
  }

  static bool reaches(const dsl::Module& from, const std::string& file,
                      std::set<const dsl::Module*>& seen) {
    if (!seen.insert(&from).second) return false;
    if (from.source.name() == file) return true;
    return std::ranges::any_of(from.imports, [&](const auto& import) {
      return import.second && reaches(*import.second, file, seen);
    });
  }

  /// Faults of an imported file are reported at the import, once for each import.
  void addImported(const Diagnostic& d) {
    if (d.severity != dsl::Severity::Error) return;
    for (const dsl::Symbol& s : analysis_.symbols.symbols()) {
      std::set<const dsl::Module*> seen;
      const bool isFrom = s.kind == dsl::SymbolKind::Import && s.home == &analysis_.main() &&
                          s.target && reaches(*s.target, d.place.file, seen);
      if (!isFrom) continue;
      const Json range = map_.range(s.whole);
      if (std::ranges::any_of(imported_, [&](const Json& j) { return j["range"] == range; }))
        return;
      Json related = Json::array();
      addRelated(related, d.place, d.message);
      imported_.push_back({{"range", range},
                           {"severity", kError},
                           {"code", dsl::fullIdOf(d.code)},
                           {"source", "af2"},
                           {"message", "the imported file has errors: " + d.place.file + ":" +
                                           std::to_string(d.place.line) + ": " + d.message},
                           {"relatedInformation", std::move(related)}});
      return;
    }
  }

  const Session& session_;
  const Document& document_;
  const Analysis& analysis_;
  TextMap map_;
  Json list_ = Json::array();
  std::vector<Json> imported_;
};

/// Whether two findings are the same; the later one, from the checks, may contain more.
bool isSame(const Diagnostic& p, const Diagnostic& q) {
  return p.code == q.code && p.place.file == q.place.file && p.place.line == q.place.line &&
         p.place.column == q.place.column;
}

void publish(const Session& session, const Document& document, const Analysis& analysis,
             const std::vector<Diagnostic>& more) {
  Writer writer(session, document, analysis);
  const auto holds = [](const std::vector<Diagnostic>& list, const Diagnostic& d) {
    return std::ranges::any_of(list, [&](const Diagnostic& other) { return isSame(d, other); });
  };
  for (const Diagnostic& d : analysis.loaded.diagnostics)
    if (!holds(more, d) && !holds(document.withdrawn, d)) writer.add(d);
  for (const Diagnostic& d : more) writer.add(d);
  Json list = writer.take();
  for (const Json& failure : document.testFailures) list.push_back(failure);
  Json params{{"uri", document.uri}, {"diagnostics", std::move(list)}};
  if (document.version) params["version"] = *document.version;
  session.notify("textDocument/publishDiagnostics", std::move(params));
}

/// Findings of the text about mirror images that would never be chosen.
std::vector<Diagnostic> idleMirrors(const Analysis& analysis) {
  std::vector<Diagnostic> kept = analysis.loaded.diagnostics, idle;
  if (analysis.loaded.rules) dsl::dropIdleMirrors(analysis.loaded, kept);
  for (const Diagnostic& d : analysis.loaded.diagnostics)
    if (std::ranges::find(kept, d) == kept.end()) idle.push_back(d);
  return idle;
}

/// Findings about mirrored rules, each with a counter-example.
std::vector<Diagnostic> mirrorFindings(const Analysis& analysis) {
  dsl::LoadedRules sound = analysis.loaded;
  sound.rules = analysis.soundRules();
  std::vector<Diagnostic> found;
  for (const Diagnostic& d : analysis.loaded.diagnostics) {
    const auto example = dsl::mirrorExampleOf(sound, d);
    if (!example) continue;
    found.push_back(d);
    found.back().notes.push_back(dsl::testNote(example->test));
  }
  return found;
}

std::vector<Diagnostic> slowChecks(const Analysis& analysis, const std::atomic<bool>& isCancelled) {
  dsl::SamplingOptions options;
  options.isCancelled = [&isCancelled] { return isCancelled.load(); };
  options.unknown = dsl::unknownRules(analysis.loaded);
  const RuleSet& rules = *analysis.soundRules();
  auto found = mirrorFindings(analysis);
  for (Diagnostic& d : dsl::diagnosticsOf(analysis.loaded, dsl::runSampledChecks(rules, options)))
    found.push_back(std::move(d));
  if (isCancelled) return found;
  if (!analysis.loaded.rules || !analysis.loaded.file->missing.empty()) {
    // The choice among rules, and its gaps, can be judged only if all rules are sound and known.
    std::erase_if(found, [](const Diagnostic& d) { return d.code == dsl::Code::NeverChosen; });
    return found;
  }
  for (Diagnostic& d : dsl::diagnosticsOf(analysis.loaded, dsl::measureCoverage(rules)))
    found.push_back(std::move(d));
  return found;
}

/// Starts the checks and drops running ones for the same document.
void startChecks(Session& session, const std::shared_ptr<Document>& document) {
  const auto analysis = document->analysis;
  if (!session.client.checks || !analysis->soundRules()) return;
  session.checks().start(
      {document->uri, session.client.checkDelay,
       [&session, document, analysis](const std::atomic<bool>& isCancelled) -> Continuation {
         auto withdrawn = idleMirrors(*analysis);
         auto found = slowChecks(*analysis, isCancelled);
         std::erase_if(found, [&](const Diagnostic& d) {
           return std::ranges::any_of(withdrawn,
                                      [&](const Diagnostic& other) { return isSame(d, other); });
         });
         return [&session, document, analysis, found = std::move(found),
                 withdrawn = std::move(withdrawn)] {
           const bool isStale =
               document->analysis != analysis || session.findOpen(document->uri) != document;
           if (isStale) return;
           document->checked = found;
           document->withdrawn = withdrawn;
           publish(session, *document, *analysis, found);
         };
       }});
}

}  // namespace

void sendDiagnostics(Session& session) {
  for (const auto& document : session.openDocuments()) {
    if (!document->isChanged) continue;
    document->isChanged = false;
    const auto analysis = session.analysis(*document);
    if (document->checking != analysis) {
      document->checking = analysis;
      document->checked.clear();
      document->withdrawn.clear();
      startChecks(session, document);
    }
    publish(session, *document, *analysis, document->checked);
  }
}

}  // namespace af2::lsp
