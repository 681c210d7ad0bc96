// Integer ids with a type for each kind of object, so that they cannot be mixed up.
#pragma once

#include <compare>
#include <cstdint>

namespace af2 {

/// A 32-bit index into the array of all objects of one kind.
template <class Kind>
struct Id {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::uint32_t value = kNone;

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr bool isNone() const { return value == kNone; }
  constexpr auto operator<=>(const Id&) const = default;
};

using VertexId = Id<struct VertexKind>;    ///< a mesh vertex
using PlaceId = Id<struct PlaceKind>;      ///< a corner of the front, and the edge that leaves it
using ElementId = Id<struct ElementKind>;  ///< a triangle or quadrilateral

}  // namespace af2
