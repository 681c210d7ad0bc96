#include "geometry/occ/faces/edge_sides.h"

#include <BRep_Tool.hxx>

namespace af2::geometry {

std::map<int, std::vector<EdgeSide>> sidesOfEdges(const ModelShape& model) {
  std::map<int, std::vector<EdgeSide>> sides;
  for (int face = 1; face <= model.faces.Extent(); ++face) {
    const TopAbs_Orientation own = model.face(face).Orientation();
    for (const EdgeUse& use : model.edgesOfFaces[static_cast<std::size_t>(face) - 1])
      if (use.id <= model.edgesOfFile && !BRep_Tool::Degenerated(use.edge))
        sides[use.id].push_back({face, use.edge.Orientation() == own});
  }
  return sides;
}

}  // namespace af2::geometry
