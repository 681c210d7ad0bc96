// The local web server of the playground.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "cli/lsp/session.h"

namespace af2::playground {

struct ServerOptions {
  std::filesystem::path file;
  bool watches = false;  ///< the page shows the file on disk and has no editor
  int port = 0;          ///< 0: a free one
  lsp::Surroundings surroundings;
};

/// Answers only on the loopback interface, only to requests that carry its token, and touches no
/// file but the given one; rule texts can import what they can import for `af2 mesh`.
class Server {
 public:
  /// Throws InputError if the file is unusable or the port is taken.
  explicit Server(ServerOptions options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Of the page, with the token.
  const std::string& address() const;
  /// Answers requests until end() is called.
  void serve();
  /// May be called from any thread, also before serve().
  void end();

 private:
  class Connections;
  std::unique_ptr<Connections> connections_;
};

}  // namespace af2::playground
