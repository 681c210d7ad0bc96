// One reader for each file format, and the table of them that readModel uses.
// Not installed.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "geometry/base/file_extension.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Each throws InputError or Standard_Failure if the file is damaged. The first two are in
/// geometry/occ/step/ and geometry/occ/iges/, or load these (geometry/occ/loading/).
ReadShape readStep(const std::filesystem::path& path);
ReadShape readIges(const std::filesystem::path& path);
ReadShape readBrep(const std::filesystem::path& path);

/// Whether a file with these first kStartSize bytes is of the format.
bool looksLikeStep(const std::string& start);
bool looksLikeIges(const std::string& start);
bool looksLikeBrep(const std::string& start);
inline constexpr std::size_t kStartSize = 400;

struct CadFormat : FileFormat {
  ReadShape (*read)(const std::filesystem::path&);
  bool (*looksLike)(const std::string& start);
};

/// In the order in which messages list them, and in which the start of a file is tested.
inline constexpr std::array kCadFormats{
    CadFormat{{"STEP", {".step", ".stp", ".p21"}}, &readStep, &looksLikeStep},
    CadFormat{{"IGES", {".iges", ".igs"}}, &readIges, &looksLikeIges},
    CadFormat{{"BREP", {".brep", ".brp", ".rle"}}, &readBrep, &looksLikeBrep},
};

}  // namespace af2::geometry
