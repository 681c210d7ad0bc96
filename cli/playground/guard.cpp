#include "cli/playground/guard.h"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "engine/base/error.h"

namespace af2::playground {
namespace {

/// Takes the same time wherever the first difference is.
bool isSame(const std::string& p, const std::string& q) {
  if (p.size() != q.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    different |= static_cast<unsigned char>(p[i]) ^ static_cast<unsigned char>(q[i]);
  return different == 0;
}

}  // namespace

std::string newToken() {
  std::array<unsigned char, 16> bytes{};
  if (getentropy(bytes.data(), bytes.size()) != 0)
    throw InputError(fmt::format("the system gives no random numbers: {}", std::strerror(errno)));
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

/// A page of another name that resolves to this machine (DNS rebinding) sends its own name.
bool Guard::isOwnHost(const std::string& host) const {
  return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

std::optional<Refusal> Guard::refuse(const RequestHead& request) const {
  if (!isOwnHost(request.host)) return Refusal{403, "The Host header is not that of this server."};
  const std::string first = request.path.substr(0, token_.size() + 2);
  if (!isSame(first, "/" + token_ + "/"))
    return Refusal{403, "The address lacks the token that 'af2 playground' has printed."};
  if (request.method == "GET") return std::nullopt;
  if (request.method != "POST") return Refusal{405, "The method must be GET or POST."};
  if (request.origin != "http://" + request.host)
    return Refusal{403, "The request comes from another page."};
  if (!request.contentType.starts_with("text/plain"))
    return Refusal{415, "The content must be text/plain."};
  if (request.isEncoded) return Refusal{411, "The content must have a length and no encoding."};
  return std::nullopt;
}

}  // namespace af2::playground
