#include "engine/rule/binding.h"

#include "engine/base/turn.h"

namespace af2 {

int AF2Surroundings::count(int vertex, const std::array<double, 3>& bounds) const {
  return countOf(sweepOfAngle(turn(vertex).value_or(kFullTurn / 2)), bounds);
}

}  // namespace af2
