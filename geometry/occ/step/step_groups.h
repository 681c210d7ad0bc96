// Reads the names, layers and colours of parts from a STEP file.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TDocStd_Document.hxx>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Each named part, each layer and each colour, in the order of the document. Shapes may belong to
/// several.
std::vector<ShapeGroup> groupsOf(const Handle(TDocStd_Document) & document);

}  // namespace af2::geometry
