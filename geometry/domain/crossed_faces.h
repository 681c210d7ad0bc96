// Faces that cross each other, or themselves, in the model itself.
// Not installed.
#pragma once

#include <vector>

#include "geometry/check/element_crossings.h"
#include "geometry/domain/domain_model.h"

namespace af2::geometry {

/// Whether elements of a face cross others where it does so in the model itself.
///
/// crossings  of elements
bool crossInModel(const std::vector<FacesCross>& model, int face,
                  const std::vector<Crossing>& crossings);

/// Says so in the reasons of faces that failed.
void tellOfCrossings(const std::vector<FacesCross>& model, std::vector<FaceReport>& faces);

}  // namespace af2::geometry
