#include "geometry/sizes/sizes.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/place_text.h"

namespace af2::geometry {
namespace {

bool isPositive(double size) { return std::isfinite(size) && size > 0; }

void checkEach(const std::map<int, double>& sizes, const std::string& kind) {
  for (const auto& [id, size] : sizes)
    if (!isPositive(size))
      throw InputError("size for " + kind + " " + std::to_string(id) + ": must be positive");
}

}  // namespace

void checkSizes(const Sizes& sizes) {
  constexpr double kFewestPerTurn = 3;
  if (!isPositive(sizes.size)) throw InputError("the size must be a positive number");
  if (!(sizes.minSize >= 0) || !(sizes.maxSize >= sizes.minSize) || !(sizes.maxSize > 0))
    throw InputError("the smallest size must not be negative, nor above the largest");
  if (sizes.elementsPerTurn != 0 && !(sizes.elementsPerTurn >= kFewestPerTurn))
    throw InputError("a turn needs at least 3 elements");
  if (!(sizes.elementsAcross >= 0) || !std::isfinite(sizes.elementsAcross))
    throw InputError("the number of elements across narrow places must not be negative");
  if (!isPositive(sizes.growth)) throw InputError("the growth of sizes must be a positive number");
  if (sizes.growth > kMaxGrowth)
    throw InputError("the growth of sizes must be at most " +
                     std::to_string(static_cast<int>(kMaxGrowth)) + " per unit of length");
  checkChords(sizes.chords);
  checkEach(sizes.faceSizes, "face");
  checkEach(sizes.edgeSizes, "edge");
}

Sizes withinExtent(Sizes sizes, double extent) {
  if (!(extent > 0)) return sizes;
  sizes.size = std::min(sizes.size, extent);
  sizes.maxSize = std::min(sizes.maxSize, extent);
  sizes.minSize = std::min(sizes.minSize, extent);
  return sizes;
}

double largestOf(const Sizes& sizes) {
  double largest = sizes.size;
  for (const auto& [face, size] : sizes.faceSizes) largest = std::max(largest, size);
  for (const auto& [edge, size] : sizes.edgeSizes) largest = std::max(largest, size);
  return largest;
}

std::string raisedSizeNote(const Sizes& sizes) {
  return "no size is below the smallest one that is allowed, " + textOf(sizes.minSize, 4) +
         ", although " + textOf(sizes.size, 4) + " was asked for";
}

double bounded(const Sizes& sizes, double size) {
  return std::clamp(size, sizes.minSize, sizes.maxSize);
}

double wantedOnFace(const Sizes& sizes, int face) {
  const auto found = sizes.faceSizes.find(face);
  return bounded(sizes, found == sizes.faceSizes.end() ? sizes.size : found->second);
}

double chordOnFace(const Sizes& sizes, int face) {
  const auto found = sizes.chords.faces.find(face);
  const ChordBound& bound =
      found == sizes.chords.faces.end() ? sizes.chords.everywhere : found->second;
  if (!bound.isGiven()) return std::numeric_limits<double>::infinity();
  return bound.isShareOfSize ? bound.value * wantedOnFace(sizes, face) : bound.value;
}

double limitByFunction(const Sizes& sizes, double size, const Point3& position) {
  if (sizes.function) sizes.function.lower({&position, 1}, {&size, 1});
  return size;
}

}  // namespace af2::geometry
