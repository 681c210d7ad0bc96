#include "geometry/sizes/too_many.h"

#include <limits>
#include <sstream>
#include <string>

#include "engine/base/error.h"

namespace af2::geometry {

void refuseTooMany(double elements) {
  constexpr double kMaxElements = 2e9;  // vertices and elements have 32-bit numbers
  if (!(elements > kMaxElements)) return;
  const std::string count = elements < 1e18
                                ? "about " + std::to_string(static_cast<long long>(elements / 1e9))
                                : std::string("more than a billion");
  throw InputError("the sizes need " + count + " billion elements; ask for larger ones");
}

void refuseBlurred(double farthest, double extent, double size) {
  constexpr double kSharp = 1e-3;  // of the size
  constexpr double kNear = 1e-9;   // of the extent: else the model is where it should be
  const double step = farthest * std::numeric_limits<double>::epsilon();
  if (step <= kSharp * size || step <= kNear * extent) return;
  std::ostringstream text;
  text << "coordinates of " << farthest << " are exact only to " << step
       << ", which is too coarse for elements of size " << size
       << "; move the model to the origin, or ask for larger elements";
  throw InputError(text.str());
}

}  // namespace af2::geometry
