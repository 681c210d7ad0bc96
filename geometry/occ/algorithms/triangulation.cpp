#include "geometry/occ/algorithms/triangulation.h"

#include <BRepMesh_IncrementalMesh.hxx>

namespace af2::geometry {

void triangulate(const TopoDS_Shape& shape, double deflection, double turn) {
  constexpr bool kIsRelative = false, kInParallel = false;
  BRepMesh_IncrementalMesh(shape, deflection, kIsRelative, turn, kInParallel);
}

}  // namespace af2::geometry
