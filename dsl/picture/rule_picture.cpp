#include "dsl/picture/rule_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dsl/match/pattern_match.h"
#include "dsl/picture/rule_scene.h"

namespace af2::dsl {
namespace {

using picture::Anchor;
using picture::Canvas;
using picture::Color;
using picture::color;
using picture::faded;
using picture::kElement;
using picture::kElementEdge;
using picture::kFrame;
using picture::kInk;
using picture::kKept;
using picture::kMeshed;
using picture::kMuted;
using picture::kNewFront;
using picture::kPaper;
using picture::kTolerance;
using picture::kZone;
using picture::Loop;
using picture::Scene;
using picture::TextStyle;
using picture::Weight;

constexpr double kTitleHeight = 44, kFooterHeight = 26, kMargin = 26, kLargestScale = 150;

// --- the chart

void drawZones(Canvas& canvas, const Scene& scene) {
  const double steps = static_cast<double>(scene.zones.size());
  for (std::size_t i = 0; i < scene.zones.size(); ++i) {
    const double depth = (static_cast<double>(i) + 1) / steps;
    canvas.fill(scene.zones[i].loops, faded(kZone, 0.13));
    canvas.stroke(scene.zones[i].loops, faded(kZone, 0.35 + 0.5 * depth), 1.1);
  }
}

bool isPlaced(const Scene& scene, const RuleElement& element) {
  return std::all_of(element.corners.begin(), element.corners.begin() + element.size(),
                     [&](int corner) { return corner < static_cast<int>(scene.placed.size()); });
}

void drawElements(Canvas& canvas, const Scene& scene) {
  for (const RuleElement& element : scene.rule.definition().elements) {
    if (!isPlaced(scene, element)) continue;
    const Loop corners = cornersOf(element, scene.placed);
    canvas.fill({corners}, faded(kElement, 0.62));
    canvas.stroke({corners}, kElementEdge, 1.4);
  }
}

bool isAmong(const PatternEdge& edge, const std::vector<PatternEdge>& edges) {
  return std::any_of(edges.begin(), edges.end(),
                     [&](const PatternEdge& e) { return e.from == edge.from && e.to == edge.to; });
}

void drawFront(Canvas& canvas, const Scene& scene) {
  const AF2Rule& rule = scene.rule;
  const auto at = [&](int vertex) { return scene.placed[vertex]; };
  for (const PatternEdge& edge : rule.definition().edges) {
    const bool isConsumed = isAmong(edge, rule.consumedEdges());
    const bool isBase = edge.from == 0 && edge.to == 1;
    canvas.arrow(at(edge.from), at(edge.to), isConsumed ? kInk : kKept, isBase ? 3.2 : 2.2);
  }
  for (const PatternEdge& edge : rule.newEdges())
    if (std::max(edge.from, edge.to) < static_cast<int>(scene.placed.size()))
      canvas.arrow(at(edge.from), at(edge.to), kNewFront, 2);
}

/// The direction away from the neighbors, so that names are beside lines, not on them.
Point2 labelDirection(const Scene& scene, std::size_t vertex) {
  Point2 sum{};
  for (const RuleElement& element : scene.rule.definition().elements) {
    if (!isPlaced(scene, element)) continue;
    const Loop corners = cornersOf(element, scene.placed);
    const auto self = std::find(corners.begin(), corners.end(), scene.placed[vertex]);
    if (self == corners.end()) continue;
    for (const Point2 corner : corners) {
      const Point2 away = scene.placed[vertex] - corner;
      if (length(away) > 0) sum = sum + (1 / length(away)) * away;
    }
  }
  if (length(sum) < 0.05) {
    Point2 centre{};
    for (const Point2 p : scene.placed) centre = centre + p;
    sum = scene.placed[vertex] - (1.0 / static_cast<double>(scene.placed.size())) * centre;
  }
  return sum;
}

void drawVertices(Canvas& canvas, const Scene& scene, bool names) {
  const RuleDefinition& definition = scene.rule.definition();
  const std::size_t matched = definition.vertices.size();
  for (std::size_t i = 0; i < scene.placed.size(); ++i) {
    const bool isNew = i >= matched;
    canvas.dot(scene.placed[i], isNew ? 4.6 : 4, isNew ? kPaper : kInk,
               isNew ? kElementEdge : kPaper, isNew ? 2.4 : 1);
    if (!names) continue;
    const std::string& name =
        isNew ? definition.newVertexNames[i - matched] : definition.vertices[i].name;
    const TextStyle style{14, isNew ? kElementEdge : kInk, Weight::Bold, Anchor::Middle, true};
    canvas.label(name, scene.placed[i], labelDirection(scene, i), 15, style);
  }
}

void drawChart(Canvas& canvas, const Scene& scene, bool names) {
  for (const PatternEdge& edge : scene.rule.definition().edges)
    canvas.band(scene.placed[edge.from], scene.placed[edge.to], faded(kMeshed, 0.4), 11);
  drawZones(canvas, scene);
  for (const Loop& loop : scene.tolerances)
    canvas.stroke({loop}, faded(kTolerance, 0.8), 1.1, true);
  drawElements(canvas, scene);
  drawFront(canvas, scene);
  for (std::size_t i = 2; i < scene.references.size(); ++i) {
    if (scene.references[i] == scene.placed[i]) continue;
    canvas.line(scene.references[i], scene.placed[i], faded(kTolerance, 0.6), 1);
    canvas.dot(scene.references[i], 2.5, kPaper, kTolerance, 1.2);
  }
  for (const Loop& path : scene.paths)
    for (std::size_t i = 1; i < path.size(); ++i) {
      canvas.line(path[i - 1], path[i], faded(kTolerance, 0.6), 1);
      canvas.dot(path[i], 2.5, kPaper, kTolerance, 1.2);
    }
  drawVertices(canvas, scene, names);
  for (const Point2 mark : scene.marks) canvas.cross(mark, 6, kNewFront, 2.6);
}

// --- panels and sheets

void drawLevels(Canvas& canvas, const Scene& scene, Point2 at, double right) {
  const TextStyle style{10.5, kMuted};
  if (!scene.note.empty()) {
    canvas.text(scene.note, at, {11, kNewFront});
    at.x += canvas.widthOf(scene.note, {11, kNewFront}) + 16;
  }
  if (scene.zones.size() < 2 || at.x > right - 120) return;
  canvas.text("zone at q", at, style);
  at.x += canvas.widthOf("zone at q", style) + 8;
  for (std::size_t i = 0; i < scene.zones.size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k)
      canvas.fillRectangle({at.x, at.y - 9}, {at.x + 12, at.y + 1}, 2, faded(kZone, 0.17));
    canvas.strokeRectangle({at.x, at.y - 9}, {at.x + 12, at.y + 1}, 2, faded(kZone, 0.6), 0.8);
    const std::string text = std::to_string(scene.zones[i].level);
    canvas.text(text, {at.x + 16, at.y}, style);
    at.x += 26 + canvas.widthOf(text, style);
  }
}

void drawPanel(Canvas& canvas, const Scene& scene, Point2 low, Point2 high, bool names) {
  canvas.strokeRectangle(low + Point2{0.5, 0.5}, high - Point2{0.5, 0.5}, 8, kFrame, 1);
  canvas.text(scene.title, low + Point2{14, 24}, {14.5, kInk, Weight::Bold});
  canvas.text(scene.subtitle, low + Point2{14, 40}, {10.5, kMuted});
  drawLevels(canvas, scene, {low.x + 14, high.y - 12}, high.x);

  // The margin leaves space for names beyond the outermost vertices.
  Box2 world = worldOf(scene);
  const Point2 size = high - low - Point2{2 * kMargin, kTitleHeight + kFooterHeight + kMargin};
  const Point2 extent = world.high - world.low;
  const double scale = std::min({kLargestScale, size.x / extent.x, size.y / extent.y});
  const double pixels = (kMargin - 8) / scale;
  world = {world.low - Point2{pixels, pixels}, world.high + Point2{pixels, pixels}};
  const Canvas::View view(canvas, low + Point2{4, kTitleHeight}, high - Point2{4, kFooterHeight},
                          world, scale);
  drawChart(canvas, scene, names);
}

void drawKey(Canvas& canvas, Point2 at) {
  const TextStyle style{11.5, kMuted};
  const auto word = [&](const std::string& text) {
    canvas.text(text, {at.x, at.y + 4}, style);
    at.x += canvas.widthOf(text, style) + 22;
  };
  const auto arrow = [&](Color stroke, double width, const std::string& text) {
    canvas.arrow(at, at + Point2{34, 0}, stroke, width);
    at.x += 42;
    word(text);
  };
  const auto patch = [&](Color fill, Color edge, const std::string& text) {
    canvas.fillRectangle(at + Point2{0, -6}, at + Point2{16, 6}, 3, fill);
    canvas.strokeRectangle(at + Point2{0, -6}, at + Point2{16, 6}, 3, edge, 1.1);
    at.x += 23;
    word(text);
  };
  arrow(kInk, 2.4, "front, consumed");
  arrow(kKept, 2.2, "front, kept");
  arrow(kNewFront, 2, "new front");
  patch(faded(kElement, 0.62), kElementEdge, "new element");
  patch(faded(kZone, 0.2), faded(kZone, 0.7), "free zone");
  patch(faded(kTolerance, 0.08), kTolerance, "tolerance");
}

std::string drawScene(const Scene& scene, PictureFormat format, const PictureOptions& options) {
  return Canvas::render(format, options.width, options.height, [&](Canvas& canvas) {
    drawPanel(canvas, scene, {6, 6}, {options.width - 6, options.height - 6}, options.names);
  });
}

}  // namespace

std::string drawRule(const RuleSet& rules, const AF2Rule& rule, PictureFormat format,
                     const PictureOptions& options) {
  return drawScene(picture::sceneAtReference(rules, rule, options), format, options);
}

std::string drawMatch(const RuleSet& rules, const AF2Rule& rule, const DrawnMatch& match,
                      PictureFormat format, const PictureOptions& options) {
  return drawScene(picture::sceneAt(rules, rule, match, options), format, options);
}

std::string drawRuleSet(const RuleSet& rules, PictureFormat format, const PictureOptions& options) {
  constexpr double kGap = 12, kHeader = 76, kNarrowest = 820;
  const int count = static_cast<int>(rules.rules().size());
  const int columns = std::clamp(static_cast<int>(std::ceil(std::sqrt(1.3 * count))), 1, 6);
  const int rows = (count + columns - 1) / columns;
  const double width =
      std::max(kNarrowest, 2 * kGap + columns * options.width + (columns - 1) * kGap);
  const double height = kHeader + rows * (options.height + kGap);
  return Canvas::render(format, width, height, [&](Canvas& canvas) {
    canvas.text(rules.name(), {kGap + 2, 34}, {21, kInk, Weight::Bold});
    const std::string number = fmt::format("{} rules", count);
    canvas.text(number, {width - kGap - 2, 34}, {12, kMuted, Weight::Normal, Anchor::Right});
    drawKey(canvas, {kGap + 2, 56});
    for (int i = 0; i < count; ++i) {
      const Point2 low{kGap + (i % columns) * (options.width + kGap),
                       kHeader + (i / columns) * (options.height + kGap)};
      const Scene scene = picture::sceneAtReference(rules, rules.rules()[i], options);
      drawPanel(canvas, scene, low, low + Point2{options.width, options.height}, options.names);
    }
  });
}

}  // namespace af2::dsl
