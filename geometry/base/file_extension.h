// What the end of a file's name says of its kind.
#pragma once

#include <filesystem>
#include <string>

namespace af2::geometry {

/// With the dot, in small letters: ".step" of PART.STEP.
inline std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

}  // namespace af2::geometry
