#include "dsl/picture/piece_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dsl/picture/piece_scene.h"

namespace af2::dsl {
namespace {

using picture::Anchor;
using picture::Canvas;
using picture::Color;
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
using picture::PieceScene;
using picture::TextStyle;
using picture::Weight;

constexpr double kEdge = 18, kLineHeight = 17;  // pixels

/// The text in lines that are at most `width` pixels wide, broken at blanks.
std::vector<std::string> broken(Canvas& canvas, const std::string& text, const TextStyle& style,
                                double width) {
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || canvas.widthOf(longer, style) <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
    begin = end + 1;
  }
  return lines;
}

/// Returns the height below the text.
double paragraph(Canvas& canvas, const std::string& text, Point2 at, const TextStyle& style,
                 double width) {
  for (const std::string& line : broken(canvas, text, style, width)) {
    canvas.text(line, at, style);
    at.y += kLineHeight;
  }
  return at.y;
}

void drawPieceFront(Canvas& canvas, const PieceScene& scene) {
  for (const auto& [from, to] : scene.edges)
    canvas.band(scene.at[from], scene.at[to], faded(kMeshed, 0.4), 10);
  canvas.fill(scene.zones, faded(kZone, 0.13));
  canvas.stroke(scene.zones, faded(kZone, 0.8), 1.2);
  for (const Loop& element : scene.elements) {
    canvas.fill({element}, faded(kElement, 0.62));
    canvas.stroke({element}, kElementEdge, 1.4);
  }
  for (const auto& edge : scene.edges) {
    const bool isBase = edge == scene.base, isPattern = scene.isInPattern(edge);
    canvas.arrow(scene.at[edge.first], scene.at[edge.second], isPattern ? kInk : kKept,
                 isBase ? 3.4 : 2.2);
  }
  for (const auto& [from, to] : scene.newFront) canvas.arrow(from, to, kNewFront, 2);
}

/// What the rule wanted elsewhere, and what hit its zone.
void drawObstacles(Canvas& canvas, const PieceScene& scene) {
  for (const auto& [wanted, found] : scene.deviations) {
    canvas.line(wanted, found, faded(kTolerance, 0.7), 1.2);
    canvas.dot(wanted, 3.4, kPaper, kTolerance, 1.4);
  }
  if (scene.culprits.size() == 2)
    canvas.arrow(scene.at[scene.culprits[0]], scene.at[scene.culprits[1]], kNewFront, 3.4);
  if (scene.culprits.size() == 1)
    canvas.dot(scene.at[scene.culprits[0]], 10, faded(kNewFront, 0.15), kNewFront, 2.4);
}

void drawPieceVertices(Canvas& canvas, const PieceScene& scene) {
  for (const PieceScene::Vertex& vertex : scene.vertices) {
    const Color ink = vertex.isNew ? kElementEdge : vertex.isCulprit ? kNewFront : kInk;
    canvas.dot(vertex.at, vertex.isMatched ? 5 : 3.4, vertex.isNew ? kPaper : ink,
               vertex.isNew ? kElementEdge : kPaper, vertex.isNew ? 2.4 : 1);
    if (vertex.name.empty()) continue;
    const TextStyle style{13, ink, vertex.isMatched ? Weight::Bold : Weight::Normal, Anchor::Middle,
                          true};
    // Beside a vertex, a name needs space for half of its width.
    const double side = std::abs(vertex.outward.x) / std::max(length(vertex.outward), 1e-9);
    const double apart = 15 + side * std::max(0.0, canvas.widthOf(vertex.name, style) / 2 - 6);
    canvas.label(vertex.name, vertex.at, vertex.outward, apart, style);
  }
}

/// Draws what fits into `width`; the most important entries come first.
void drawPieceKey(Canvas& canvas, const PieceScene& scene, Point2 at, double width) {
  const TextStyle style{11, kMuted};
  const double end = at.x + width;
  const auto entry = [&](double symbol, const std::string& text, const auto& draw) {
    const double needed = symbol + 7 + canvas.widthOf(text, style);
    if (at.x + needed > end) return;
    draw();
    canvas.text(text, {at.x + symbol + 7, at.y + 4}, style);
    at.x += needed + 16;
  };
  const auto arrow = [&](Color stroke, double thick, const std::string& text) {
    entry(26, text, [&] { canvas.arrow(at, at + Point2{26, 0}, stroke, thick); });
  };
  const auto patch = [&](Color fill, Color edge, const std::string& text) {
    entry(15, text, [&] {
      canvas.fillRectangle(at + Point2{0, -6}, at + Point2{15, 6}, 3, fill);
      canvas.strokeRectangle(at + Point2{0, -6}, at + Point2{15, 6}, 3, edge, 1.1);
    });
  };
  arrow(kInk, 3.4, "base edge");
  if (!scene.zones.empty()) patch(faded(kZone, 0.2), faded(kZone, 0.7), "free zone");
  if (!scene.culprits.empty()) patch(faded(kNewFront, 0.15), kNewFront, "hits the zone");
  if (!scene.newFront.empty()) arrow(kNewFront, 2, "new front");
  if (!scene.elements.empty()) patch(faded(kElement, 0.62), kElementEdge, "new element");
  if (!scene.deviations.empty()) patch(kPaper, kTolerance, "reference");
  if (!scene.pattern.empty()) arrow(kInk, 2.2, "pattern");
  if (scene.hasOtherFront()) arrow(kKept, 2.2, "other front");
}

}  // namespace

std::string drawPiece(const RuleSet& rules, const FrontPiece& piece,
                      const std::vector<std::string>& names, const StepExplanation& explained,
                      const PieceCaption& caption, PictureFormat format,
                      const PiecePictureOptions& options) {
  const PieceScene scene = picture::sceneOf(rules, piece, names, explained, caption.rule);
  return Canvas::render(format, options.width, options.height, [&](Canvas& canvas) {
    const double width = options.width - 2 * kEdge;
    double y = paragraph(canvas, caption.title, {kEdge, 28}, {15, kInk, Weight::Bold}, width);
    for (const std::string& line : caption.lines)
      y = paragraph(canvas, line, {kEdge, y + 1}, {12, kMuted}, width);
    const TextStyle reason{12.5, kInk};
    const auto lines = broken(canvas, scene.reason, reason, width);
    const double textTop = options.height - 12 - static_cast<double>(lines.size()) * kLineHeight;
    paragraph(canvas, scene.reason, {kEdge, textTop + 13}, reason, width);
    drawPieceKey(canvas, scene, {kEdge, textTop - 14}, width);
    const Point2 low{kEdge, y - 4}, high{options.width - kEdge, textTop - 30};
    canvas.strokeRectangle(low, high, 8, kFrame, 1);
    const Canvas::View view(canvas, low, high, scene.world, 190);
    drawPieceFront(canvas, scene);
    drawObstacles(canvas, scene);
    if (options.names) drawPieceVertices(canvas, scene);
  });
}

}  // namespace af2::dsl
