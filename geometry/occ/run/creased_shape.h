// Makes the creases inside faces of a model edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// The model with unchanged numbers, and one more edge along each piece of a crease inside a face.
/// Each such edge begins and ends at vertices of the face or at new vertices on its edges. Returns
/// the same shape if no face has creases.
///
/// faces  that are to be meshed, ascending
std::shared_ptr<const ModelShape> withCreases(std::shared_ptr<const ModelShape> model,
                                              const std::vector<int>& faces, const CadSizes& sizes,
                                              int threads, const std::stop_token& stop);

}  // namespace af2::geometry
