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

/// Becomes the error that answers a request.
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

/// What came in: a message, or what is wrong with it.
struct Incoming {
  Json message;
  std::string fault;  ///< not empty: the frame or its JSON could not be read
};

/// Larger messages are passed over and told as a fault.
inline constexpr std::size_t kLargestMessage = std::size_t{64} << 20;

/// The next message; nothing at the end of the stream. After a fault reading goes on with the next
/// frame.
std::optional<Incoming> readMessage(std::istream& in);

/// Writes one frame and flushes. Bytes that are not UTF-8 are replaced.
void writeMessage(std::ostream& out, const Json& message);

}  // namespace af2::lsp
