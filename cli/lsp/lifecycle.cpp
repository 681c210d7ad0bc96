// initialize: the capabilities of the editor and of the server.
#include <algorithm>
#include <array>

#include "cli/lsp/server.h"
#include "cli/lsp/uri.h"

namespace af2::lsp {
namespace {

const Json* find(const Json& json, std::initializer_list<const char*> path) {
  const Json* at = &json;
  for (const char* key : path) {
    if (!at->is_object() || !at->contains(key)) return nullptr;
    at = &(*at)[key];
  }
  return at;
}

bool isTrue(const Json& json, std::initializer_list<const char*> path) {
  const Json* value = find(json, path);
  return value && value->is_boolean() && value->get<bool>();
}

bool holds(const Json* list, const char* word) {
  return list && list->is_array() && std::ranges::find(*list, Json(word)) != list->end();
}

/// Terminal editors accept Markdown, but show a picture as the text of its address.
bool showsMarkdownAsText(const Json& params) {
  const Json* name = find(params, {"clientInfo", "name"});
  if (!name || !name->is_string()) return false;
  constexpr std::array kTextOnly{"Neovim", "vim", "helix", "kak", "Emacs", "eglot", "Kakoune"};
  const auto& text = name->get_ref<const std::string&>();
  return std::ranges::any_of(
      kTextOnly, [&](const char* word) { return text.find(word) != std::string::npos; });
}

void readCapabilities(Client& client, const Json& params) {
  const Json* found = find(params, {"capabilities"});
  const Json capabilities = found ? *found : Json::object();
  if (holds(find(capabilities, {"general", "positionEncodings"}), "utf-8"))
    client.encoding = Encoding::Utf8;
  const Json* hover = find(capabilities, {"textDocument", "hover", "contentFormat"});
  client.readsMarkdown = !hover || holds(hover, "markdown");
  client.showsPictures = client.readsMarkdown && !showsMarkdownAsText(params);
  client.takesSnippets =
      isTrue(capabilities, {"textDocument", "completion", "completionItem", "snippetSupport"});
  client.nestsSymbols =
      isTrue(capabilities, {"textDocument", "documentSymbol", "hierarchicalDocumentSymbolSupport"});
  client.showsFiles = isTrue(capabilities, {"window", "showDocument", "support"});
  client.refreshesLenses = isTrue(capabilities, {"workspace", "codeLens", "refreshSupport"});
  client.watchesFiles =
      isTrue(capabilities, {"workspace", "didChangeWatchedFiles", "dynamicRegistration"});
}

void readFolders(Client& client, const Json& params) {
  const auto add = [&](const Json& uri) {
    if (uri.is_string()) client.folders.emplace_back(pathOf(uri.get<std::string>()));
  };
  const Json* folders = find(params, {"workspaceFolders"});
  if (folders && folders->is_array()) {
    for (const Json& folder : *folders)
      if (const Json* uri = find(folder, {"uri"})) add(*uri);
  } else if (const Json* root = find(params, {"rootUri"})) {
    add(*root);
  }
}

Json capabilitiesOf(const Client& client) {
  return {
      {"positionEncoding", client.encoding == Encoding::Utf8 ? "utf-8" : "utf-16"},
      {"textDocumentSync",
       {{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}}},
      {"hoverProvider", true},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"documentSymbolProvider", true},
      {"workspaceSymbolProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"completionProvider", {{"triggerCharacters", {".", "\"", "/"}}}},
      {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
      {"documentFormattingProvider", true},
      {"documentRangeFormattingProvider", true},
      {"foldingRangeProvider", true},
      {"documentLinkProvider", {{"resolveProvider", false}}},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
      {"codeLensProvider", {{"resolveProvider", false}}},
      {"inlayHintProvider", true},
      {"executeCommandProvider", {{"commands", {"af2.draw", "af2.test"}}}},
      {"workspace", {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}}}};
}

}  // namespace

void applySettings(Client& client, const Json& settings) {
  if (!settings.is_object()) return;
  const auto flag = [&](const char* name, bool& value) {
    if (settings.contains(name) && settings[name].is_boolean()) value = settings[name].get<bool>();
  };
  flag("checks", client.checks);
  flag("hoverPictures", client.showsPictures);
  flag("returnPictures", client.takesPictures);
  if (settings.contains("checkDelay") && settings["checkDelay"].is_number_unsigned())
    client.checkDelay =
        std::chrono::milliseconds(std::min(settings["checkDelay"].get<unsigned>(), 60'000U));
}

Json initialize(Session& session, const Json& params) {
  readCapabilities(session.client, params);
  readFolders(session.client, params);
  if (const Json* settings = find(params, {"initializationOptions"}))
    applySettings(session.client, *settings);
  return {{"capabilities", capabilitiesOf(session.client)},
          {"serverInfo", {{"name", "af2"}, {"version", session.surroundings().version}}}};
}

void afterInitialized(Session& session) {
  if (!session.client.watchesFiles) return;
  const Json watcher{{"globPattern", "**/*.af2"}};
  session.ask("client/registerCapability",
              {{"registrations",
                Json::array({{{"id", "af2-files"},
                              {"method", "workspace/didChangeWatchedFiles"},
                              {"registerOptions", {{"watchers", Json::array({watcher})}}}}})}});
}

}  // namespace af2::lsp
