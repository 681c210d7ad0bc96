// Bounds of all steps of a program, and of their derivatives, over a box of matches.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "dsl/program/interval.h"
#include "dsl/program/program.h"

namespace af2::dsl {

/// A step that varies, and its bounds: a coordinate of a vertex, or the quality level.
struct BoxVariable {
  Op op;
  int vertex;
  Interval range;
};

using Box = std::vector<Interval>;  ///< by variable

/// Bounds of a step that is no variable, whatever the match, by those of its first four arguments.
Interval boundsOf(const Step& step, const std::array<Interval, 4>& arguments);

/// The bounds hold for every match of the box at which the step has a value. The slopes are bounds
/// of the partial derivatives by variable; they are infinite if the step may be discontinuous.
class BoxRun {
 public:
  BoxRun(const Program& program, std::span<const BoxVariable> variables);

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
