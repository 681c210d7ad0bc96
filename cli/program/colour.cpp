#include "cli/program/colour.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace af2::cli {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

dsl::Colour colourOf(std::FILE* stream) {
  const std::string_view wanted = environment("AF2_COLOR");
  if (wanted == "always") return dsl::Colour::Terminal;
  const bool isForbidden = wanted == "never" || !environment("NO_COLOR").empty() ||
                           environment("TERM") == "dumb" || environment("TERM").empty();
  return !isForbidden && ::isatty(::fileno(stream)) != 0 ? dsl::Colour::Terminal
                                                         : dsl::Colour::None;
}

}  // namespace af2::cli
