// The OpenCASCADE side of a model. Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/occ/surfaces/face_cells.h"

namespace af2::geometry {

class FaceSurface;
class FaceSurfaces;

/// An edge in the direction in which a face uses it.
struct EdgeUse {
  int id = 0;
  TopoDS_Edge edge;  ///< oriented as in the face taken forward
};

/// A line along a crease inside a face. It is an edge, with an id above those of the model.
struct CreaseEdge {
  int id = 0;
  bool isAtU = true;       ///< along a line of constant u; else v
  std::size_t crease = 0;  ///< [k] is between the stretches k and k + 1 of this parameter
};

/// A shape with its parts numbered. It is immutable, so threads may share it.
struct ModelShape {
  TopoDS_Shape shape;
  TopTools_IndexedMapOfShape faces, edges, vertices;  ///< numbered from 1
  std::vector<std::vector<EdgeUse>> edgesOfFaces;     ///< [0] of face 1, in the order of its wires
  std::vector<std::vector<int>> facesOfEdges;         ///< [0] of edge 1, each face once
  std::vector<std::string> faceNames;                 ///< [0] is face 1
  std::vector<std::string> surfaceTypes;
  std::vector<FaceGroup> groups;
  std::string unit, fileUnit;
  double diagonal = 0;
  std::vector<std::string> notes;
  std::vector<std::string> lostFaces;
  std::optional<Healing> healing;
  std::optional<Imprinting> imprinting;
  int edgesOfFile = 0;             ///< higher ids belong to edges along creases
  std::map<int, FaceCells> cells;  ///< of the faces that have creases
  /// By vertex at the end of a crease: the distance within which edges turn with the crease.
  std::map<int, double> creaseReach;
  std::map<int, std::vector<CreaseEdge>> creaseEdges;  ///< by face
  std::vector<int> edgesWithoutCurve;  ///< whose curve was made from a face, ascending

  /// The face with the orientation in which the normal of its surface points outwards.
  TopoDS_Face face(int id) const;
  TopoDS_Edge edge(int id) const;

  TopoDS_Vertex vertex(int id) const;
  /// The surface of a face, for the calling thread alone. Throws GeometryError if it has none.
  FaceSurface surface(int face) const;

  std::shared_ptr<const FaceSurfaces> surfaces;  ///< what surface() copies
};

/// Parts of a shape that a file puts in one group.
struct ShapeGroup {
  std::string name;
  GroupKind kind = GroupKind::Part;
  std::vector<TopoDS_Shape> shapes;
};

/// The result of the reader of a format.
struct ReadShape {
  TopoDS_Shape shape;
  std::string unit, fileUnit;
  std::vector<std::string> notes;
  std::vector<std::string> lostFaces;                     ///< of the file, that the reader lost
  std::function<std::string(const TopoDS_Face&)> nameOf;  ///< may be empty
  std::vector<ShapeGroup> groups;
  std::optional<Healing> healing;
  std::optional<Imprinting> imprinting;
};

/// Numbers the parts of a shape and makes a curve in space for every edge, because threads must not
/// change the shape later.
std::shared_ptr<const ModelShape> makeModelShape(ReadShape read);

}  // namespace af2::geometry
