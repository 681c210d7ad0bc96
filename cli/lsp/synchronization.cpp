// Notifications of the editor about its files.
#include <array>
#include <optional>

#include "cli/lsp/server.h"
#include "cli/lsp/uri.h"

namespace af2::lsp {
namespace {

std::optional<int> versionIn(const Json& item) {
  const auto version = item.find("version");
  if (version == item.end() || !version->is_number_integer()) return std::nullopt;
  return version->get<int>();
}

void didOpen(Session& session, const Json& params) {
  const Json& item = params.at("textDocument");
  Document document;
  document.uri = item.at("uri").get<std::string>();
  document.text = item.at("text").get<std::string>();
  document.version = versionIn(item).value_or(0);
  session.open(std::move(document));
}

void didChange(Session& session, const Json& params) {
  const Json& item = params.at("textDocument");
  const auto document = session.findOpen(item.at("uri").get<std::string>());
  if (!document)
    throw RequestError(ErrorCode::InvalidParams,
                       "'" + item.at("uri").get<std::string>() + "' is not open");
  for (const Json& change : params.at("contentChanges"))
    document->apply(change, session.client.encoding);
  if (const auto version = versionIn(item)) document->version = version;
  session.checks().cancel(document->uri);
  session.forget(canonical(document->path));
}

void didClose(Session& session, const Json& params) {
  const auto uri = params.at("textDocument").at("uri").get<std::string>();
  session.close(uri);
  session.notify("textDocument/publishDiagnostics", {{"uri", uri}, {"diagnostics", Json::array()}});
}

void didSave(Session& session, const Json& params) {
  session.forget(canonical(pathOf(params.at("textDocument").at("uri").get<std::string>())));
}

void filesChanged(Session& session, const Json&) { session.forget(""); }

void settingsChanged(Session& session, const Json& params) {
  const Json& settings = params.at("settings");
  if (!settings.is_object()) return;
  applySettings(session.client, settings.contains("af2") ? settings["af2"] : settings);
}

void foldersChanged(Session& session, const Json& params) {
  const Json& event = params.at("event");
  auto& folders = session.client.folders;
  for (const Json& removed : event.at("removed"))
    std::erase(folders, std::filesystem::path(pathOf(removed.at("uri").get<std::string>())));
  for (const Json& added : event.at("added"))
    folders.emplace_back(pathOf(added.at("uri").get<std::string>()));
}

/// Requests that wait are cancelled in the queue; this cancels those that are being processed.
void cancelRequest(Session& session, const Json& params) {
  const Json& id = params.at("id");
  if (session.commands().cancel(id.dump()))
    session.fail(id, ErrorCode::RequestCancelled, "the request was cancelled");
}

constexpr std::array kNotifications{
    Notification{"textDocument/didOpen", didOpen},
    Notification{"textDocument/didChange", didChange},
    Notification{"textDocument/didClose", didClose},
    Notification{"textDocument/didSave", didSave},
    Notification{"workspace/didChangeWatchedFiles", filesChanged},
    Notification{"workspace/didChangeConfiguration", settingsChanged},
    Notification{"workspace/didChangeWorkspaceFolders", foldersChanged},
    Notification{"$/cancelRequest", cancelRequest},
};

}  // namespace

std::span<const Notification> documentNotifications() { return kNotifications; }

}  // namespace af2::lsp
