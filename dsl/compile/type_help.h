// Suggestions for a value of the wrong type.
#pragma once

#include <string>

#include "dsl/program/values.h"

namespace af2::dsl {

/// The type that a place requires (the first one if several are accepted), and the words for it.
struct Wanted {
  enum class Kind { Number, Angle, Condition, Point, Vector, Shape, Other };
  Kind kind = Kind::Other;
  std::string words;  ///< "a number", "a point or a vector"
};

Wanted wantedNumber();
Wanted wantedAngle();
Wanted wantedCondition();
Wanted wantedPoint();
Wanted wantedShape();

/// The type of a parameter, by its letter in the table of functions (builtins.h).
Wanted wantedBy(char parameter);

/// A suggestion to convert `found` to the type; empty if there is no usual way.
std::string wayToType(Wanted::Kind wanted, const Value& found);

}  // namespace af2::dsl
