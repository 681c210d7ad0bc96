#include "cli/lsp/session.h"

#include <algorithm>

#include "cli/lsp/uri.h"
#include "dsl/compile/library.h"

namespace af2::lsp {

Session::Session(Surroundings surroundings, Send send, Background& checks, Background& commands)
    : surroundings_(std::move(surroundings)),
      send_(std::move(send)),
      checks_(checks),
      commands_(commands) {}

void Session::open(Document document) {
  document.path = pathOf(document.uri);
  document.isChanged = true;
  const std::string path = canonical(document.path);
  const std::string uri = document.uri;
  uriByPath_[path] = uri;
  documents_[uri] = std::make_shared<Document>(std::move(document));
  forget(path);
}

void Session::close(const std::string& uri) {
  const auto found = documents_.find(uri);
  if (found == documents_.end()) return;
  const std::string path = canonical(found->second->path);
  documents_.erase(found);
  uriByPath_.erase(path);
  checks_.cancel(uri);
  forget(path);
}

std::shared_ptr<Document> Session::findOpen(const std::string& uri) const {
  const auto found = documents_.find(uri);
  return found == documents_.end() ? nullptr : found->second;
}

std::shared_ptr<Document> Session::findOpenFile(const std::string& path) const {
  const auto uri = uriByPath_.find(canonical(path));
  return uri == uriByPath_.end() ? nullptr : findOpen(uri->second);
}

std::shared_ptr<Document> Session::document(const std::string& uri) const {
  if (auto open = findOpen(uri)) return open;
  auto read = std::make_shared<Document>();
  read->uri = uri;
  read->path = pathOf(uri);
  std::string fault;
  auto text = dsl::readFile(read->path, fault);
  if (!text)
    throw RequestError(ErrorCode::InvalidParams,
                       "'" + uri + "' is not open, and cannot be read: " + fault);
  read->text = std::move(*text);
  return read;
}

std::shared_ptr<Document> Session::documentOf(const Json& params) const {
  return document(params.at("textDocument").at("uri").get<std::string>());
}

std::vector<std::shared_ptr<Document>> Session::openDocuments() const {
  std::vector<std::shared_ptr<Document>> all;
  for (const auto& [uri, document] : documents_) all.push_back(document);
  return all;
}

std::optional<std::string> Session::unsavedText(const std::filesystem::path& path) const {
  const auto open = findOpenFile(path.string());
  return open ? std::optional(open->text) : std::nullopt;
}

std::shared_ptr<const Analysis> Session::analysis(Document& document) const {
  if (document.analysis) return document.analysis;
  dsl::LoadOptions options;
  options.searchPaths = surroundings_.rules;
  options.needsRuleSet = false;  // the file may be a library
  options.registry = &surroundings_.registry;
  options.externs = dsl::Externs::Declared;
  options.unsaved = [this](const std::filesystem::path& path) { return unsavedText(path); };
  return document.analysis = std::make_shared<const Analysis>(
             dsl::loadRulesFromText(document.path, document.text, options));
}

void Session::forget(const std::string& canonicalPath) {
  for (const auto& [uri, document] : documents_) {
    const auto& known = document->analysis;
    if (!known) continue;
    const bool depends = canonicalPath.empty() || known->misses ||
                         std::ranges::find(known->files, canonicalPath) != known->files.end();
    if (!depends) continue;
    document->analysis.reset();
    document->isChanged = true;
  }
}

Place Session::placeOf(const Json& params) const {
  auto document = documentOf(params);
  Place place{document, analysis(*document), 0};
  place.offset = map(document->text).offset(params.at("position"));
  return place;
}

std::string Session::uriOfModule(const Document& document, const Analysis& analysis,
                                 const dsl::Module& module) const {
  if (&module == &analysis.main()) return document.uri;
  const std::string& name = module.source.name();
  if (const auto open = findOpenFile(name)) return open->uri;
  std::error_code ignored;
  return std::filesystem::exists(name, ignored) ? uriOf(name) : std::string();
}

void Session::notify(const std::string& method, Json params) const {
  send_(makeNotification(method, std::move(params)));
}

void Session::ask(const std::string& method, Json params) {
  Json request = makeNotification(method, std::move(params));
  request["id"] = "af2-" + std::to_string(nextRequest_++);
  send_(request);
}

void Session::show(int type, const std::string& message) const {
  notify("window/showMessage", {{"type", type}, {"message", message}});
}

}  // namespace af2::lsp
