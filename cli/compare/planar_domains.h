// Planar domains for comparisons, with typical difficulties.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/planar/poly_file.h"
#include "geometry/sizes/position_size.h"

namespace af2::cli {

struct NamedDomain {
  std::string name;
  geometry::PlanarDomain domain;
  /// The size at a place if that of the mesh is given; none: the same everywhere.
  std::function<double(const Point3&, double size)> sizeAt = {};
};

/// All are about as large as a unit square.
std::vector<NamedDomain> namedDomains();

/// A smooth region with `seed % 4` holes, the same for the same seed on every machine. Its segments
/// are edges of the mesh, an even number for each loop: of equal lengths, or, for every second
/// group of four seeds, of lengths that differ by up to a factor of two.
geometry::PlanarDomain randomDomain(std::uint64_t seed, double size);

}  // namespace af2::cli
