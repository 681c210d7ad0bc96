// Values of a program that are the same for every match at one quality level.
#pragma once

#include <cstddef>
#include <vector>

#include "dsl/program/program.h"

namespace af2::dsl {

/// The part of a value that depends on the level alone.
struct KnownValue {
  enum class Kind {
    Open,    ///< depends on the match
    Number,  ///< the same number at every match
    None     ///< no match has a value, because of a division by zero or the like
  };
  Kind kind = Kind::Open;
  double number = 0;  ///< for a Number

  bool isNone() const { return kind == Kind::None; }
  bool isFalse() const { return kind == Kind::Number && number == 0; }
  bool isTrue() const { return kind == Kind::Number && number != 0; }
};

/// The known results of a program.
class KnownResults {
 public:
  KnownResults(const Program& program, int level);

  const KnownValue& operator[](std::size_t result) const;
  /// Marks all steps without a value on which this result depends as open, so that a fault is
  /// reported once, and not again for each result that depends on it.
  void forget(std::size_t result);

 private:
  void follow();

  const Program& program_;
  int level_;
  std::vector<KnownValue> values_;  // by step
  std::vector<bool> isForgotten_;
};

/// Whether any step depends on the level.
bool asksForLevel(const Program& program);

}  // namespace af2::dsl
