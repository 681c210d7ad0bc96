// The boundaries within which a face is meshed, and how many segments their loops have.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/edges/even_loops.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/mesh/fans.h"
#include "geometry/occ/faces/face_boundary.h"
#include "geometry/occ/faces/faces_on_faces.h"

namespace af2::geometry {

/// A cell of a face that is meshed by itself.
struct BoundedCell {
  FaceCell id;
  FaceBoundary boundary;
};

/// The cells of a face that has creases which are edges all through it. There are none if the face
/// is meshed as a whole: without creases, with other faces on it, or if some cell is not closed.
std::vector<BoundedCell> boundedCells(const ModelShape& model, int face,
                                      const DividedEdges& divided,
                                      const std::vector<FaceOnFace>& onFaces);

/// Adds the vertices at which layers of a face end on other edges (addLayerEnds); none if its
/// boundary is faulty.
void addLayerEndsOfFace(const ModelShape& model, int face, const EdgeLayers& layers,
                        const DividedEdges& divided, const std::vector<FaceOnFace>& onFaces,
                        LayerEnds& ends);

/// The loops around a face, or around its cells, as fronts get them: with both sides of seams,
/// without edges that cancel each other, and around the fans at sharp tips. There are none around a
/// face that lies on another one.
///
/// Throws GeometryError if the boundary is faulty.
std::vector<CountedLoop> countedLoops(const ModelShape& model, int face,
                                      const DividedEdges& divided,
                                      const std::vector<FaceOnFace>& onFaces, FanElements fans);

}  // namespace af2::geometry
