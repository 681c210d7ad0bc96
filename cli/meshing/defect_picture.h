// A picture of a model with its defects marked.
#pragma once

#include <string>
#include <vector>

#include "dsl/picture/canvas.h"
#include "geometry/occ/inspect/defects.h"

namespace af2::cli {

/// The edges of the model in grey, seen from one corner, and in the colour of each kind of defect
/// the edges, faces and places at fault, with a key. Returns the bytes of the file.
std::string drawDefects(const geometry::Model& model, const std::vector<geometry::Defect>& defects,
                        dsl::PictureFormat format);

}  // namespace af2::cli
