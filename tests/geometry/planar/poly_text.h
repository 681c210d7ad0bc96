// Poly files made of text, for tests.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "engine/base/error.h"
#include "geometry/planar/poly_file.h"

namespace af2::testing {

/// A file in a folder of its own, which is removed with it.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text) {
    const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("af2_" + std::string(test->test_suite_name()) + "_" + test->name());
    std::filesystem::create_directories(folder_);
    path_ = folder_ / name;
    std::ofstream(path_) << text;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path folder_, path_;
};

inline geometry::PlanarDomain polyOf(const std::string& text) {
  return geometry::readPoly(TemporaryFile("test.poly", text).path());
}

/// The message of the InputError that `work` throws, without the folder of the file.
template <class Work>
std::string messageOf(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    const std::string text = error.what();
    const std::size_t file = text.find("test.poly");
    return file == std::string::npos ? text : text.substr(file);
  }
  return "no error";
}

}  // namespace af2::testing
