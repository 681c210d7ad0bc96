// The limit that an acceptance sets, whatever form it has.
#pragma once

#include <optional>

#include "engine/rule/element_metric.h"

namespace af2::dsl {

/// Scores from 0 up to this one are accepted, and `refused` is not; nothing where a perfect score
/// of 0 is not accepted either.
inline std::optional<double> acceptedBelow(const AF2Acceptance& acceptance, double refused,
                                           int level) {
  constexpr int kHalvings = 60;
  double low = 0, high = refused;
  if (refused <= 0 || !acceptance.accepts(low, level)) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (acceptance.accepts(middle, level) ? low : high) = middle;
  }
  return high;
}

}  // namespace af2::dsl
