// The parts of a model after the general fuse of all of them: split where they meet, checked, and
// with overlaps given to one of their parts.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "geometry/occ/algorithms/general_fuse.h"
#include "geometry/occ/assembly/imprint.h"
#include "geometry/occ/assembly/model_parts.h"

namespace af2::geometry {

/// A part after the fuse, or the overlap of some parts.
struct FusedPart {
  std::string name;
  bool isSolid = true;
  std::vector<TopoDS_Shape> shapes;  ///< solids, or the faces of a sheet
};

struct FusedParts {
  std::vector<FusedPart> parts;  ///< [i] is part i of the model; overlaps come after these
  std::vector<std::vector<TopoDS_Shape>> facePieces;  ///< [0] of face 1 of the model
  std::vector<std::string> changes;                   ///< what has become of overlaps
};

/// Throws InputError for overlaps that are refused; GeometryError, with the reason, if the fuse
/// fails, or its result is not sound: the volume of a part has changed, or a solid is open.
FusedParts fuseParts(const ModelShape& model, const std::vector<ModelPart>& parts,
                     Overlaps overlaps, const FuseOptions& options);

}  // namespace af2::geometry
