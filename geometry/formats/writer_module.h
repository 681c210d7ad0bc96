// What a library that writes one format offers to AF2, which loads it when such a file is asked
// for: the libraries that it needs would make every start of a program slow. Not installed.
#pragma once

#include <cstddef>

#include "geometry/formats/grouped_mesh.h"

namespace af2::geometry {

struct WriterModule {
  /// Both sides have been compiled from the same sources, as far as can be told.
  const char* version;
  std::size_t meshSize;

  /// Writes a new file. Throws InputError, saying what failed, if that cannot be done.
  void (*write)(const GroupedMesh& mesh, const char* path);
};

/// The name of the function `const WriterModule* ()` of the library.
inline constexpr const char* kWriterModuleEntry = "af2WriterModule";

/// What meshSize is.
inline constexpr std::size_t kWriterMeshSize = sizeof(ModelMesh) + sizeof(GroupedMesh);

}  // namespace af2::geometry
