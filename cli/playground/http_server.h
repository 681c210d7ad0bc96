// HTTP on the loopback interface, as a library that is loaded when the playground starts, so that
// other runs of the program need not link the libraries for it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/playground/guard.h"
#include "cli/playground/parameters.h"

namespace af2::playground {

struct HttpReply {
  int status = 200;
  std::string body, type;
};

/// What decides and answers. Its functions are called from several threads.
class HttpHandler {
 public:
  virtual ~HttpHandler() = default;
  /// Called before the body is read. A reply ends the request.
  virtual std::optional<HttpReply> refuse(const RequestHead& request) const = 0;
  /// Throws nothing.
  virtual HttpReply answer(const RequestHead& request, const Parameters& parameters,
                           const std::string& body) = 0;
  /// The reply to a request that cannot be read, with this status.
  virtual HttpReply complain(int status) const = 0;
};

struct HttpOptions {
  std::vector<std::pair<std::string, std::string>> headers;  ///< of each reply
  std::size_t mostBytes = 0;                                 ///< that a body may have
};

class HttpServer {
 public:
  virtual ~HttpServer() = default;
  /// The port of 127.0.0.1, a free one for 0; none if it cannot be had.
  virtual std::optional<int> bind(int port) = 0;
  /// Answers requests until end() is called.
  virtual void listen() = 0;
  /// Has no effect before listen() runs.
  virtual void end() = 0;
  virtual bool isRunning() const = 0;
};

/// What the library offers. Both sides have been compiled from the same sources, as far as can be
/// told.
struct HttpModule {
  const char* version;
  std::unique_ptr<HttpServer> (*make)(HttpHandler& handler, const HttpOptions& options);
};

/// The name of the library, and of its function `const HttpModule* ()`.
inline constexpr const char* kHttpLibrary = "af2-http.so";
inline constexpr const char* kHttpModuleEntry = "af2HttpModule";

/// The handler must outlive the result. Throws InputError if the library is not there.
std::unique_ptr<HttpServer> makeHttpServer(HttpHandler& handler, const HttpOptions& options);

}  // namespace af2::playground
