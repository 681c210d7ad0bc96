// Positions as sums over matched points, and the .rls text of a rule that is given by such sums.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/point.h"
#include "tests/dsl/netgen/rule_numbers.h"

namespace af2::dsl {

/// 0.5 + 2*x3 - y2: weights by "", "x3", "y2".
using LinearSum = std::map<std::string, double>;

/// A position: its x and its y.
struct SumPoint {
  LinearSum x, y;
  Point2 at(std::span<const Point2> matched) const;
};

std::vector<SumPoint> readSums(std::string_view text);

/// "1-2 2-3" as pairs of numbers, "1-2-3" as triples.
std::vector<std::vector<int>> readTuples(std::string_view text);

/// The reference positions of the matched points.
std::vector<Point2> references(const RuleNumbers& rule);

/// The rule as Netgen's files write it: references, and shares of deviations.
std::string rlsText(const RuleNumbers& rule);

}  // namespace af2::dsl
