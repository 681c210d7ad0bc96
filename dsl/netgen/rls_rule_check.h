// Checks of a rule of a Netgen file as a whole.
#pragma once

#include <cstddef>

#include "dsl/netgen/rls_reader.h"

namespace af2::dsl {

/// The limit of AF2 for one rule.
constexpr std::size_t kMaxRlsPoints = 12, kMaxRlsElements = 8;

/// Reports points that do not exist, missing parts, and too many parts.
void checkRlsRule(const RlsRule& rule, RlsReader& reader);

}  // namespace af2::dsl
