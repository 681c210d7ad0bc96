// What a rule of a Netgen file must hold beyond its single parts.
#pragma once

#include <cstddef>

#include "dsl/netgen/rls_reader.h"

namespace af2::dsl {

/// As many as AF2 can hold in one rule.
constexpr std::size_t kMostRlsPoints = 12, kMostRlsElements = 8;

/// Tells of numbers of points that there are not, of missing parts, and of too many.
void checkRlsRule(const RlsRule& rule, RlsReader& reader);

}  // namespace af2::dsl
