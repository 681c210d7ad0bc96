// Messages of the language server protocol: JSON-RPC 2.0 in frames with a Content-Length.
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

namespace af2::lsp {

using Json = nlohmann::json;

enum class ErrorCode {
  ParseError = -32700,
  InvalidRequest = -32600,
  MethodNotFound = -32601,
  InvalidParams = -32602,
  InternalError = -32603,
  ServerNotInitialized = -32002,
  RequestFailed = -32803,
  RequestCancelled = -32800,
};

/// Thrown to answer a request with an error.
class RequestError : public std::runtime_error {
 public:
  RequestError(ErrorCode code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

Json makeResult(const Json& id, Json result);
Json makeError(const Json& id, ErrorCode code, const std::string& message);
Json makeNotification(const std::string& method, Json params);

/// An incoming message, or why it could not be read.
struct Incoming {
  Json message;
  std::string fault;  ///< not empty: the frame or its JSON could not be read
};

/// Larger messages are skipped and reported as a fault.
inline constexpr std::size_t kLargestMessage = std::size_t{64} << 20;

/// The next message; no value at the end of the stream. After a fault, reading continues with the
/// next frame.
std::optional<Incoming> readMessage(std::istream& in);

/// Writes one frame and flushes. Bytes that are not UTF-8 are replaced.
void writeMessage(std::ostream& out, const Json& message);

}  // namespace af2::lsp
