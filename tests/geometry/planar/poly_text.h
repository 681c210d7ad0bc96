// Poly files made of text, for tests.
#pragma once

#include <string>

#include "engine/base/error.h"
#include "geometry/planar/poly_file.h"
#include "tests/support/test_folder.h"

namespace af2::testing {

inline geometry::PlanarDomain polyOf(const std::string& text) {
  return geometry::readPoly(TestFile("test.poly", text).path());
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
