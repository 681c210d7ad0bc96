#include "cli/lsp/uri.h"

#include <cctype>
#include <charconv>
#include <filesystem>

namespace af2::lsp {
namespace {

constexpr std::string_view kScheme = "file://";

std::string decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    const bool isEscape =
        text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, value, 16).ptr ==
            text.data() + i + 3;
    result += isEscape ? static_cast<char>(value) : text[i];
    if (isEscape) i += 2;
  }
  return result;
}

bool isPlain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("/-._~").find(c) != std::string_view::npos;
}

}  // namespace

std::string pathOf(std::string_view uri) {
  if (!uri.starts_with(kScheme)) return std::string(uri);
  std::string_view rest = uri.substr(kScheme.size());
  rest.remove_prefix(std::min(rest.find('/'), rest.size()));  // the host, almost always empty
  return decoded(rest);
}

std::string uriOf(const std::string& path) {
  std::error_code ignored;
  const std::string absolute =
      std::filesystem::absolute(path, ignored).lexically_normal().generic_string();
  std::string uri(kScheme);
  constexpr const char* kDigits = "0123456789ABCDEF";
  for (const char c : absolute) {
    if (isPlain(c)) {
      uri += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    uri += '%';
    uri += kDigits[byte >> 4];
    uri += kDigits[byte & 15];
  }
  return uri;
}

std::string canonical(const std::string& path) {
  std::error_code error;
  const auto result = std::filesystem::weakly_canonical(path, error);
  return error ? path : result.string();
}

}  // namespace af2::lsp
