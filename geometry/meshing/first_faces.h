// Which faces are meshed before all others.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

namespace af2::geometry {

/// The smallest faces, which together have a small share of the work: by face, whether it is one of
/// them. Most faces that ask for shorter edges are small. If they do so before the others are
/// meshed, these are meshed within the shorter edges at once, and not twice.
///
/// work  approximate number of elements of each face
std::vector<bool> smallFaces(const std::vector<double>& work);

}  // namespace af2::geometry
