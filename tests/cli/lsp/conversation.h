// An editor for tests: talks to the server without a process between.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/lsp/server.h"
#include "cli/lsp/uri.h"
#include "tests/support/test_folder.h"

namespace af2::lsp {

/// Keeps tasks until the test says that their time has come.
class PatientBackground : public Background {
 public:
  void start(Task task) override {
    cancel(task.key);
    tasks.push_back(std::move(task));
  }
  bool cancel(const std::string& key) override {
    return std::erase_if(tasks, [&](const Task& t) { return t.key == key; }) > 0;
  }
  /// Runs all that waits; what they found arrives.
  void run() {
    const std::atomic<bool> isCancelled = false;
    for (const Task& task : std::exchange(tasks, {})) task.work(isCancelled)();
  }
  std::vector<Task> tasks;
};

/// A text in which `|` marks a place.
struct Marked {
  explicit Marked(const std::string& marked)
      : offset(static_cast<std::uint32_t>(marked.find('|'))), text(marked) {
    text.erase(offset, 1);
  }
  std::uint32_t offset;
  std::string text;
};

class Conversation {
 public:
  explicit Conversation(const char* capabilities = "{}", Json options = Json::object())
      : session(
            {"test", {AF2_SOURCE_DIR "/rules"}, std::filesystem::temp_directory_path()},
            [this](const Json& m) { sent.push_back(m); }, checks, commands),
        server(session) {
    request("initialize", {{"capabilities", Json::parse(capabilities)},
                           {"initializationOptions", std::move(options)}});
    notify("initialized", Json::object());
  }

  void notify(const std::string& method, const Json& params) {
    server.take({makeNotification(method, params), ""});
  }

  /// The answer: its result, or its error.
  Json ask(const std::string& method, const Json& params) {
    Json message = makeNotification(method, params);
    message["id"] = ++id_;
    server.take({message, ""});
    commands.run();
    for (const Json& m : sent)
      if (m.contains("id") && m["id"] == id_ && !m.contains("method")) return m;
    return nullptr;
  }
  Json request(const std::string& method, const Json& params) {
    const Json answer = ask(method, params);
    return answer.is_object() && answer.contains("result") ? answer["result"] : Json("no result");
  }
  std::string fault(const std::string& method, const Json& params) {
    const Json answer = ask(method, params);
    return answer.contains("error") ? answer["error"]["message"].get<std::string>() : "no error";
  }

  void open(const std::string& text, const std::string& uri = kUri) {
    notify(
        "textDocument/didOpen",
        {{"textDocument", {{"uri", uri}, {"languageId", "af2"}, {"version", 1}, {"text", text}}}});
  }
  void change(const Json& changes, int version = 2) {
    notify("textDocument/didChange",
           {{"textDocument", {{"uri", kUri}, {"version", version}}}, {"contentChanges", changes}});
  }
  std::string text(const std::string& uri = kUri) const { return session.findOpen(uri)->text; }

  /// Opens the text and asks something about the marked place.
  Json requestAt(const std::string& method, const std::string& marked, Json more = Json::object()) {
    return request(method, paramsAt(marked, std::move(more)));
  }
  Json paramsAt(const std::string& marked, Json more = Json::object()) {
    const Marked m(marked);
    open(m.text);
    more["textDocument"] = {{"uri", kUri}};
    more["position"] = session.map(m.text).position(m.offset);
    return more;
  }
  static Json paramsOf(const std::string& uri = kUri) { return {{"textDocument", {{"uri", uri}}}}; }

  /// The last diagnostics of a document.
  Json diagnostics(const std::string& uri = kUri) {
    server.rest();
    Json last = nullptr;
    for (const Json& m : sent)
      if (m.contains("method") && m["method"] == "textDocument/publishDiagnostics" &&
          m["params"]["uri"] == uri)
        last = m["params"];
    return last.is_null() ? last : last["diagnostics"];
  }
  std::vector<std::string> codes() {
    std::vector<std::string> list;
    for (const Json& d : diagnostics()) list.push_back(d.value("code", "?"));
    return list;
  }

  /// The text with edits of a WorkspaceEdit or a list of edits applied.
  std::string edited(const Json& edits, const std::string& uri = kUri) const {
    Json list = edits.is_array() ? edits : edits.at("changes").at(uri);
    std::string result = text(uri);
    const TextMap map(result, session.client.encoding);
    std::vector<std::pair<dsl::Span, std::string>> spans;
    for (const Json& e : list)
      spans.emplace_back(map.span(e["range"]), e["newText"].get<std::string>());
    std::ranges::stable_sort(spans, {}, [](const auto& s) { return s.first.begin; });
    for (auto s = spans.rbegin(); s != spans.rend(); ++s)
      result.replace(s->first.begin, s->first.end - s->first.begin, s->second);
    return result;
  }

  static constexpr const char* kUri = "file:///tmp/af2-lsp-test/rules.af2";
  PatientBackground checks, commands;
  std::vector<Json> sent;
  Session session;
  Server server;

 private:
  int id_ = 0;
};

/// The addresses of the files of a test.
class Folder {
 public:
  std::string write(const std::string& name, const std::string& text) const {
    return uriOf(folder_.write(name, text).string());
  }
  const std::filesystem::path& path() const { return folder_.path(); }
  std::string uri(const std::string& name) const { return uriOf((folder_ / name).string()); }

 private:
  testing::TestFolder folder_;
};

/// Labels, titles and so on of a list of objects.
inline std::vector<std::string> valuesOf(const Json& list, const char* key) {
  std::vector<std::string> values;
  for (const Json& item : list) values.push_back(item.at(key).get<std::string>());
  return values;
}

inline bool holds(const std::vector<std::string>& list, const std::string& value) {
  return std::ranges::find(list, value) != list.end();
}

}  // namespace af2::lsp
