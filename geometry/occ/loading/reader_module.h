// What a library with one of the readers of CAD files offers to the program that loads it. The
// library brings those of OpenCASCADE's libraries that only this reader needs: starting a program
// with all of them takes longer than meshing a small model. Not installed.
#pragma once

#include <filesystem>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

struct ReaderModule {
  /// Both sides have been compiled from the same sources, as far as can be told.
  const char* version;
  std::size_t shapeSize;

  ReadShape (*read)(const std::filesystem::path&);
};

/// The name of the function `const ReaderModule* ()` of the library.
inline constexpr const char* kReaderModuleEntry = "af2ReaderModule";

}  // namespace af2::geometry
