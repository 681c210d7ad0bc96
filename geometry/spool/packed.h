// Elements in few bytes. Neighbours in a list are neighbours in the mesh, more often than not, so
// that differences between their numbers are small.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/mesh/mesh.h"

namespace af2::geometry {

using Bytes = std::vector<std::uint8_t>;

/// About 5 bytes for a triangle.
Bytes packed(std::span<const Element> elements);
/// About 1 byte for an element.
Bytes packed(std::span<const ElementOrigin> origins);

/// What was packed: so many as `values` has room for.
void unpack(std::span<const std::uint8_t> bytes, std::span<Element> values);
void unpack(std::span<const std::uint8_t> bytes, std::span<ElementOrigin> values);

}  // namespace af2::geometry
