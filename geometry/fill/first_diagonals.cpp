#include "geometry/fill/first_diagonals.h"

#include <algorithm>
#include <cstddef>

namespace af2::geometry {

void beginAtBoundaryCorners(const MeshBoundary& boundary, Mesh& mesh) {
  for (Element& element : mesh.elements) {
    if (!element.isQuad()) continue;
    const auto corners = element.vertices();
    const auto isOnBoundary = [&](std::size_t side) {
      return boundary.contains(corners[side % 4], corners[(side + 1) % 4]);
    };
    for (std::size_t i = 0; i < 4; ++i) {
      if (!isOnBoundary(i + 3) || !isOnBoundary(i)) continue;
      std::ranges::rotate(element.corners,
                          element.corners.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
}

}  // namespace af2::geometry
