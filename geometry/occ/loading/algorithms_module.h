// What the library with algorithms of OpenCASCADE offers to the program that loads it, as that of a
// reader does: reader_module.h. Not installed.
#pragma once

#include "geometry/occ/algorithms/general_fuse.h"
#include "geometry/occ/algorithms/triangulation.h"

namespace af2::geometry {

struct AlgorithmsModule {
  /// Both sides have been compiled from the same sources, as far as can be told.
  const char* version;
  std::size_t optionsSize;

  decltype(&fuseShapes) fuse;
  decltype(&solidsBetween) findSolids;
  decltype(&isTurned) isPieceTurned;
  decltype(&triangulate) triangulateShape;
};

/// The name of the function `const AlgorithmsModule* ()` of the library.
inline constexpr const char* kAlgorithmsModuleEntry = "af2AlgorithmsModule";

}  // namespace af2::geometry
