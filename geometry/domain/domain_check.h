// Whether a domain makes sense. Not installed.
#pragma once

#include "geometry/domain/domain_model.h"

namespace af2::geometry {

/// Throws InputError for a model whose parts name others that are not there.
void checkDomain(const DomainModel& model);

/// Throws InputError if points are given for an edge that is not a single curve.
void checkPoints(const DomainModel& model, const EdgePoints& given);

}  // namespace af2::geometry
