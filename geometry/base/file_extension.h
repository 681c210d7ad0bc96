// Finds the format of a file by its extension.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace af2::geometry {

/// The extension with the dot, in lower case: ".step" for PART.STEP.
inline std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

/// A format of input files. Each table of formats has a row type that derives from this and adds
/// the function that reads the format.
struct FileFormat {
  std::string_view name;  ///< as shown in messages: "STEP", ".poly"
  /// With the dot, in lower case; unused entries are empty.
  std::array<std::string_view, 3> extensions = {};
};

/// The row of a table of formats that has the extension of the file; null if there is none.
template <class Format>
const Format* formatOf(std::span<const Format> formats, const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  for (const Format& format : formats)
    for (const std::string_view known : format.extensions)
      if (!known.empty() && known == extension) return &format;
  return nullptr;
}

}  // namespace af2::geometry
