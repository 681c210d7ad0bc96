// The mesh that the engine makes: vertices and elements in creation order.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/point.h"

namespace af2 {

/// A triangle or quadrilateral, counter-clockwise seen from the side to which normals point.
struct Element {
  std::array<VertexId, 4> corners;

  bool isQuad() const { return !corners[3].isNone(); }
  int size() const { return isQuad() ? 4 : 3; }
  std::span<const VertexId> vertices() const {
    return {corners.data(), static_cast<std::size_t>(size())};
  }
  bool operator==(const Element&) const = default;
};

/// Whether all corners are distinct and below the vertex count.
inline bool hasProperCorners(const Element& element, std::size_t vertices) {
  const auto& [a, b, c, d] = element.corners;
  return a.value < vertices && b.value < vertices && c.value < vertices &&
         (d.value < vertices || d.isNone()) && a != b && b != c && c != a && a != d && b != d &&
         c != d;
}

/// What made an element.
struct ElementOrigin {
  std::uint16_t rule = 0;  ///< index in the rule set
  std::uint8_t level = 0;  ///< quality level of the base edge, at most 255; 0: no rule made it
  bool isChanged = false;  ///< whether optimisation gave the element other corners
  bool operator==(const ElementOrigin&) const = default;
};

struct Mesh {
  std::vector<SurfacePoint> vertices;
  std::vector<Element> elements;
  std::vector<ElementOrigin> origins;  ///< by element
  bool operator==(const Mesh&) const = default;
};

}  // namespace af2
