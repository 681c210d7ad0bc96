#include "geometry/too_many.h"

#include <string>

#include "engine/error.h"

namespace af2::geometry {

void refuseTooMany(double elements) {
  constexpr double kMostElements = 2e9;  // vertices and elements have 32-bit numbers
  if (!(elements > kMostElements)) return;
  const std::string count = elements < 1e18
                                ? "about " + std::to_string(static_cast<long long>(elements / 1e9))
                                : std::string("more than a thousand million");
  throw InputError("the sizes ask for " + count +
                   " thousand million elements; ask for larger ones");
}

}  // namespace af2::geometry
