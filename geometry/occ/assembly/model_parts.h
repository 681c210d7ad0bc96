// The parts of a model: its solids, and its sheets of faces that bound no solid.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

struct ModelPart {
  std::string name;        ///< unlike those of all other parts
  bool isSolid = true;     ///< else a sheet
  TopoDS_Shape shape;      ///< the solid, or a compound of the faces
  std::vector<int> faces;  ///< ids, ascending
};

/// First the solids, then the sheets, each in the order of the model.
///
/// The name of a part is that of the smallest named part of the file that has all its faces. Parts
/// of the same name get numbers: "bolt.1", "bolt.2". Without a name they are called "solid 3",
/// "sheet 1". Faces belong to the same sheet if they share an edge.
std::vector<ModelPart> partsOf(const ModelShape& model);

}  // namespace af2::geometry
