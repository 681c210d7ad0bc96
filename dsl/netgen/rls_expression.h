// Converts linear maps to geometry: finds `mid(b, c)` for 0.5 X2 + 0.5 X3.
#pragma once

#include <string>
#include <vector>

#include "dsl/netgen/rls_rule.h"

namespace af2::dsl {

/// A point that expressions may use.
struct NamedPoint {
  std::string name;
  ExactMap map;
};

/// The simplest expression of the rule language that places a point exactly as `map` does.
///
/// points  the matched points in order, then new points that are already defined
std::string pointExpression(const ExactMap& map, const std::vector<NamedPoint>& points);

/// A number of the rule language, exact: a decimal if possible, otherwise a fraction.
std::string numberText(const Exact& number);

}  // namespace af2::dsl
