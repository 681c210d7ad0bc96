// Elements of second order: a vertex at the middle of each side, on the surface.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// Where the middles of the sides of an element lie, on the surface: [0] between corners 0 and 1,
/// ...
using SideMiddles = std::array<Point3, 4>;

/// Gives the mesh its midside vertices, each once, after the other vertices.
///
/// An element that its curved sides would turn over somewhere gets straight sides, and so do its
/// neighbours there; such elements are listed in mesh.straightened.
///
/// middles  by element. Along edges of the model, EdgeSegment::middle counts instead.
AF2_EXPORT void makeSecondOrder(ModelMesh& mesh, const std::vector<SideMiddles>& middles);

/// The least Jacobian of an element of second order over that of the element with straight sides: 1
/// if it is not distorted, not above 0 if it is turned over somewhere. For triangles a lower bound
/// over the whole element; for quadrilaterals the least over the vertices and the centre.
AF2_EXPORT double scaledJacobian(const ModelMesh& mesh, std::size_t element);

}  // namespace af2::geometry
