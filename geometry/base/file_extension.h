// What the end of a file's name says of its format.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace af2::geometry {

/// With the dot, in small letters: ".step" of PART.STEP.
inline std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

/// A format that files are read in. The tables of formats have rows that derive from this and add
/// how such a file is read.
struct FileFormat {
  std::string_view name;  ///< as texts call it: "STEP", ".poly"
  /// With the dot, in small letters; those that a format does not need are empty.
  std::array<std::string_view, 3> extensions = {};
};

/// The row of a table of formats to which the extension of a file belongs; null if there is none.
template <class Format>
const Format* formatOf(std::span<const Format> formats, const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  for (const Format& format : formats)
    for (const std::string_view known : format.extensions)
      if (!known.empty() && known == extension) return &format;
  return nullptr;
}

}  // namespace af2::geometry
