// A mesh in another unit of length.
#pragma once

#include <span>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A length in millimetres, multiplied by `perMillimetre`, is the length in the unit.
struct LengthUnit {
  const char* name;
  double perMillimetre;
};

/// The units that files of meshes can have.
AF2_EXPORT std::span<const LengthUnit> lengthUnits();

/// All coordinates, lengths and areas that files of meshes have, multiplied by `factor` (> 0) or by
/// its square. Contacts, healing and texts stay as they are.
AF2_EXPORT ModelMesh scaledMesh(ModelMesh mesh, double factor);

}  // namespace af2::geometry
