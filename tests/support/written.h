// The bytes of a mesh file.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "geometry/io/mesh_files.h"

namespace af2::testing {

inline std::string written(const geometry::ModelMesh& mesh, std::string_view extension,
                           const geometry::FileOptions& options = {}) {
  namespace fs = std::filesystem;
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path path = fs::path(::testing::TempDir()) / ("af2_" + test + std::string(extension));
  geometry::writeMesh(mesh, path, options);
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  fs::remove(path);
  return text.str();
}

}  // namespace af2::testing
