// Checks that a domain is valid. Not installed.
#pragma once

#include "geometry/domain/domain_model.h"

namespace af2::geometry {

/// Throws InputError if a part of the model refers to a part that does not exist.
void checkDomain(const DomainModel& model);

/// Throws InputError if points are given for an edge that is not a single curve.
void checkPoints(const DomainModel& model, const EdgePoints& given);

}  // namespace af2::geometry
