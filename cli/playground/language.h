// The language server within the program: what it says about the text of one file.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "cli/lsp/server.h"

namespace af2::playground {

using lsp::Json;

/// Every question comes with the text that it is about, so that several pages can ask about texts
/// of their own. Its functions may be called from any thread.
class Language {
 public:
  Language(lsp::Surroundings surroundings, const std::string& path);

  /// The diagnostics of the quick checks, in the form of the language server protocol.
  Json diagnostics(const std::string& text);
  /// Those of all checks; of the quick checks if it is stopped; null if another text was asked
  /// about meanwhile.
  Json allDiagnostics(const std::string& text, const std::stop_token& stop);
  /// The answer to a request such as "textDocument/completion" about a position; null if there is
  /// none.
  Json ask(const std::string& text, const std::string& method, const Json& position);
  std::shared_ptr<const lsp::Analysis> analysis(const std::string& text);
  /// What imported files say may have changed: changes if one of them does.
  std::string stampOfImports();

 private:
  /// Keeps the checks until somebody has time for them.
  class KeptChecks : public lsp::Background {
   public:
    void start(lsp::Task task) override { task_ = std::move(task); }
    bool cancel(const std::string&) override { return std::exchange(task_, {}).has_value(); }
    std::optional<lsp::Task> take() { return std::exchange(task_, {}); }
    bool isEmpty() const { return !task_; }

   private:
    std::optional<lsp::Task> task_;
  };

  void take(const Json& message);
  void receive(const Json& message);
  /// Makes this the text of the document, and has its quick checks done.
  void show(const std::string& text);
  std::string stampOf(const lsp::Analysis& analysis) const;

  std::mutex mutex_;
  std::string uri_;
  KeptChecks checks_, commands_;
  lsp::Session session_;
  lsp::Server server_;
  Json published_ = Json::array();
  Json answer_;
  std::string stamp_;
};

}  // namespace af2::playground
