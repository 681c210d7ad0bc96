#include "geometry/sizes/too_many.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/base/free_memory.h"

namespace af2::geometry {

namespace {

/// At the peak of a run, per triangle of the mesh or of the faces in work: docs/performance.md.
constexpr double kBytesPerElement = 100;
/// What is left of a face on disk: its boundary, and boxes for the checks.
constexpr double kBytesPerSpooledElement = 4;
/// Of a face that is put away in memory, beside that: docs/geometry.md, "Meshes on disk".
constexpr double kBytesPerPackedElement = 18;
/// On disk while the faces are there, at least: docs/geometry.md, "Meshes on disk".
constexpr double kLeastOnDisk = 35;

double bytesFor(const std::vector<double>& elements, const MemoryLimit& limit) {
  const double all = std::accumulate(elements.begin(), elements.end(), 0.0);
  if (!limit.isSpooled) return kBytesPerElement * all;
  std::vector<double> largest = elements;
  std::ranges::sort(largest, std::greater());
  largest.resize(std::min(largest.size(), static_cast<std::size_t>(std::max(limit.threads, 1))));
  return kBytesPerElement * std::accumulate(largest.begin(), largest.end(), 0.0) +
         (kBytesPerSpooledElement + (limit.isPacked ? kBytesPerPackedElement : 0)) * all;
}

std::string gigabytes(double bytes) { return textOf(bytes / 1e9, 3) + " GB"; }

/// How many times larger the sizes must be for so many times fewer elements.
double factorFor(double tooMany) { return std::ceil(10 * std::sqrt(tooMany)) / 10; }

/// A refusal and its way out.
[[noreturn]] void refuse(const std::string& why, double tooMany, bool fitSpooled) {
  const double factor = factorFor(tooMany);
  throw TooManyElements(
      why + "ask for sizes that are at least " + textOf(factor, 6) + " times as large" +
          (fitSpooled ? ", or for finished faces to be put on disk (--stream)" : ""),
      factor, fitSpooled);
}

void refuseOnDisk(const std::string& needs, double elements, const MemoryLimit& limit) {
  const double bytes = kLeastOnDisk * elements;
  if (!limit.isSpooled || bytes <= limit.onDisk) return;
  refuse(needs + ", whose faces take at least " + gigabytes(bytes) +
             " of the disk that the mesh is written to, but " + gigabytes(limit.onDisk) +
             " are free there; write to a larger disk, or ",
         bytes / std::max(limit.onDisk, 1.0), false);
}

}  // namespace

void refuseTooMany(const std::vector<double>& byFace, const MemoryLimit& limit) {
  constexpr double kMaxElements = 2e9;  // vertices and elements have 32-bit numbers
  const double elements = std::accumulate(byFace.begin(), byFace.end(), 0.0);
  if (!std::isfinite(elements))
    throw InputError("the sizes need more than 1e+300 elements; ask for larger ones");
  const std::string needs = "the sizes need about " + textOf(elements, 2) + " elements";
  if (elements > kMaxElements)
    refuse(needs + ", but a mesh can have " + textOf(kMaxElements, 2) + "; ",
           elements / kMaxElements, false);
  const double bytes = bytesFor(byFace, limit);
  if (limit.bytes == 0 && bytes < 1e8)  // any machine has so much
    return refuseOnDisk(needs, elements, limit);
  const double most = limit.bytes > 0 ? limit.bytes : freeMemory();
  if (bytes <= most) return refuseOnDisk(needs, elements, limit);
  MemoryLimit onDisk = limit;
  onDisk.isSpooled = true;
  onDisk.isPacked = false;
  const bool isOnDisk = limit.isSpooled && !limit.isPacked;
  refuse(needs + ", which take about " + gigabytes(bytes) + " of memory" +
             (isOnDisk ? " with all but the largest faces on disk" : "") + ", but " +
             gigabytes(most) + (limit.bytes > 0 ? " are allowed; " : " are free; "),
         bytes / most, !isOnDisk && bytesFor(byFace, onDisk) <= most);
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
