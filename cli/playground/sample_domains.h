// Planar domains on which the playground tries rules.
#pragma once

#include <span>
#include <string_view>

#include "geometry/planar/poly_file.h"

namespace af2::playground {

struct SampleDomain {
  std::string_view name, label;
  geometry::PlanarDomain (*make)();
};

/// All are about ten units wide.
std::span<const SampleDomain> sampleDomains();

struct SampleSize {
  std::string_view name, label;
  double size;
};

/// The smallest of them gives about twenty thousand elements.
std::span<const SampleSize> sampleSizes();

}  // namespace af2::playground
