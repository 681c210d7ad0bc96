// A try at a face with its number in the round.
#pragma once

#include <cstdint>

#include "geometry/mesh/try_limits.h"

namespace af2::mpi {

struct NumberedTry {
  std::uint64_t number = 0;
  geometry::FaceTry what;
};

}  // namespace af2::mpi
