#include "cli/inspect/defect_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "geometry/occ/inspect/measures.h"

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

/// The edges of a model as lines, and what all its pictures have.
class ModelLines {
 public:
  explicit ModelLines(const geometry::Model& model)
      : model_(model), lines_(static_cast<std::size_t>(model.edgeCount()) + 1) {
    for (int edge = 1; edge <= model.edgeCount(); ++edge)
      for (const Point3& point : geometry::pointsAlong(model, edge)) {
        lines_[static_cast<std::size_t>(edge)].push_back(project(point));
        grow(lines_[static_cast<std::size_t>(edge)].back());
      }
  }

  const geometry::Model& model() const { return model_; }
  const Line& of(int edge) const { return lines_[static_cast<std::size_t>(edge)]; }

  void grow(Point2 p) {
    if (isEmpty_) world_.low = world_.high = p;
    isEmpty_ = false;
    world_.low = {std::min(world_.low.x, p.x), std::min(world_.low.y, p.y)};
    world_.high = {std::max(world_.high.x, p.x), std::max(world_.high.y, p.y)};
  }

  /// With room for what is drawn around points at the border.
  Box2 world() const {
    const Point2 room = 0.03 * (world_.high - world_.low);
    return {world_.low - room, world_.high + room};
  }

  static void stroke(Canvas& canvas, const Line& line, Color color, double width) {
    for (std::size_t i = 1; i < line.size(); ++i) canvas.line(line[i - 1], line[i], color, width);
  }

  static void drawLabels(Canvas& canvas, const std::vector<PictureLabel>& labels) {
    for (const PictureLabel& label : labels)
      canvas.label(label.text, project(label.place), {0, 1}, 0,
                   {.size = 13, .color = kInk, .weight = dsl::picture::Weight::Bold, .halo = true});
  }

  /// The heading of the legend, rows of colours and texts, and the size of the model.
  void drawKey(Canvas& canvas, const std::string& head,
               const std::vector<std::pair<Color, std::string>>& rows) const {
    double y = kMargin + 16;
    canvas.text(head, {kMargin, y},
                {.size = 15, .color = kInk, .weight = dsl::picture::Weight::Bold});
    for (const auto& [shade, text] : rows) {
      y += 24;
      canvas.fillRectangle({kMargin, y - 11}, {kMargin + 14, y + 3}, 3, shade);
      canvas.text(text, {kMargin + 22, y}, {.size = 13, .color = kInk});
    }
    const std::string unit = model_.unit().empty() ? "" : " " + model_.unit();
    canvas.text(
        fmt::format("{} faces, diagonal {:.4g}{}", model_.faceCount(), model_.diagonal(), unit),
        {kMargin, kHeight - kMargin}, {.size = 11, .color = kLines});
  }

 private:
  const geometry::Model& model_;
  std::vector<Line> lines_;  ///< by edge
  Box2 world_;
  bool isEmpty_ = true;
};

class Drawing {
 public:
  Drawing(const geometry::Model& model, const std::vector<Defect>& defects,
          const std::vector<PictureLabel>& labels)
      : lines_(model), defects_(defects), labels_(labels) {
    for (const Defect& defect : defects) lines_.grow(project(defect.place));
  }

  void draw(Canvas& canvas) const {
    canvas.fillRectangle({0, 0}, {kWidth, kHeight}, 0, kPaper);
    drawKey(canvas);
    const Canvas::View view(canvas, {kKeyWidth + kMargin, kMargin},
                            {kWidth - kMargin, kHeight - kMargin}, lines_.world(), 1e30);
    for (int edge = 1; edge <= lines_.model().edgeCount(); ++edge)
      ModelLines::stroke(canvas, lines_.of(edge), kLines, 0.8);
    for (const Defect& defect : defects_) mark(canvas, defect);
    ModelLines::drawLabels(canvas, labels_);
  }

 private:
  void mark(Canvas& canvas, const Defect& defect) const {
    const Color shade = colorOf(defect.kind);
    if (defect.edge > 0) {
      ModelLines::stroke(canvas, lines_.of(defect.edge), shade, 2.4);
    } else if (defect.face > 0 && defect.vertex == 0) {
      for (const int edge : geometry::edgesAround(lines_.model(), defect.face))
        ModelLines::stroke(canvas, lines_.of(edge), shade, 2.4);
    }
    // Long defects are visible without a ring.
    if (defect.kind == DefectKind::FreeEdge || defect.kind == DefectKind::NonManifoldEdge) return;
    canvas.dot(project(defect.place), 5, dsl::picture::faded(shade, 0.25), shade, 1.6);
  }

  void drawKey(Canvas& canvas) const {
    std::map<DefectKind, int> counts;
    for (const Defect& defect : defects_) ++counts[defect.kind];
    std::vector<std::pair<Color, std::string>> rows;
    for (const auto& [kind, count] : counts)
      rows.emplace_back(colorOf(kind), fmt::format("{} x {}", count, geometry::toString(kind)));
    lines_.drawKey(canvas, defects_.empty() ? "no defects found" : "defects", rows);
  }

  ModelLines lines_;
  const std::vector<Defect>& defects_;
  const std::vector<PictureLabel>& labels_;
};

/// Groups of faces, the largest first.
class MergeDrawing {
 public:
  MergeDrawing(const geometry::Model& model, const geometry::Merging& merging,
               const std::vector<PictureLabel>& labels)
      : lines_(model), groups_(merging.groups), labels_(labels) {
    std::ranges::stable_sort(groups_, std::ranges::greater(),
                             [](const auto& group) { return group.faces.size(); });
    const auto measures = geometry::measuresOfFaces(model);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      for (const std::vector<int>* edges : {&groups_[i].smoothEdges, &groups_[i].narrowEdges})
        for (const int edge : *edges) crossed_[edge] = i;
      for (const int face : groups_[i].faces)
        if (const auto& own = measures[static_cast<std::size_t>(face) - 1])
          dots_.emplace_back(project(own->place), i);
    }
  }

  void draw(Canvas& canvas) const {
    canvas.fillRectangle({0, 0}, {kWidth, kHeight}, 0, kPaper);
    drawKey(canvas);
    const Canvas::View view(canvas, {kKeyWidth + kMargin, kMargin},
                            {kWidth - kMargin, kHeight - kMargin}, lines_.world(), 1e30);
    for (int edge = 1; edge <= lines_.model().edgeCount(); ++edge) {
      const auto group = crossed_.find(edge);
      if (group == crossed_.end())
        ModelLines::stroke(canvas, lines_.of(edge), kInk, 1.4);
      else
        dash(canvas, lines_.of(edge), shadeOf(group->second));
    }
    for (const auto& [place, group] : dots_)
      canvas.dot(place, 3.5, dsl::picture::faded(shadeOf(group), 0.5), shadeOf(group), 1);
    ModelLines::drawLabels(canvas, labels_);
  }

 private:
  static Color shadeOf(std::size_t group) {
    constexpr std::array kShades{0x0072b2u, 0xd55e00u, 0x009e73u, 0xcc79a7u, 0xe69f00u,
                                 0x56b4e9u, 0x7a3db8u, 0x8a6d00u, 0x9a0000u, 0x4b6b1fu};
    return color(kShades.at(group % kShades.size()));
  }

  /// Dashes of the same length in all edges.
  void dash(Canvas& canvas, const Line& line, Color shade) const {
    const Box2 world = lines_.world();
    const double period = 0.012 * distance(world.low, world.high);
    double along = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double length = distance(line[i - 1], line[i]);
      for (double at = 0; at < length;) {
        const double left = period / 2 - std::fmod(along + at, period / 2);
        const double end = std::min(at + std::max(left, 1e-3 * period), length);
        const bool isDash = std::fmod(along + (at + end) / 2, period) < period / 2;
        const auto placeAt = [&](double t) {
          return line[i - 1] + (t / length) * (line[i] - line[i - 1]);
        };
        if (isDash) canvas.line(placeAt(at), placeAt(end), shade, 0.9);
        at = end;
      }
      along += length;
    }
  }

  void drawKey(Canvas& canvas) const {
    constexpr std::size_t kMaxRows = 20;
    std::vector<std::pair<Color, std::string>> rows;
    for (std::size_t i = 0; i < std::min(groups_.size(), kMaxRows); ++i)
      rows.emplace_back(shadeOf(i),
                        fmt::format("{} faces, without {} edges", groups_[i].faces.size(),
                                    groups_[i].smoothEdges.size() + groups_[i].narrowEdges.size()));
    if (groups_.size() > kMaxRows)
      rows.emplace_back(kPaper, fmt::format("and {} more groups", groups_.size() - kMaxRows));
    lines_.drawKey(canvas, groups_.empty() ? "nothing to merge" : "merged faces", rows);
  }

  ModelLines lines_;
  std::vector<geometry::MergedGroup> groups_;
  const std::vector<PictureLabel>& labels_;
  std::map<int, std::size_t> crossed_;  // edges, and their groups
  std::vector<std::pair<Point2, std::size_t>> dots_;
};

}  // namespace

std::string drawDefects(const geometry::Model& model, const std::vector<Defect>& defects,
                        dsl::PictureFormat format, const std::vector<PictureLabel>& labels) {
  const Drawing drawing(model, defects, labels);
  return Canvas::render(format, kWidth, kHeight, [&](Canvas& canvas) { drawing.draw(canvas); });
}

std::string drawMerging(const geometry::Model& model, const geometry::Merging& merging,
                        dsl::PictureFormat format, const std::vector<PictureLabel>& labels) {
  const MergeDrawing drawing(model, merging, labels);
  return Canvas::render(format, kWidth, kHeight, [&](Canvas& canvas) { drawing.draw(canvas); });
}

}  // namespace af2::cli
