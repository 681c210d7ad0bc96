#include "cli/playground/assets.h"

#include <algorithm>
#include <iterator>

namespace af2::playground {
namespace {

struct PlaygroundPart {
  std::string_view name, text;

  /// Knows the size of the text: the compiler counts no characters of long ones.
  template <std::size_t size>
  constexpr PlaygroundPart(std::string_view its, const char (&bytes)[size])
      : name(its), text(bytes, size - 1) {}
};

constexpr PlaygroundPart kPlaygroundParts[] = {
#include "playground_parts.inc"
};

std::string typeOf(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  return "text/javascript; charset=utf-8";
}

}  // namespace

Asset findAsset(std::string_view name) {
  const auto part = std::ranges::find(kPlaygroundParts, name, &PlaygroundPart::name);
  if (part == std::end(kPlaygroundParts)) return {};
  return {part->text, typeOf(name)};
}

}  // namespace af2::playground
