#include "geometry/picture/caption.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/quality.h"

namespace af2::geometry {
namespace {

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// With two digits behind the point.
std::string shortNumber(double value) {
  const std::string text = std::to_string(std::floor(100 * value + 0.5) / 100);
  return text.substr(0, text.find('.') + 3);
}

}  // namespace

std::string captionOf(const ModelMesh& mesh) {
  std::string caption = counted(mesh.elements.size(), "element");
  double lowest = 1;
  for (const Element& element : mesh.elements)
    lowest = std::min(lowest, shapeQuality(mesh.vertices, element));
  if (!mesh.elements.empty()) caption += ", lowest quality " + shortNumber(lowest);
  const auto failed = failedFaces(mesh);
  if (failed > 0) caption += ", " + counted(failed, "face") + " failed";
  return caption;
}

}  // namespace af2::geometry
