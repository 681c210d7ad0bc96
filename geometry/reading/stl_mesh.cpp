// STL files: loose triangles, joined where corners are at the same position.
#include <map>
#include <tuple>

#include "geometry/faceted/formats.h"
#include "geometry/reading/formats.h"

namespace af2::geometry {

void readStlMesh(const std::string& content, MeshBuilder& mesh) {
  Facets facets;
  facets.name = mesh.name();
  readStl(content, facets);
  std::map<std::tuple<double, double, double>, std::uint64_t> index;
  const bool hasParts = facets.groupNames.size() > 1;
  if (hasParts) mesh.setHasFaces();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    std::array<std::uint64_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3& p = facets.vertices[facets.triangles[t][i]];
      const auto [place, isNew] = index.try_emplace({p.x, p.y, p.z}, mesh.vertexCount());
      if (isNew) mesh.addVertex(p);
      corners[i] = place->second;
    }
    mesh.addElement(corners, hasParts ? static_cast<std::int32_t>(facets.group[t]) + 1 : 1);
  }
}

}  // namespace af2::geometry
