// What pictures draw of a mesh: the outline of each element, and which sides lie on edges of the
// model. Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A part of a side of an element: all of it, or a half of a curved one.
struct DrawnSide {
  VertexId from, to;
  bool isOutline = false;  ///< on an edge of the model
};

/// A triangle of an element. Sides between triangles of the same element are not drawn.
struct DrawnTriangle {
  std::array<VertexId, 3> corners;
  /// By side, [0] between corners 0 and 1.
  enum class Side { Inside, Side, Outline };
  std::array<Side, 3> sides;
};

class DrawnMesh {
 public:
  explicit DrawnMesh(const ModelMesh& mesh);

  /// Around the element, counter-clockwise.
  std::vector<DrawnSide> sidesOf(std::size_t element) const;
  std::vector<DrawnTriangle> trianglesOf(std::size_t element) const;

 private:
  bool isOutline(VertexId a, VertexId b) const;

  const ModelMesh& mesh_;
  std::vector<std::pair<VertexId, VertexId>> outlines_;  ///< the lower vertex first, ascending
};

/// The places where fronts of failed faces got stuck.
std::vector<StuckPlace> stuckPlaces(const ModelMesh& mesh);

/// The box around the vertices and stuck places of a mesh; all zero if there are none.
struct DrawnBox {
  Point3 low{}, high{};
  double diagonal() const { return distance(low, high); }
  /// Whether the mesh lies in a plane of constant z, up to rounding.
  bool isPlanar() const { return high.z - low.z <= 1e-9 * diagonal(); }
};
DrawnBox drawnBox(const ModelMesh& mesh);

}  // namespace af2::geometry
