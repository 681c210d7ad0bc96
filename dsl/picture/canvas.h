// Drawing in coordinates of a chart: y up, unit the target size. Only canvas.cpp uses Cairo.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

enum class PictureFormat { Svg, Png };

namespace picture {

struct Color {
  double red = 0, green = 0, blue = 0, alpha = 1;
};

/// 0xrrggbb as in style sheets.
constexpr Color color(unsigned rgb, double alpha = 1) {
  return {((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0, alpha};
}

/// Colours of text and outlines, of secondary text, and of the frames of pictures.
inline constexpr Color kInk = color(0x1f2933), kMuted = color(0x6b7785), kFrame = color(0xdde3ea);
/// Colours of what rules are made of.
inline constexpr Color kPaper = color(0xffffff), kZone = color(0x3b82d6);
inline constexpr Color kElement = color(0x9fd8a4), kElementEdge = color(0x2f8f46);
inline constexpr Color kNewFront = color(0xd6382e), kTolerance = color(0xb97a10);
inline constexpr Color kKept = color(0x8c97a5), kMeshed = color(0x9aa5b1);

constexpr Color faded(Color color, double alpha) {
  color.alpha = alpha;
  return color;
}

enum class Weight { Normal, Bold };
enum class Anchor { Left, Middle, Right };

struct TextStyle {
  double size = 12;
  Color color;
  Weight weight = Weight::Normal;
  Anchor anchor = Anchor::Left;
  bool halo = false;  ///< a white edge around the letters, for text on lines
};

using Loop = std::vector<Point2>;

/// A drawing surface. Positions are in pixels from the top left, or, once a view is set, in the
/// chart; widths and sizes are always in pixels.
class AF2_EXPORT Canvas {
 public:
  /// Draws and returns the bytes of the file. The same drawing gives the same bytes.
  static std::string render(PictureFormat format, double width, double height,
                            const std::function<void(Canvas&)>& draw);

  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void fillRectangle(Point2 low, Point2 high, double radius, Color fill);
  void strokeRectangle(Point2 low, Point2 high, double radius, Color stroke, double width);
  /// `at` is the start, middle or end of the baseline of the text, depending on the anchor.
  void text(const std::string& text, Point2 at, const TextStyle& style);
  double widthOf(const std::string& text, const TextStyle& style);

  /// Until the end of the scope, points are in the chart. `world` fits into the pixel box, centred,
  /// with at most `largestScale` pixels per unit, and nothing is drawn outside.
  class View {
   public:
    View(Canvas& canvas, Point2 low, Point2 high, const Box2& world, double largestScale);
    ~View();
    View(const View&) = delete;
    View& operator=(const View&) = delete;

   private:
    Canvas& canvas_;
  };

  void fill(const std::vector<Loop>& loops, Color color);
  void stroke(const std::vector<Loop>& loops, Color color, double width, bool dashed = false);
  void line(Point2 from, Point2 to, Color color, double width);
  void arrow(Point2 from, Point2 to, Color color, double width);
  /// A soft band along the right side of an edge, `width` pixels wide.
  void band(Point2 from, Point2 to, Color color, double width);
  void dot(Point2 at, double radius, Color fill, Color edge, double edgeWidth);
  void cross(Point2 at, double radius, Color color, double width);
  /// Text with its centre `distance` pixels from `at` in the given direction.
  void label(const std::string& text, Point2 at, Point2 direction, double distance,
             const TextStyle& style);

 private:
  struct Surface;
  explicit Canvas(Surface& surface) : surface_(surface) {}
  Point2 pixel(Point2 p) const;
  void path(const std::vector<Loop>& loops);

  Surface& surface_;
};

}  // namespace picture
}  // namespace af2::dsl
