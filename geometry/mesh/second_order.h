// Elements of second order: a vertex at the middle of each side, on the surface.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The positions on the surface of the middles of an element's sides: [0] between corners 0 and 1,
/// ...
using SideMiddles = std::array<Point3, 4>;

/// A side of an element: the vertices at its ends, the lower one first.
using SideEnds = std::pair<VertexId, VertexId>;

/// The sides of an element, in the order of its midside vertices.
std::vector<SideEnds> sidesOf(const Element& element);

/// Adds the midside vertices to the mesh, each once, after the other vertices.
///
/// An element that curved sides would invert somewhere gets straight sides, and its neighbours get
/// them on the common sides; such elements are listed in mesh.straightened.
///
/// middles  by element. Along edges of the model, EdgeSegment::middle counts instead.
/// alike    pairs of sides of which either both become straight or none does
AF2_EXPORT void makeSecondOrder(ModelMesh& mesh, const std::vector<SideMiddles>& middles,
                                const std::vector<std::pair<SideEnds, SideEnds>>& alike = {});

/// The opposite: makes a mesh of first order of one of second order, and returns the middles.
std::vector<SideMiddles> takeSecondOrder(ModelMesh& mesh);

/// The least Jacobian of an element of second order over that of the element with straight sides: 1
/// if it is not distorted, at most 0 if it is inverted somewhere. For triangles this is a lower
/// bound over the whole element; for quadrilaterals the least value at the vertices and the centre.
AF2_EXPORT double scaledJacobian(const ModelMesh& mesh, std::size_t element);

}  // namespace af2::geometry
