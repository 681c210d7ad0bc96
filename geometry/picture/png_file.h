// The bytes of a PNG file: an image with a legend of the quality below it. Only this unit of
// geometry uses Cairo. Not installed.
#pragma once

#include <string>

#include "geometry/picture/raster.h"

namespace af2::geometry {

/// caption  a line of text beside the legend
std::string pngWithLegend(const Raster& image, const std::string& caption);

}  // namespace af2::geometry
