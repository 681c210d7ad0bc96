// A picture of a mesh in PNG: seen from a corner, or from above if it is planar; coloured by
// quality.
#include <algorithm>
#include <cmath>

#include "geometry/io/formats.h"
#include "geometry/mesh/quality.h"
#include "geometry/picture/caption.h"
#include "geometry/picture/drawn_mesh.h"
#include "geometry/picture/png_file.h"
#include "geometry/picture/raster.h"

namespace af2::geometry {
namespace {

constexpr int kImageWidth = 1200, kLeastHeight = 300, kMostHeight = 1200, kImageMargin = 30;
constexpr int kPixelsPerPixel = 2;  // along each direction, averaged at the end

/// A parallel projection to pixels: x to the right, y down, z towards the viewer.
struct Camera {
  Point3 right{1, 0, 0}, up{0, 1, 0}, toViewer{0, 0, 1};
  double scale = 1;
  Point2 origin{};  ///< the pixel of the model's origin

  Point3 turned(const Point3& p) const { return {dot(right, p), dot(up, p), dot(toViewer, p)}; }
  Point3 pixel(const Point3& p) const {
    const Point3 t = turned(p);
    return {origin.x + scale * t.x, origin.y - scale * t.y, scale * t.z};
  }
};

Camera directionFor(const DrawnBox& box) {
  if (box.isPlanar()) return {};
  const Point3 toViewer = unit(Point3{0.62, -0.74, 0.55});
  const Point3 right = unit(cross({0, 0, 1}, toViewer));
  return {right, cross(toViewer, right), toViewer};
}

struct Framing {
  Camera camera;
  int height = kLeastHeight;
};

/// The projection that fills the picture, which is as high as the mesh needs.
Framing framingOf(const ModelMesh& mesh) {
  const DrawnBox box = drawnBox(mesh);
  Camera camera = directionFor(box);
  Point3 low = camera.turned(box.low), high = low;
  const auto include = [&](const Point3& p) {
    const Point3 t = camera.turned(p);
    low = {std::min(low.x, t.x), std::min(low.y, t.y), 0};
    high = {std::max(high.x, t.x), std::max(high.y, t.y), 0};
  };
  if (!mesh.vertices.empty()) low = high = camera.turned(mesh.vertices.front());
  for (const Point3& p : mesh.vertices) include(p);
  for (const StuckPlace& place : stuckPlaces(mesh)) {
    include(place.from);
    include(place.to);
  }
  const double width = std::max(high.x - low.x, 1e-300), tall = high.y - low.y;
  const double room = kImageWidth - 2 * kImageMargin;
  const int height = static_cast<int>(
      std::clamp(room * tall / width + 2 * kImageMargin, 1.0 * kLeastHeight, 1.0 * kMostHeight));
  const double scale = std::min(room / width, (height - 2 * kImageMargin) / std::max(tall, 1e-300));
  camera.scale = kPixelsPerPixel * scale;
  camera.origin = {kPixelsPerPixel * kImageWidth / 2.0 - camera.scale * (low.x + high.x) / 2,
                   kPixelsPerPixel * height / 2.0 + camera.scale * (low.y + high.y) / 2};
  return {camera, height};
}

Point3 normalOf(const ModelMesh& mesh, const Element& element) {
  const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i].value]; };
  return element.isQuad() ? cross(at(2) - at(0), at(3) - at(1))
                          : cross(at(1) - at(0), at(2) - at(0));
}

/// Light comes from above the left shoulder of the viewer. Back sides are paler.
Rgb shaded(const Rgb& color, const Point3& normal, const Camera& camera) {
  const double size = length(normal);
  if (size == 0) return color;
  const Point3 n = camera.turned((1 / size) * normal);
  if (n.z < 0) return (0.5 - 0.35 * n.z) * mixed(color, {0.55, 0.55, 0.55}, 0.55);
  const double lit = dot(n, unit(Point3{-0.3, 0.45, 1}));
  return (0.6 + 0.45 * std::max(lit, 0.0)) * color;
}

/// Sides of small elements are fainter: otherwise a fine mesh would be black.
double strengthOfSides(const std::array<Point3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Point2 ab{b.x - a.x, b.y - a.y}, ac{c.x - a.x, c.y - a.y};
  const double size = std::sqrt(std::abs(cross(ab, ac)));
  return 0.7 * std::clamp((size - 3) / 15, 0.0, 1.0);
}

SideLine lineOf(DrawnTriangle::Side side, double strength) {
  if (side == DrawnTriangle::Side::Inside) return {};
  if (side == DrawnTriangle::Side::Outline) return {2.0, std::max(strength, 0.85)};
  return {1.25, strength};
}

void drawElements(const ModelMesh& mesh, const Camera& camera, Raster& raster) {
  const DrawnMesh drawn(mesh);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Rgb color = shaded(qualityColor(shapeQuality(mesh.vertices, mesh.elements[e])),
                             normalOf(mesh, mesh.elements[e]), camera);
    for (const DrawnTriangle& triangle : drawn.trianglesOf(e)) {
      std::array<Point3, 3> corners;
      for (std::size_t i = 0; i < 3; ++i)
        corners[i] = camera.pixel(mesh.vertices[triangle.corners[i].value]);
      const double strength = strengthOfSides(corners);
      const auto& [ab, bc, ca] = triangle.sides;
      raster.triangle(corners, color,
                      {lineOf(ab, strength), lineOf(bc, strength), lineOf(ca, strength)});
    }
  }
}

}  // namespace

void writePng(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  const auto [camera, height] = framingOf(mesh);
  Raster raster(kPixelsPerPixel * kImageWidth, kPixelsPerPixel * height);
  drawElements(mesh, camera, raster);
  for (const StuckPlace& place : stuckPlaces(mesh))
    raster.line(camera.pixel(place.from), camera.pixel(place.to), 3.0 * kPixelsPerPixel,
                kStuckColor);
  file.text(pngWithLegend(raster.halved(), captionOf(mesh)));
}

}  // namespace af2::geometry
