#include "cli/lsp/workspace.h"

#include <algorithm>
#include <map>
#include <set>

#include "cli/lsp/uri.h"

namespace af2::lsp {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 500;

void addRuleFiles(const fs::path& folder, std::set<std::string>& files) {
  constexpr int kDeepest = 8;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (std::size_t seen = 0; !error && at != fs::end(at) && seen < 50'000; ++seen) {
    const std::string name = at->path().filename().string();
    const bool isHidden = name.starts_with('.') || name == "node_modules" || name == "build";
    std::error_code ignored;
    if (at->is_directory(ignored) && (isHidden || at.depth() >= kDeepest))
      at.disable_recursion_pending();
    if (at->path().extension() == ".af2" && files.size() < kMaxFiles)
      files.insert(canonical(at->path().string()));
    at.increment(error);
  }
}

/// Finds the same symbol in another analysis.
std::size_t findAgain(const dsl::SymbolIndex& index, const std::string& file,
                      const dsl::Symbol& wanted, std::map<const dsl::Module*, std::string>& paths) {
  for (std::size_t i = 0; i < index.symbols().size(); ++i) {
    const dsl::Symbol& s = index[i];
    if (s.kind != wanted.kind || s.definition != wanted.definition || s.name != wanted.name)
      continue;
    std::string& path = paths[s.home];
    if (path.empty()) path = canonical(s.home->source.name());
    if (path == file) return i;
  }
  return dsl::kNoSymbol;
}

class Collector {
 public:
  Collector(const Session& session, const Place& place, std::size_t symbol)
      : session_(session),
        symbol_(place.analysis->symbols[symbol]),
        file_(canonical(symbol_.home->source.name())) {}

  /// Adds the files that an analysis has read, each only once.
  void add(const Document& document, const Analysis& analysis) {
    std::map<const dsl::Module*, std::string> paths;
    const std::size_t again = findAgain(analysis.symbols, file_, symbol_, paths);
    if (again == dsl::kNoSymbol) return;
    for (const auto& module : analysis.loaded.file->modules) {
      if (!seen_.insert(canonical(module->source.name())).second) continue;
      FileOccurrences file;
      file.uri = session_.uriOfModule(document, analysis, *module);
      if (file.uri.empty()) continue;
      file.text = module->source.text();
      if (const auto open = session_.findOpen(file.uri)) file.version = open->version;
      for (const dsl::Occurrence& o : analysis.symbols.occurrencesIn(*module))
        if (o.symbol == again) file.occurrences.push_back(o);
      if (!file.occurrences.empty()) found_.push_back(std::move(file));
    }
  }

  std::vector<FileOccurrences> take() { return std::move(found_); }

 private:
  const Session& session_;
  const dsl::Symbol& symbol_;
  std::string file_;
  std::set<std::string> seen_;
  std::vector<FileOccurrences> found_;
};

bool canBeImported(const dsl::Symbol& symbol) {
  return symbol.isGlobal() && symbol.kind != dsl::SymbolKind::Import &&
         symbol.kind != dsl::SymbolKind::Test && symbol.kind != dsl::SymbolKind::Property;
}

}  // namespace

std::vector<std::string> ruleFilesOf(const Session& session) {
  std::set<std::string> files;
  for (const fs::path& folder : session.client.folders) addRuleFiles(folder, files);
  return {files.begin(), files.end()};
}

std::vector<FileOccurrences> occurrencesEverywhere(const Session& session, const Place& place,
                                                   std::size_t symbol) {
  Collector collector(session, place, symbol);
  const dsl::Symbol& wanted = place.analysis->symbols[symbol];
  collector.add(*place.document, *place.analysis);
  // Tests in importing files may name the vertices of a rule.
  const bool isLocal = !canBeImported(wanted) && wanted.kind != dsl::SymbolKind::Vertex;
  if (isLocal) return collector.take();
  for (const auto& document : session.openDocuments())
    collector.add(*document, *session.analysis(*document));
  // The part of the name that all uses contain: searching for it avoids analysing most files.
  const std::string written = wanted.name.substr(0, wanted.name.find_first_of("{\"\\"));
  for (const std::string& path : ruleFilesOf(session)) {
    if (session.findOpenFile(path)) continue;
    try {
      const auto document = session.document(uriOf(path));
      if (document->text.find(written) == std::string::npos) continue;
      collector.add(*document, *session.analysis(*document));
    } catch (const RequestError&) {
      continue;  // the file has gone or cannot be read
    }
  }
  return collector.take();
}

}  // namespace af2::lsp
