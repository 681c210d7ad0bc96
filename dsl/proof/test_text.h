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

/// A test on the piece of front that a match stands on. Coordinates are written with all digits, so
/// that the test stands on the same match to the last bit.
std::string writeTest(const PatternMatch& match, const TestText& text);

/// A share in per cent, with the digits that matter: "0.41 %", "86 %".
std::string percent(double share);

/// A number with the fewest digits that give it back.
std::string shortest(double number);

}  // namespace af2::dsl
