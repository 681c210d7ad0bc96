// Algorithms of OpenCASCADE for the program af2: from a library beside it that is loaded when the
// first of them is called.
#include <cstring>

#include "geometry/base/loaded_parts.h"
#include "geometry/occ/loading/algorithms_module.h"

namespace af2::geometry {

namespace {

const AlgorithmsModule& algorithms() {
  const auto isSame = [](const AlgorithmsModule& module) {
    return std::strcmp(module.version, AF2_VERSION) == 0 &&
           module.optionsSize == sizeof(FuseOptions);
  };
  static const AlgorithmsModule& loaded =
      moduleOfPart<AlgorithmsModule>("af2-algorithms.so", kAlgorithmsModuleEntry, isSame);
  return loaded;
}

}  // namespace

std::unique_ptr<GeneralFuse> fuseShapes(const std::vector<TopoDS_Shape>& arguments,
                                        const FuseOptions& options) {
  return algorithms().fuse(arguments, options);
}

std::vector<TopoDS_Shape> solidsBetween(const std::vector<TopoDS_Shape>& faces) {
  return algorithms().findSolids(faces);
}

bool isTurned(const TopoDS_Shape& piece, const TopoDS_Shape& face) {
  return algorithms().isPieceTurned(piece, face);
}

void triangulate(const TopoDS_Shape& shape, double deflection, double turn) {
  algorithms().triangulateShape(shape, deflection, turn);
}

}  // namespace af2::geometry
