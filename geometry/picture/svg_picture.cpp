#include "geometry/picture/svg_picture.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>

#include "engine/base/error.h"
#include "geometry/io/formats.h"
#include "geometry/mesh/quality.h"
#include "geometry/picture/caption.h"
#include "geometry/picture/drawn_mesh.h"
#include "geometry/picture/quality_colors.h"

namespace af2::geometry {
namespace {

constexpr double kSvgWidth = 1000, kSvgMostHeight = 1000, kSvgMargin = 20, kSvgLegendHeight = 44;
constexpr double kSvgBarLeft = 92, kSvgBarWidth = 200;
constexpr double kFileLineWidth = 0.5;
constexpr double kPageLineWidth = 1.2;  ///< a page shows the picture at about half of its size

/// Takes what an OutputFile takes, and keeps it in memory.
class TextOutput {
 public:
  void text(std::string_view bytes) { text_ += bytes; }
  void number(double value) { digits(value); }
  void number(std::integral auto value) { digits(static_cast<long long>(value)); }
  std::string take() { return std::move(text_); }

 private:
  void digits(auto value) {
    char room[32];
    text_.append(room, std::to_chars(room, room + sizeof room, value).ptr);
  }
  std::string text_;
};

/// From the model to the picture, in which y points down.
struct Plan {
  double scale = 1, left = 0, top = 0, height = 2 * kSvgMargin;

  explicit Plan(const DrawnBox& box) {
    const double width = box.high.x - box.low.x, tall = box.high.y - box.low.y;
    const double room = kSvgWidth - 2 * kSvgMargin;
    if (width > 0 || tall > 0)
      scale = std::min(room / std::max(width, 1e-300),
                       (kSvgMostHeight - 2 * kSvgMargin) / std::max(tall, 1e-300));
    height += scale * tall;
    left = kSvgMargin + (room - scale * width) / 2 - scale * box.low.x;
    top = kSvgMargin + scale * box.high.y;
  }
  /// Rounded to a hundredth of a pixel, which saves half of the file.
  Point2 at(const Point3& p) const {
    const auto rounded = [](double x) { return std::round(100 * x) / 100; };
    return {rounded(left + scale * p.x), rounded(top - scale * p.y)};
  }
};

void writePoint(Point2 p, auto& file) {
  file.number(p.x);
  file.text(" ");
  file.number(p.y);
}

void writeSegment(Point2 from, Point2 to, auto& file) {
  file.text("M");
  writePoint(from, file);
  file.text("L");
  writePoint(to, file);
}

void writeHead(double height, auto& file) {
  file.text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000\" height=\"");
  file.number(std::ceil(height));
  file.text("\" viewBox=\"0 0 1000 ");
  file.number(std::ceil(height));
  file.text("\">\n<title>Mesh by AF2</title>\n");
}

void writeQualityScale(auto& file) {
  file.text("<defs><linearGradient id=\"quality\">");
  for (std::size_t i = 0; i < kQualityColors.size(); ++i) {
    file.text("<stop offset=\"");
    file.number(static_cast<double>(i) / static_cast<double>(kQualityColors.size() - 1));
    file.text("\" stop-color=\"" + hexOf(kQualityColors[i]) + "\"/>");
  }
  file.text("</linearGradient></defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
}

void writeElements(const ModelMesh& mesh, const DrawnMesh& drawn, const Plan& plan,
                   const ElementColor& colorOf, double lineWidth, auto& file) {
  file.text("<g stroke=\"" + hexOf(kOutlineColor) + "\" stroke-width=\"");
  file.number(lineWidth);
  file.text("\" stroke-linejoin=\"round\">\n");
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const char* command = "<path d=\"M";
    for (const DrawnSide& side : drawn.sidesOf(e)) {
      file.text(command);
      writePoint(plan.at(mesh.vertices[side.from.value]), file);
      command = "L";
    }
    file.text("Z\" fill=\"" + hexOf(colorOf(e)) + "\"/>\n");
  }
  file.text("</g>\n");
}

void writeOutlines(const ModelMesh& mesh, const DrawnMesh& drawn, const Plan& plan, auto& file) {
  file.text("<path fill=\"none\" stroke=\"" + hexOf(kOutlineColor) +
            "\" stroke-width=\"1.6\" stroke-linecap=\"round\" d=\"");
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const DrawnSide& side : drawn.sidesOf(e))
      if (side.isOutline)
        writeSegment(plan.at(mesh.vertices[side.from.value]), plan.at(mesh.vertices[side.to.value]),
                     file);
  file.text("\"/>\n<path fill=\"none\" stroke=\"" + hexOf(kStuckColor) +
            "\" stroke-width=\"3\" stroke-linecap=\"round\" d=\"");
  for (const StuckPlace& place : stuckPlaces(mesh))
    writeSegment(plan.at(place.from), plan.at(place.to), file);
  file.text("\"/>\n");
}

void writeText(const std::string& text, double x, double y, auto& file) {
  file.text("<text x=\"");
  file.number(x);
  file.text("\" y=\"");
  file.number(y);
  file.text("\">" + text + "</text>");
}

void writeLegend(const ModelMesh& mesh, double top, auto& file) {
  const double baseline = std::ceil(top) + 20;
  file.text("<g font-family=\"DejaVu Sans, sans-serif\" font-size=\"14\" fill=\"#1f2933\">");
  writeText("Quality 0", kSvgMargin, baseline, file);
  file.text("<rect fill=\"url(#quality)\" x=\"");
  file.number(kSvgBarLeft);
  file.text("\" y=\"");
  file.number(baseline - 12);
  file.text("\" width=\"");
  file.number(kSvgBarWidth);
  file.text("\" height=\"14\"/>");
  writeText("1", kSvgBarLeft + kSvgBarWidth + 6, baseline, file);
  writeText(captionOf(mesh), kSvgBarLeft + kSvgBarWidth + 50, baseline, file);
  file.text("</g>\n</svg>\n");
}

/// Throws InputError if there is none.
Plan planOf(const ModelMesh& mesh) {
  const DrawnBox box = drawnBox(mesh);
  if (!box.isPlanar())
    throw InputError(
        "an .svg file shows planar meshes only, in a plane of constant z; use .png or .html");
  return Plan(box);
}

}  // namespace

ElementColor colorByQuality(const ModelMesh& mesh) {
  return [&mesh](std::size_t e) {
    return qualityColor(shapeQuality(mesh.vertices, mesh.elements[e]));
  };
}

std::string svgPicture(const ModelMesh& mesh, const ElementColor& colorOf) {
  const Plan plan = planOf(mesh);
  const DrawnMesh drawn(mesh);
  TextOutput out;
  writeHead(plan.height, out);
  writeElements(mesh, drawn, plan, colorOf, kPageLineWidth, out);
  writeOutlines(mesh, drawn, plan, out);
  out.text("</svg>\n");
  return out.take();
}

void writeSvg(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  const Plan plan = planOf(mesh);
  const DrawnMesh drawn(mesh);
  writeHead(plan.height + kSvgLegendHeight, file);
  writeQualityScale(file);
  writeElements(mesh, drawn, plan, colorByQuality(mesh), kFileLineWidth, file);
  writeOutlines(mesh, drawn, plan, file);
  writeLegend(mesh, plan.height, file);
}

}  // namespace af2::geometry
