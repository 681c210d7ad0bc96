// One reader for each file format; readModel picks among them.
#pragma once

#include <filesystem>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Each throws InputError or Standard_Failure if the file is damaged.
ReadShape readStep(const std::filesystem::path& path);
ReadShape readIges(const std::filesystem::path& path);
ReadShape readBrep(const std::filesystem::path& path);

}  // namespace af2::geometry
