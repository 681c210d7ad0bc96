// An image that is drawn without a display: shaded triangles with their sides, nearer ones in
// front. Not installed.
#pragma once

#include <array>
#include <vector>

#include "engine/base/point.h"
#include "geometry/picture/quality_colors.h"

namespace af2::geometry {

/// A line along a side, drawn inside the triangle.
struct SideLine {
  double width = 0;     ///< in pixels; 0: not drawn
  double strength = 0;  ///< 0: invisible, 1: covers the colour of the triangle
};

class Raster {
 public:
  /// White.
  Raster(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  const Rgb& at(int x, int y) const { return colors_[indexOf(x, y)]; }

  /// corners  x to the right and y down in pixels, z towards the viewer
  /// lines    by side, [0] between corners 0 and 1
  void triangle(const std::array<Point3, 3>& corners, const Rgb& color,
                const std::array<SideLine, 3>& lines);
  /// Faint where triangles hide it.
  void line(const Point3& from, const Point3& to, double width, const Rgb& color);

  /// Half as wide and as high; each pixel is the mean of four.
  Raster halved() const;

 private:
  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<Rgb> colors_;
  std::vector<double> depths_;
};

}  // namespace af2::geometry
