#include "cli/playground/language.h"

#include <atomic>
#include <filesystem>

#include "cli/lsp/uri.h"

namespace af2::playground {

namespace {

const Json kCapabilities = Json::parse(R"({
  "textDocument": {"completion": {"completionItem": {"snippetSupport": true}},
                   "hover": {"contentFormat": ["markdown"]}}})");

}  // namespace

Language::Language(lsp::Surroundings surroundings, const std::string& path)
    : uri_(lsp::uriOf(path)),
      session_(
          std::move(surroundings), [this](const Json& message) { receive(message); }, checks_,
          commands_),
      server_(session_) {
  take({{"id", 0}, {"method", "initialize"}, {"params", {{"capabilities", kCapabilities}}}});
  take({{"method", "initialized"}, {"params", Json::object()}});
  take({{"method", "textDocument/didOpen"},
        {"params", {{"textDocument", {{"uri", uri_}, {"version", 0}, {"text", ""}}}}}});
}

void Language::take(const Json& message) { server_.take({message, ""}); }

void Language::receive(const Json& message) {
  if (!message.contains("method"))
    answer_ = message.value("result", Json());
  else if (message["method"] == "textDocument/publishDiagnostics" &&
           message["params"]["uri"] == uri_)
    published_ = message["params"]["diagnostics"];
}

void Language::show(const std::string& text) {
  const auto document = session_.findOpen(uri_);
  if (document->text != text)
    take({{"method", "textDocument/didChange"},
          {"params",
           {{"textDocument", {{"uri", uri_}}},
            {"contentChanges", Json::array({{{"text", text}}})}}}});
  else if (document->analysis && stampOf(*document->analysis) != stamp_)
    session_.forget("");
  server_.rest();
  stamp_ = stampOf(*session_.analysis(*document));
}

Json Language::diagnostics(const std::string& text) {
  const std::lock_guard lock(mutex_);
  show(text);
  return published_;
}

Json Language::allDiagnostics(const std::string& text, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  show(text);
  auto task = checks_.take();
  if (!task) return published_;
  const auto analysis = session_.findOpen(uri_)->analysis;
  lock.unlock();
  std::atomic<bool> isCancelled = false;
  const std::stop_callback onStop(stop, [&] { isCancelled = true; });
  const lsp::Continuation done = task->work(isCancelled);
  lock.lock();
  const bool isCurrent = session_.findOpen(uri_)->analysis == analysis;
  if (!isCurrent) return nullptr;
  if (!isCancelled)
    done();
  else if (checks_.isEmpty())
    checks_.start(std::move(*task));  // whoever asks about the same text next has them done again
  return published_;
}

Json Language::ask(const std::string& text, const std::string& method, const Json& position) {
  const std::lock_guard lock(mutex_);
  show(text);
  answer_ = nullptr;
  take({{"id", 1},
        {"method", method},
        {"params", {{"textDocument", {{"uri", uri_}}}, {"position", position}}}});
  return answer_;
}

std::shared_ptr<const lsp::Analysis> Language::analysis(const std::string& text) {
  const std::lock_guard lock(mutex_);
  show(text);
  return session_.analysis(*session_.findOpen(uri_));
}

std::string Language::stampOf(const lsp::Analysis& analysis) const {
  std::string stamp;
  for (std::size_t i = 1; i < analysis.files.size(); ++i) {  // [0] is the file itself
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(analysis.files[i], missing);
    stamp += missing ? "-" : std::to_string(time.time_since_epoch().count());
    stamp += ",";
  }
  return stamp;
}

std::string Language::stampOfImports() {
  const std::lock_guard lock(mutex_);
  const auto document = session_.findOpen(uri_);
  return document->analysis ? stampOf(*document->analysis) : stamp_;
}

}  // namespace af2::playground
