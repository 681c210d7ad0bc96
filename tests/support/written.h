// The bytes of a mesh file.
#pragma once

#include <string>

#include "geometry/base/words.h"
#include "geometry/io/mesh_files.h"
#include "tests/support/test_folder.h"

namespace af2::testing {

inline std::string written(const geometry::ModelMesh& mesh, std::string_view extension,
                           const geometry::FileOptions& options = {}) {
  const TestFile file("mesh" + std::string(extension));
  geometry::writeMesh(mesh, file.path(), options);
  return geometry::contentOf(file.path());
}

}  // namespace af2::testing
