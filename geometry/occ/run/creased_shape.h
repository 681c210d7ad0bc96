// A model in which the creases inside faces are edges.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// The model as it is, with its own numbers, and an edge more along each piece of a crease that
/// lies inside a face. Each begins and ends at vertices of the face or at new ones on its edges.
/// The same shape if no face has creases.
///
/// faces  that are to be meshed, ascending
std::shared_ptr<const ModelShape> withCreases(std::shared_ptr<const ModelShape> model,
                                              const std::vector<int>& faces, const CadSizes& sizes,
                                              int threads, const std::stop_token& stop);

}  // namespace af2::geometry
