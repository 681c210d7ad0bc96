// The volumes that a mesh encloses: the material of each solid, and voids.
// Not installed.
#pragma once

#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/volumes/mesh_cells.h"

namespace af2::geometry {

/// A volume that elements enclose and do not divide.
struct MeshVolume {
  /// 0: a void. Else the solid whose material it is: groups of kind Solid are counted from 1 in
  /// their order. Volumes behind faces of no solid, such as those of a surface of triangles, have
  /// the numbers after these, each its own.
  int solid = 0;
  Point3 inside;           ///< a point strictly inside, if it was wanted
  std::vector<int> faces;  ///< ids, ascending: faces with elements that bound it
  bool operator==(const MeshVolume&) const = default;
};

/// In an order that depends on the mesh alone. Quadrilaterals count as two triangles, and midside
/// vertices not at all.
///
/// The material of a solid is behind its faces, or before those in FaceGroup::inward; so a solid
/// inside another one, without common faces, counts as itself only. A volume with material behind
/// none of its faces is a void, and so is one that the material of a single solid surrounds on the
/// other side of all its faces, whatever these look to. A solid whose mesh is open has no volume.
std::vector<MeshVolume> volumesOf(const ModelMesh& mesh,
                                  PointsInside points = PointsInside::Wanted);

}  // namespace af2::geometry
