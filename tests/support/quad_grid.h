// A square of unit squares, for tests that change some of them.
#pragma once

#include "tests/support/flat_surface.h"

namespace af2::testing {

struct QuadGrid {
  int n;
  Mesh mesh;         ///< element (i, j) is number i + n j
  FrontInput input;  ///< the rim

  explicit QuadGrid(int squares) : n(squares) {
    const double side = n;
    addLoop(input, divided({{0, 0}, {side, 0}, {side, side}, {0, side}}, 1));
    for (const BoundaryCorner& c : input.loops[0]) mesh.vertices.push_back(c.point);
    for (int j = 1; j < n; ++j)
      for (int i = 1; i < n; ++i) addVertex({1.0 * i, 1.0 * j});
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        addElement({{id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}});
  }

  VertexId addVertex(Point2 p) {
    mesh.vertices.push_back(flatCorner(0, p).point);
    return VertexId(mesh.vertices.size() - 1);
  }
  void addElement(const Element& element) {
    mesh.elements.push_back(element);
    mesh.origins.emplace_back();
  }

  /// Makes two triangles of an element.
  void split(int i, int j) {
    const auto [a, b, c, d] = element(i, j).corners;
    element(i, j) = {{a, b, c, {}}};
    addElement({{a, c, d, {}}});
  }

  VertexId id(int i, int j) const {
    const int place = j == 0   ? i
                      : i == n ? n + j
                      : j == n ? 3 * n - i
                      : i == 0 ? 4 * n - j
                               : 4 * n + (i - 1) + (n - 1) * (j - 1);
    return VertexId(static_cast<std::size_t>(place));
  }
  Element& element(int i, int j) { return mesh.elements[static_cast<std::size_t>(i + n * j)]; }
};

}  // namespace af2::testing
