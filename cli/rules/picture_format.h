// SVG or PNG, by the extension of a picture file.
#pragma once

#include <fmt/core.h>

#include <string>

#include "cli/program/usage_error.h"
#include "dsl/picture/canvas.h"
#include "geometry/base/file_extension.h"

namespace af2::cli {

/// option  the option that gives the file, for the UsageError if the extension is neither
inline dsl::PictureFormat pictureFormatOf(const std::string& file, const char* option) {
  const std::string extension = geometry::extensionOf(file);
  if (extension == ".svg") return dsl::PictureFormat::Svg;
  if (extension == ".png") return dsl::PictureFormat::Png;
  throw UsageError(fmt::format("{} '{}' ends in neither .svg nor .png", option, file));
}

}  // namespace af2::cli
