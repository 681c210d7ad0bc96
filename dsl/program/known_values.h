// What is certain about a program at one quality level, whatever the match.
#pragma once

#include <cstddef>
#include <vector>

#include "dsl/program/program.h"

namespace af2::dsl {

/// A value as far as the level alone tells it.
struct KnownValue {
  enum class Kind {
    Open,    ///< depends on the match
    Number,  ///< always this one
    None     ///< a division by zero or the like: there never is one
  };
  Kind kind = Kind::Open;
  double number = 0;  ///< of a Number

  bool isNone() const { return kind == Kind::None; }
  bool isFalse() const { return kind == Kind::Number && number == 0; }
  bool isTrue() const { return kind == Kind::Number && number != 0; }
};

/// What is known of the results of a program.
class KnownResults {
 public:
  KnownResults(const Program& program, int level);

  const KnownValue& operator[](std::size_t result) const;
  /// From now on all without a value that this result comes from counts as open: so that a fault
  /// is told once, and not of all that follows from it.
  void forget(std::size_t result);

 private:
  void follow();

  const Program& program_;
  int level_;
  std::vector<KnownValue> values_;  // by step
  std::vector<bool> isForgotten_;
};

/// Whether any step asks for the level.
bool asksForLevel(const Program& program);

}  // namespace af2::dsl
