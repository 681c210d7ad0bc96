// A picture of a planar mesh in SVG, as text.
// Not installed.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "geometry/mesh/model_mesh.h"
#include "geometry/picture/quality_colors.h"

namespace af2::geometry {

using ElementColor = std::function<Rgb(std::size_t element)>;

/// The colours of .svg files. Valid as long as the mesh.
ElementColor colorByQuality(const ModelMesh& mesh);

/// Without background and legend, 1000 units wide. Stuck places are red. Throws InputError if the
/// mesh is not planar.
std::string svgPicture(const ModelMesh& mesh, const ElementColor& colorOf);

}  // namespace af2::geometry
