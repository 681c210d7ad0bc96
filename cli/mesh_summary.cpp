#include "cli/mesh_summary.h"

#include <fmt/core.h>

#include <algorithm>

#include "geometry/fingerprint.h"

namespace af2::cli {
namespace {

using geometry::FaceReport;
using geometry::FaceStatus;

std::string countText(const geometry::ModelMesh& mesh) {
  const auto quads =
      static_cast<std::size_t>(std::ranges::count_if(mesh.elements, &Element::isQuad));
  const auto asked = mesh.faces.size() - static_cast<std::size_t>(std::ranges::count(
                                             mesh.faces, FaceStatus::Skipped, &FaceReport::status));
  const auto done = std::ranges::count(mesh.faces, FaceStatus::Complete, &FaceReport::status);
  std::string text =
      fmt::format("faces {}/{}  {} vertices  {} triangles", done, asked,
                  grouped(mesh.vertices.size()), grouped(mesh.elements.size() - quads));
  if (quads > 0) text += fmt::format("  {} quads", grouped(quads));
  return text;
}

std::string secondsText(const geometry::StageSeconds& seconds) {
  return fmt::format(
      "seconds: read {:.2f}  edges {:.2f}  surface {:.2f}  optimize {:.2f}  write {:.2f}",
      seconds.read, seconds.edges, seconds.surface, seconds.optimize, seconds.write);
}

}  // namespace

std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t place = text.size(); place > 3; place -= 3) text.insert(place - 3, " ");
  return text;
}

std::string summaryText(const geometry::ModelMesh& mesh, const geometry::MeshQuality& quality) {
  return fmt::format(
      "{}\n"
      "quality min {:.3f}  mean {:.3f}  angles {:.1f}-{:.1f} deg  edge/size {:.2f}-{:.2f}  "
      "fingerprint {}\n"
      "{}\n",
      countText(mesh), quality.min, quality.mean, quality.minAngle, quality.maxAngle,
      quality.edges.p5, quality.edges.p95, geometry::fingerprint(mesh), secondsText(mesh.seconds));
}

std::string failureText(const geometry::ModelMesh& mesh) {
  std::string text;
  for (const FaceReport& face : mesh.faces) {
    if (face.status != FaceStatus::Failed) continue;
    const std::string name = face.name.empty() ? "" : fmt::format(" \"{}\"", face.name);
    text += fmt::format("af2: face {}{} ({}) failed: {}\n", face.id, name, face.surfaceType,
                        face.reason);
  }
  return text;
}

}  // namespace af2::cli
