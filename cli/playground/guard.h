// Which requests the server answers: those of its own page in a browser on this machine.
#pragma once

#include <optional>
#include <string>

namespace af2::playground {

/// What decides about a request.
struct RequestHead {
  std::string method, path, host, origin, contentType;
  bool isEncoded = false;  ///< its body is compressed or comes in pieces, so that its length is not
                           ///< known before it is read
};

struct Refusal {
  int status = 403;
  std::string reason;
};

/// The secret part of the address. Pages of other origins can send requests to this machine, but
/// they do not know it.
std::string newToken();

class Guard {
 public:
  Guard(std::string token, int port) : token_(std::move(token)), port_(port) {}

  /// No value if the request may be answered.
  std::optional<Refusal> refuse(const RequestHead& request) const;

 private:
  bool isOwnHost(const std::string& host) const;

  std::string token_;
  int port_;
};

}  // namespace af2::playground
