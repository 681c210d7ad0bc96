// The entry of the library with algorithms.
#include "geometry/occ/loading/algorithms_module.h"

extern "C" __attribute__((visibility("default"))) const af2::geometry::AlgorithmsModule*
af2AlgorithmsModule() {
  using namespace af2::geometry;
  static const AlgorithmsModule module{AF2_VERSION,    sizeof(FuseOptions), &fuseShapes,
                                       &solidsBetween, &isTurned,           &triangulate};
  return &module;
}
