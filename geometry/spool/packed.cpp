#include "geometry/spool/packed.h"

#include <bit>
#include <map>

namespace af2::geometry {
namespace {

constexpr std::uint64_t kMore = 0x80;  // a byte follows with the next seven bits

void put(Bytes& bytes, std::uint64_t value) {
  for (; value >= kMore; value >>= 7) bytes.push_back(static_cast<std::uint8_t>(value | kMore));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

std::uint64_t take(const std::uint8_t*& at) {
  std::uint64_t value = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint64_t byte = *at++;
    value |= (byte & (kMore - 1)) << shift;
    if (byte < kMore) return value;
  }
}

/// Small numbers for small differences of either sign.
std::uint64_t folded(std::uint32_t from, std::uint32_t to) {
  return to >= from ? 2 * std::uint64_t{to - from} : 2 * std::uint64_t{from - to} - 1;
}

std::uint32_t unfolded(std::uint32_t from, std::uint64_t value) {
  const auto difference = static_cast<std::uint32_t>((value + 1) / 2);
  return value % 2 ? from - difference : from + difference;
}

static_assert(sizeof(ElementOrigin) == 4, "origins are compared by their bytes");

}  // namespace

Bytes packed(std::span<const Element> elements) {
  Bytes bytes;
  bytes.reserve(6 * elements.size());
  std::uint32_t before = 0;
  for (const Element& element : elements) {
    const std::uint32_t first = element.corners[0].value;
    put(bytes, 2 * folded(before, first) + element.isQuad());
    for (const VertexId v : element.vertices().subspan(1)) put(bytes, folded(first, v.value));
    before = first;
  }
  bytes.shrink_to_fit();
  return bytes;
}

void unpack(std::span<const std::uint8_t> bytes, std::span<Element> values) {
  const std::uint8_t* at = bytes.data();
  std::uint32_t before = 0;
  for (Element& element : values) {
    const std::uint64_t begin = take(at);
    before = unfolded(before, begin / 2);
    element = {};
    element.corners[0] = VertexId(before);
    for (std::size_t i = 1; i < 3 + begin % 2; ++i)
      element.corners[i] = VertexId(unfolded(before, take(at)));
  }
}

/// Each is a number in a table, which has them in the order in which they come first. One that is
/// new is followed by what it is.
Bytes packed(std::span<const ElementOrigin> origins) {
  Bytes bytes;
  bytes.reserve(origins.size() + 64);
  std::map<std::uint32_t, std::size_t> numbers;
  for (const ElementOrigin& origin : origins) {
    const auto value = std::bit_cast<std::uint32_t>(origin);
    const auto [place, isNew] = numbers.try_emplace(value, numbers.size());
    put(bytes, place->second);
    if (isNew) put(bytes, value);
  }
  bytes.shrink_to_fit();
  return bytes;
}

void unpack(std::span<const std::uint8_t> bytes, std::span<ElementOrigin> values) {
  const std::uint8_t* at = bytes.data();
  std::vector<ElementOrigin> table;
  for (ElementOrigin& origin : values) {
    const std::uint64_t number = take(at);
    if (number == table.size())
      table.push_back(std::bit_cast<ElementOrigin>(static_cast<std::uint32_t>(take(at))));
    origin = table[number];
  }
}

}  // namespace af2::geometry
