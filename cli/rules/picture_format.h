// SVG or PNG, as the name of a picture file says.
#pragma once

#include <fmt/core.h>

#include <string>

#include "cli/program/usage_error.h"
#include "dsl/picture/canvas.h"
#include "geometry/base/file_extension.h"

namespace af2::cli {

/// option  that names the file, for the UsageError if its name says neither
inline dsl::PictureFormat pictureFormatOf(const std::string& file, const char* option) {
  const std::string extension = geometry::extensionOf(file);
  if (extension == ".svg") return dsl::PictureFormat::Svg;
  if (extension == ".png") return dsl::PictureFormat::Png;
  throw UsageError(fmt::format("{} '{}' ends in neither .svg nor .png", option, file));
}

}  // namespace af2::cli
