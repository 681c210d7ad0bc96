#include "geometry/occ/sizes/wanted_along_edge.h"

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "geometry/occ/sizes/sizing.h"

namespace af2::geometry {

WantedAlongEdge::WantedAlongEdge(const ModelShape& model, int edge, const CadSizes& sizes)
    : sizes_(sizes) {
  const auto given = sizes.edgeSizes.find(edge);
  const bool isGiven = given != sizes.edgeSizes.end();
  largest_ = bounded(sizes, isGiven ? given->second : sizes.size);
  const std::vector<int>& faces = model.facesOfEdges[static_cast<std::size_t>(edge) - 1];
  for (const int face : faces) chord_ = std::min(chord_, chordOnFace(sizes, face));
  if (isGiven) return;
  for (const int face : faces) addFace(model, edge, face);
}

WantedAlongEdge::Size WantedAlongEdge::at(const Point3& position, double parameter) const {
  Size size{largest_, sizes_.minSize};
  for (const Neighbor& face : faces_) {
    const Size here = onFace(face, position, parameter);
    size = {std::min(size.wanted, here.wanted), std::min(size.least, here.least)};
  }
  return size;
}

void WantedAlongEdge::addFace(const ModelShape& model, int edge, int face) {
  Neighbor neighbor{face, wantedOnFace(sizes_, face), std::nullopt, {}};
  largest_ = faces_.empty() ? neighbor.wanted : std::min(largest_, neighbor.wanted);
  try {
    const FaceSurface surface = model.surface(face);
    double first, last;
    // Along a crease, what the face turns across it is left out.
    if (!surface.isPlane() && edge <= model.edgesOfFile) {
      neighbor.curve =
          BRep_Tool::CurveOnSurface(model.edge(edge), TopoDS::Face(model.faces(face)), first, last);
      neighbor.surface = surface;
    }
  } catch (const std::exception&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
  faces_.push_back(std::move(neighbor));
}

WantedAlongEdge::Size WantedAlongEdge::onFace(const Neighbor& face, const Point3& position,
                                              double parameter) const {
  if (!face.surface || face.curve.IsNull()) return {face.wanted, sizes_.minSize};
  const gp_Pnt2d uv = face.curve->Value(parameter);
  const CurvedSize curved =
      curvedSizeAt(sizes_, face.id, face.wanted, *face.surface, {position, {}, uv.X(), uv.Y()});
  // A full turn keeps its number of elements.
  return {std::min(curved.share * face.wanted, curved.limit), curved.least};
}

}  // namespace af2::geometry
