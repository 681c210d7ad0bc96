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

/// Whether all corners are different ones of so many vertices.
inline bool hasProperCorners(const Element& element, std::size_t vertices) {
  const auto& [a, b, c, d] = element.corners;
  return a.value < vertices && b.value < vertices && c.value < vertices &&
         (d.value < vertices || d.isNone()) && a != b && b != c && c != a && a != d && b != d &&
         c != d;
}

struct Mesh {
  std::vector<SurfacePoint> vertices;
  std::vector<Element> elements;
  std::vector<std::uint16_t> rule;  ///< by element: index of the rule that made it
  bool operator==(const Mesh&) const = default;
};

}  // namespace af2
