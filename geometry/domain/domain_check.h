// Whether a domain and what is wanted of its mesh make sense. Not installed.
#pragma once

#include "geometry/domain/domain_model.h"

namespace af2::geometry {

/// The largest growth of sizes per unit of length. Elements at a short segment are up to so many
/// times longer than it: the front has to look at as many segments around each of them.
constexpr double kMostGrowth = 10;

/// What is wanted of sizes, of a domain as of a CAD model.
struct WantedSizes {
  double size, minSize, maxSize, elementsPerTurn, elementsAcross, growth;
};

/// Throws InputError for what is not positive, or above what it should be below.
void checkWanted(const WantedSizes& wanted);
void checkWanted(const DomainMeshingOptions& options);

/// Throws InputError for an option that makes no sense, an id that the model does not have, and for
/// a model whose parts name others that are not there.
void checkDomain(const DomainModel& model, const DomainMeshingOptions& options);

}  // namespace af2::geometry
