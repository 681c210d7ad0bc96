// Writes `test` blocks of the rule language.
#pragma once

#include <string>
#include <vector>

#include "dsl/match/pattern_match.h"

namespace af2::dsl {

struct TestText {
  std::string title;
  std::vector<Point2> obstacles;  ///< named o, or o1, o2, ...
  std::string expectation;        ///< after `expect `, without the semicolon
};

/// A test on the piece of front of a match. Coordinates are written with all digits, so that the
/// test uses exactly the same match.
std::string writeTest(const PatternMatch& match, const TestText& text);

/// What is expected of a rule that no longer fails for its zone, but is not chosen either.
std::string refusedOtherwise(const std::string& title);

/// A share in per cent, with at least two significant digits: "0.41 %", "86 %".
std::string percent(double share);

/// A number with the fewest digits from which it can be restored exactly.
std::string shortest(double number);

}  // namespace af2::dsl
