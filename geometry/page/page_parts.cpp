#include "geometry/page/page_parts.h"

#include <algorithm>
#include <iterator>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

struct PagePart {
  std::string_view name, text;

  /// Knows the size of the text: the compiler counts no characters of long ones.
  template <std::size_t size>
  constexpr PagePart(std::string_view its, const char (&bytes)[size])
      : name(its), text(bytes, size - 1) {}
};

constexpr PagePart kPageParts[] = {
#include "page_parts.inc"
};

}  // namespace

std::string_view pagePart(std::string_view name) {
  const auto part = std::ranges::find(kPageParts, name, &PagePart::name);
  AF2_CHECK(part != std::end(kPageParts), "the page uses only parts that it has");
  return part->text;
}

}  // namespace af2::geometry
