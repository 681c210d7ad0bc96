#include "cli/meshing/defect_picture.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>

namespace af2::cli {
namespace {

using dsl::picture::Canvas;
using dsl::picture::Color;
using dsl::picture::color;
using geometry::Defect;
using geometry::DefectKind;

constexpr double kWidth = 900, kHeight = 680, kKeyWidth = 210, kMargin = 24;
constexpr Color kInk = color(0x24292f), kLines = color(0x8c959f), kPaper = color(0xffffff);

Color colorOf(DefectKind kind) {
  // Colours that people with red-green colour blindness can distinguish, too.
  constexpr std::array kColors{0xd55e00u, 0xcc79a7u, 0x9a0000u, 0x7a3db8u, 0x0072b2u,
                               0x56b4e9u, 0x009e73u, 0xe69f00u, 0x1f3fbfu, 0x4b6b1fu,
                               0x8a6d00u, 0x555555u, 0xf02020u};
  static_assert(kColors.size() == static_cast<std::size_t>(DefectKind::Invalid) + 1);
  return color(kColors.at(static_cast<std::size_t>(kind)));
}

/// View from above one corner, z upwards.
Point2 project(const Point3& p) {
  const double turn = 0.6, tilt = 0.5;  // radians
  const double across = std::cos(turn) * p.x - std::sin(turn) * p.y;
  const double away = std::sin(turn) * p.x + std::cos(turn) * p.y;
  return {across, std::sin(tilt) * away + std::cos(tilt) * p.z};
}

using Line = std::vector<Point2>;

class Drawing {
 public:
  Drawing(const geometry::Model& model, const std::vector<Defect>& defects,
          const std::vector<PictureLabel>& labels)
      : model_(model),
        defects_(defects),
        labels_(labels),
        lines_(static_cast<std::size_t>(model.edgeCount()) + 1) {
    for (int edge = 1; edge <= model.edgeCount(); ++edge)
      for (const Point3& point : geometry::pointsAlong(model, edge)) {
        lines_[static_cast<std::size_t>(edge)].push_back(project(point));
        grow(lines_[static_cast<std::size_t>(edge)].back());
      }
    for (const Defect& defect : defects) grow(project(defect.place));
    // Leaves space for the rings.
    const Point2 room = 0.03 * (world_.high - world_.low);
    world_ = {world_.low - room, world_.high + room};
  }

  void draw(Canvas& canvas) const {
    canvas.fillRectangle({0, 0}, {kWidth, kHeight}, 0, kPaper);
    drawKey(canvas);
    const Canvas::View view(canvas, {kKeyWidth + kMargin, kMargin},
                            {kWidth - kMargin, kHeight - kMargin}, world_, 1e30);
    for (const Line& line : lines_) stroke(canvas, line, kLines, 0.8);
    for (const Defect& defect : defects_) mark(canvas, defect);
    for (const PictureLabel& label : labels_)
      canvas.label(label.text, project(label.place), {0, 1}, 0,
                   {.size = 13, .color = kInk, .weight = dsl::picture::Weight::Bold, .halo = true});
  }

 private:
  void grow(Point2 p) {
    if (isEmpty_) world_.low = world_.high = p;
    isEmpty_ = false;
    world_.low = {std::min(world_.low.x, p.x), std::min(world_.low.y, p.y)};
    world_.high = {std::max(world_.high.x, p.x), std::max(world_.high.y, p.y)};
  }

  static void stroke(Canvas& canvas, const Line& line, Color color, double width) {
    for (std::size_t i = 1; i < line.size(); ++i) canvas.line(line[i - 1], line[i], color, width);
  }

  void mark(Canvas& canvas, const Defect& defect) const {
    const Color shade = colorOf(defect.kind);
    if (defect.edge > 0) {
      stroke(canvas, lines_[static_cast<std::size_t>(defect.edge)], shade, 2.4);
    } else if (defect.face > 0 && defect.vertex == 0) {
      for (const int edge : geometry::edgesAround(model_, defect.face))
        stroke(canvas, lines_[static_cast<std::size_t>(edge)], shade, 2.4);
    }
    // Long defects are visible without a ring.
    if (defect.kind == DefectKind::FreeEdge || defect.kind == DefectKind::NonManifoldEdge) return;
    canvas.dot(project(defect.place), 5, dsl::picture::faded(shade, 0.25), shade, 1.6);
  }

  void drawKey(Canvas& canvas) const {
    std::map<DefectKind, int> counts;
    for (const Defect& defect : defects_) ++counts[defect.kind];
    double y = kMargin + 16;
    const std::string head = defects_.empty() ? "no defects found" : "defects";
    canvas.text(head, {kMargin, y},
                {.size = 15, .color = kInk, .weight = dsl::picture::Weight::Bold});
    for (const auto& [kind, count] : counts) {
      y += 24;
      canvas.fillRectangle({kMargin, y - 11}, {kMargin + 14, y + 3}, 3, colorOf(kind));
      canvas.text(fmt::format("{} x {}", count, geometry::toString(kind)), {kMargin + 22, y},
                  {.size = 13, .color = kInk});
    }
    const std::string unit = model_.unit().empty() ? "" : " " + model_.unit();
    canvas.text(
        fmt::format("{} faces, diagonal {:.4g}{}", model_.faceCount(), model_.diagonal(), unit),
        {kMargin, kHeight - kMargin}, {.size = 11, .color = kLines});
  }

  const geometry::Model& model_;
  const std::vector<Defect>& defects_;
  const std::vector<PictureLabel>& labels_;
  std::vector<Line> lines_;  ///< by edge
  Box2 world_;
  bool isEmpty_ = true;
};

}  // namespace

std::string drawDefects(const geometry::Model& model, const std::vector<Defect>& defects,
                        dsl::PictureFormat format, const std::vector<PictureLabel>& labels) {
  const Drawing drawing(model, defects, labels);
  return Canvas::render(format, kWidth, kHeight, [&](Canvas& canvas) { drawing.draw(canvas); });
}

}  // namespace af2::cli
