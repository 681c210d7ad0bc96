#include "geometry/sizes/too_many.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/base/free_memory.h"

namespace af2::geometry {

namespace {

/// At the peak of a run, per triangle: docs/performance.md.
constexpr double kBytesPerElement = 100;

std::string gigabytes(double bytes) { return textOf(bytes / 1e9, 3) + " GB"; }

/// How many times larger the sizes must be for so many times fewer elements.
double factorFor(double tooMany) { return std::ceil(10 * std::sqrt(tooMany)) / 10; }

[[noreturn]] void refuse(const std::string& why, double tooMany) {
  const double factor = factorFor(tooMany);
  throw TooManyElements(
      why + "ask for sizes that are at least " + textOf(factor, 6) + " times as large", factor);
}

}  // namespace

void refuseTooMany(double elements, double maxMemory) {
  constexpr double kMaxElements = 2e9;  // vertices and elements have 32-bit numbers
  if (!std::isfinite(elements))
    throw InputError("the sizes need more than 1e+300 elements; ask for larger ones");
  const std::string needs = "the sizes need about " + textOf(elements, 2) + " elements";
  if (elements > kMaxElements)
    refuse(needs + ", but a mesh can have " + textOf(kMaxElements, 2) + "; ",
           elements / kMaxElements);
  const double bytes = kBytesPerElement * elements;
  if (maxMemory == 0 && bytes < 1e8) return;  // any machine has so much
  const double most = maxMemory > 0 ? maxMemory : freeMemory();
  if (bytes <= most) return;
  refuse(needs + ", which take about " + gigabytes(bytes) + " of memory, but " + gigabytes(most) +
             (maxMemory > 0 ? " are allowed; " : " are free; "),
         bytes / most);
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
