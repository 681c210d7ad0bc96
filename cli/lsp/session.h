// One conversation with an editor: its files, its capabilities, and how to send messages to it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/lsp/background.h"
#include "cli/lsp/document.h"
#include "cli/lsp/json_rpc.h"
#include "dsl/program/registry.h"

namespace af2::lsp {

/// The capabilities of the editor and the settings of its user.
struct Client {
  Encoding encoding = Encoding::Utf16;
  bool readsMarkdown = true, showsPictures = true;
  bool takesSnippets = false, showsFiles = false, takesTitledActions = true;
  bool nestsSymbols = false, refreshesLenses = false, watchesFiles = false;
  std::vector<std::filesystem::path> folders;  ///< folders of the workspace

  bool checks = true;  ///< run slow checks while the user pauses
  std::chrono::milliseconds checkDelay{400};
  bool takesPictures = false;  ///< af2.draw returns the picture and does not open it
};

/// Where rule files are, and the name and version of the program.
struct Surroundings {
  std::string version;
  std::vector<std::filesystem::path> rules;  ///< where imports are searched
  std::filesystem::path drawings;            ///< folder for pictures that an editor is to open
  dsl::Registry registry = {};               ///< what plugins register
};

/// The place in a document that a request refers to.
struct Place {
  std::shared_ptr<const Document> document;
  std::shared_ptr<const Analysis> analysis;
  std::uint32_t offset = 0;
};

class Session {
 public:
  using Send = std::function<void(const Json&)>;
  Session(Surroundings surroundings, Send send, Background& checks, Background& commands);

  Client client;
  const Surroundings& surroundings() const { return surroundings_; }
  Background& checks() { return checks_; }
  Background& commands() { return commands_; }

  // ---- documents ------------------------------------------------------------------------------
  void open(Document document);
  void close(const std::string& uri);
  /// Null if it is not open.
  std::shared_ptr<Document> findOpen(const std::string& uri) const;
  std::shared_ptr<Document> findOpenFile(const std::string& path) const;
  /// An open document, or one read from the disk. Throws RequestError if there is none.
  std::shared_ptr<Document> document(const std::string& uri) const;
  std::shared_ptr<Document> documentOf(const Json& params) const;
  std::vector<std::shared_ptr<Document>> openDocuments() const;

  std::shared_ptr<const Analysis> analysis(Document& document) const;
  /// Analyses everything that depends on a file again; an empty path stands for all files.
  void forget(const std::string& canonicalPath);

  Place placeOf(const Json& params) const;

  // ---- places ---------------------------------------------------------------------------------
  TextMap map(std::string_view text) const { return TextMap(text, client.encoding); }
  /// The URI of a file that an analysis has read: the editor's URI if the file is open. Empty for
  /// files that are built into AF2.
  std::string uriOfModule(const Document& document, const Analysis& analysis,
                          const dsl::Module& module) const;

  // ---- messages -------------------------------------------------------------------------------
  void notify(const std::string& method, Json params) const;
  /// Sends a request whose answer is ignored.
  void ask(const std::string& method, Json params);
  void respond(const Json& id, Json result) const { send_(makeResult(id, std::move(result))); }
  void fail(const Json& id, ErrorCode code, const std::string& message) const {
    send_(makeError(id, code, message));
  }
  /// Shows a line to the user: 1 error, 2 warning, 3 information.
  void show(int type, const std::string& message) const;

 private:
  std::optional<std::string> unsavedText(const std::filesystem::path& path) const;

  Surroundings surroundings_;
  Send send_;
  Background& checks_;
  Background& commands_;
  std::map<std::string, std::shared_ptr<Document>> documents_;  ///< by URI
  std::map<std::string, std::string> uriByPath_;                ///< of open documents
  int nextRequest_ = 1;
};

}  // namespace af2::lsp
