#include "geometry/faceted/crossed_facets.h"

#include "geometry/check/element_crossings.h"

namespace af2::geometry {
namespace {

/// All triangles as one face, so that those of separate parts are compared as well.
ModelMesh oneFaceOf(const Facets& facets) {
  ModelMesh mesh;
  mesh.vertices = facets.vertices;
  for (const auto& [a, b, c] : facets.triangles)
    mesh.elements.push_back({{VertexId(a), VertexId(b), VertexId(c), VertexId()}});
  mesh.face.assign(mesh.elements.size(), 1);
  return mesh;
}

}  // namespace

const std::vector<FacetsCross>& CrossedFacets::of(const Facets& facets) {
  std::call_once(isKnown_, [&] {
    for (const Crossing& crossing : elementCrossings(oneFaceOf(facets), kOneByOne))
      crossings_.push_back(
          {{crossing.elements[0].value, crossing.elements[1].value}, crossing.place});
  });
  return crossings_;
}

}  // namespace af2::geometry
