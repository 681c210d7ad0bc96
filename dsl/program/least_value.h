// The least value that a program can have at any match.
#pragma once

#include "dsl/program/program.h"

namespace af2::dsl {

/// A lower bound of the first result of a program, by interval arithmetic: it holds at every match
/// of this quality level at which the program has a value. -infinity if no bound is found.
///
/// Of a choice by `x < c`, each branch is bounded with what the condition says about x. Sums and
/// maxima of x and c/x are known to have their minimum at sqrt(c).
double leastValue(const Program& program, int level);

}  // namespace af2::dsl
