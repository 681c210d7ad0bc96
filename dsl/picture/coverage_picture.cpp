#include "dsl/picture/coverage_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/elementary.h"

namespace af2::dsl {
namespace {

using picture::Anchor;
using picture::Canvas;
using picture::Color;
using picture::color;
using picture::kFrame;
using picture::kInk;
using picture::kMuted;
using picture::TextStyle;
using picture::Weight;

constexpr Color kNone = color(0xb3261e);
constexpr double kCell = 17, kLeft = 74, kGap = 58, kTop = 96;
/// Situations that are not ordinary are drawn small, because N1 ignores them.
constexpr double kSmallInset = 5;

/// From the first level to late levels.
constexpr std::array kRamp{color(0x2f8f46), color(0x86c06c), color(0xd6e08a), color(0xf6d365),
                           color(0xf0a04b)};

Color blend(Color p, Color q, double t) {
  return {p.red + t * (q.red - p.red), p.green + t * (q.green - p.green),
          p.blue + t * (q.blue - p.blue), 1};
}

Color colorOf(int level, int lastLevel) {
  if (level == CoverageMap::kNone) return kNone;
  const double share = lastLevel > 1 ? af2::logarithm(level) / af2::logarithm(lastLevel) : 0;
  const double place = share * (kRamp.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
  return blend(kRamp[index], kRamp[index + 1], place - static_cast<double>(index));
}

bool isAngle(const std::string& name) { return name.find("angle") != std::string::npos; }

std::string tick(double value, const std::string& name) {
  if (isAngle(name)) return fmt::format("{}\u00b0", static_cast<int>(value));
  return fmt::format("{:.2g}", value);
}

double widthOf(const CoverageMap& map) { return kCell * static_cast<double>(map.xs.size()); }
double heightOf(const CoverageMap& map) { return kCell * static_cast<double>(map.ys.size()); }

void drawCells(Canvas& canvas, const CoverageMap& map, int lastLevel, Point2 low) {
  for (std::size_t y = 0; y < map.ys.size(); ++y)
    for (std::size_t x = 0; x < map.xs.size(); ++x) {
      const int level = map.level(x, y);
      if (level == CoverageMap::kImpossible) continue;
      const Point2 at =
          low + kCell * Point2{static_cast<double>(x), static_cast<double>(map.ys.size() - 1 - y)};
      const double inset = map.isOrdinary[y * map.xs.size() + x] ? 0.6 : kSmallInset;
      canvas.fillRectangle(at + Point2{inset, inset}, at + Point2{kCell - inset, kCell - inset},
                           2.5, colorOf(level, lastLevel));
    }
}

/// About every third value, so that labels do not touch.
void drawTicks(Canvas& canvas, const CoverageMap& map, Point2 low) {
  const double bottom = low.y + heightOf(map);
  const std::size_t step = map.xs.size() > 30 ? 5 : 3;
  for (std::size_t x = step - 1; x < map.xs.size(); x += step)
    canvas.text(tick(map.xs[x], map.xName),
                {low.x + kCell * (static_cast<double>(x) + 0.5), bottom + 14},
                {10, kMuted, Weight::Normal, Anchor::Middle});
  canvas.text(map.xName, {low.x + 0.5 * widthOf(map), bottom + 30},
              {11, kInk, Weight::Normal, Anchor::Middle});
  if (map.yName.empty()) return;
  for (std::size_t y = 2; y < map.ys.size(); y += 3)
    canvas.text(tick(map.ys[y], map.yName),
                {low.x - 7, bottom - kCell * (static_cast<double>(y) + 0.5) + 4},
                {10, kMuted, Weight::Normal, Anchor::Right});
}

void drawMap(Canvas& canvas, const CoverageMap& map, int lastLevel, Point2 low) {
  canvas.text(map.title, low - Point2{0, 12}, {13.5, kInk, Weight::Bold});
  if (!map.yName.empty()) {
    const double width = canvas.widthOf(map.title, {13.5, kInk, Weight::Bold});
    canvas.text("up: " + map.yName, low + Point2{width + 12, -12}, {11, kMuted});
  }
  canvas.strokeRectangle(low - Point2{2, 2}, low + Point2{widthOf(map) + 2, heightOf(map) + 2}, 4,
                         kFrame, 1);
  drawCells(canvas, map, lastLevel, low);
  drawTicks(canvas, map, low);
}

void drawKey(Canvas& canvas, int lastLevel, Point2 at) {
  const TextStyle style{11.5, kMuted};
  const auto entry = [&](Color fill, const std::string& text) {
    canvas.fillRectangle(at + Point2{0, -10}, at + Point2{14, 4}, 2.5, fill);
    canvas.text(text, at + Point2{20, 2}, style);
    at.x += 34 + canvas.widthOf(text, style);
  };
  int last = 0;
  for (const double share : {0.0, 0.3, 0.5, 0.75, 1.0}) {
    const int level = static_cast<int>(std::round(af2::power(lastLevel, share)));
    if (level != last)
      entry(colorOf(level, lastLevel),
            last == 0 ? fmt::format("taken at level {}", level) : std::to_string(level));
    last = level;
  }
  entry(kNone, fmt::format("by no rule up to level {}", lastLevel));
  canvas.fillRectangle(at + Point2{3.5, -6.5}, at + Point2{10.5, 0.5}, 2.5, kMuted);
  canvas.text("small: no front in good order looks like this", at + Point2{20, 2}, style);
}

/// The top left of each map: side by side up to the width of the widest map, then below.
std::vector<Point2> layOut(const Coverage& coverage) {
  constexpr double kSlack = 120;
  double widest = 0;
  for (const CoverageMap& map : coverage.maps) widest = std::max(widest, kLeft + widthOf(map));
  std::vector<Point2> places;
  Point2 at{kLeft, kTop + 10};
  double bottom = at.y;
  for (const CoverageMap& map : coverage.maps) {
    if (at.x > kLeft && at.x + widthOf(map) > widest + kSlack) at = {kLeft, bottom};
    places.push_back(at);
    bottom = std::max(bottom, at.y + heightOf(map) + kGap + 24);
    at.x += widthOf(map) + kLeft;
  }
  return places;
}

}  // namespace

std::string drawCoverage(const Coverage& coverage, const std::string& ruleSet,
                         PictureFormat format) {
  const auto places = layOut(coverage);
  double width = 0, height = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    width = std::max(width, places[i].x + widthOf(coverage.maps[i]) + 26);
    height = std::max(height, places[i].y + heightOf(coverage.maps[i]) + 46);
  }
  return Canvas::render(format, width, height, [&](Canvas& canvas) {
    canvas.text("What " + ruleSet + " covers", {24, 34}, {19, kInk, Weight::Bold});
    drawKey(canvas, coverage.lastLevel, {24, 62});
    for (std::size_t i = 0; i < places.size(); ++i)
      drawMap(canvas, coverage.maps[i], coverage.lastLevel, places[i]);
  });
}

}  // namespace af2::dsl
