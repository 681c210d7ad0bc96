// The way out where a value of one type stands where another is needed.
#pragma once

#include <string>

#include "dsl/program/values.h"

namespace af2::dsl {

/// What a place needs: a type that is taken there, the first of them where there are several, and
/// the words for it.
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

/// What a parameter of a function takes, by its letter in the table of functions (builtins.h).
Wanted wantedBy(char parameter);

/// Empty if there is no usual way.
std::string wayToType(Wanted::Kind wanted, const Value& found);

}  // namespace af2::dsl
