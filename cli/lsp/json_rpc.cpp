#include "cli/lsp/json_rpc.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <istream>
#include <ostream>
#include <string_view>

namespace af2::lsp {
namespace {

bool startsWithIgnoringCase(std::string_view text, std::string_view start) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  return text.size() >= start.size() && std::equal(start.begin(), start.end(), text.begin(), same);
}

std::optional<std::size_t> lengthIn(std::string_view header) {
  constexpr std::string_view kName = "Content-Length:";
  if (!startsWithIgnoringCase(header, kName)) return std::nullopt;
  header.remove_prefix(kName.size());
  while (!header.empty() && header.front() == ' ') header.remove_prefix(1);
  while (!header.empty() && header.back() == ' ') header.remove_suffix(1);
  std::size_t length = 0;
  const auto end = header.data() + header.size();
  const auto parsed = std::from_chars(header.data(), end, length);
  return parsed.ec == std::errc() && parsed.ptr == end ? std::optional(length) : std::nullopt;
}

/// A header is short; a longer text without a line break is not a header.
bool readLine(std::istream& in, std::string& line) {
  constexpr std::size_t kLongest = 4096;
  line.clear();
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n') {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return true;
    }
    if (line.size() < kLongest) line += static_cast<char>(c);
  }
  return false;
}

Incoming parse(const std::string& body) {
  Json message = Json::parse(body, nullptr, false);
  if (message.is_discarded()) return {{}, "the message is not JSON"};
  return {std::move(message), ""};
}

}  // namespace

Json makeResult(const Json& id, Json result) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
}

Json makeError(const Json& id, ErrorCode code, const std::string& message) {
  return {{"jsonrpc", "2.0"},
          {"id", id},
          {"error", {{"code", static_cast<int>(code)}, {"message", message}}}};
}

Json makeNotification(const std::string& method, Json params) {
  return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

std::optional<Incoming> readMessage(std::istream& in) {
  std::optional<std::size_t> length;
  bool hasHeader = false;
  std::string line;
  while (readLine(in, line)) {
    if (!line.empty()) {
      hasHeader = true;
      if (const auto given = lengthIn(line)) length = given;
      continue;
    }
    if (!hasHeader) continue;  // blank lines between messages are accepted
    if (!length) return Incoming{{}, "the header has no valid Content-Length"};
    if (*length > kLargestMessage) {
      in.ignore(static_cast<std::streamsize>(*length));
      return Incoming{{}, "the message is too large"};
    }
    std::string body(*length, '\0');
    in.read(body.data(), static_cast<std::streamsize>(*length));
    if (static_cast<std::size_t>(in.gcount()) < *length) return std::nullopt;
    return parse(body);
  }
  return std::nullopt;
}

void writeMessage(std::ostream& out, const Json& message) {
  const std::string body = message.dump(-1, ' ', false, Json::error_handler_t::replace);
  out << "Content-Length: " << body.size() << "\r\n\r\n" << body << std::flush;
}

}  // namespace af2::lsp
