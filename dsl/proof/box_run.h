// Bounds of all steps of a program, and of their derivatives, over a box of matches.
#pragma once

#include <span>
#include <vector>

#include "dsl/program/program.h"
#include "dsl/proof/interval.h"
#include "dsl/proof/rule_graph.h"

namespace af2::dsl {

using Box = std::vector<Interval>;  ///< by variable

/// The bounds hold for every match of the box at which the step has a value. The slopes are bounds
/// of the partial derivatives by variable; they are infinite if the step may be discontinuous.
class BoxRun {
 public:
  BoxRun(const Program& program, std::span<const GraphVariable> variables);

  void run(const Box& box);

  Interval value(std::size_t step) const { return values_[step]; }
  Interval slope(std::size_t step, std::size_t variable) const {
    return slopes_[step * variables_ + variable];
  }
  /// Bounds at the middle of the box.
  Interval middle(std::size_t step) const { return middles_[step]; }
  /// Bounds of p - factor * q: the value at the middle of the box, plus the range that the slopes
  /// of the difference allow.
  Interval differenceOf(std::size_t p, double factor, std::size_t q) const;

 private:
  void bound(std::size_t step);

  const Program& program_;
  std::size_t variables_;
  std::vector<int> variableOf_;  // by step; -1: none
  Box box_;
  std::vector<Interval> values_, slopes_, middles_;
};

}  // namespace af2::dsl
