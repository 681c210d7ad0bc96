// Imprints a model as the options ask. Only with OpenCASCADE.
#pragma once

#include <stop_token>

#include "cli/meshing/imprint_request.h"
#include "geometry/occ/model/model.h"

namespace af2::cli {

/// The model itself if nothing is asked. Throws InputError if solids overlap, which must be
/// allowed.
geometry::Model imprintedModel(const geometry::Model& model, const ImprintRequest& request,
                               const std::stop_token& stop);

}  // namespace af2::cli
