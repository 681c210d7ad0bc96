#include "geometry/picture/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace af2::geometry {
namespace {

constexpr double kHiddenStrength = 0.3;

/// Pixels whose centres can lie in a range of coordinates, within an image.
struct PixelRange {
  int first, last;
  PixelRange(double low, double high, int size)
      : first(static_cast<int>(std::clamp(std::floor(low), 0.0, static_cast<double>(size)))),
        last(static_cast<int>(std::clamp(std::ceil(high), -1.0, size - 1.0))) {}
};

Point2 flat(const Point3& p) { return {p.x, p.y}; }

Rgb withLines(const Rgb& color, const std::array<SideLine, 3>& lines,
              const std::array<double, 3>& distances) {
  double strength = 0;
  for (std::size_t side = 0; side < 3; ++side)
    if (distances[side] < lines[side].width) strength = std::max(strength, lines[side].strength);
  return mixed(color, kOutlineColor, strength);
}

/// Where the point of a segment nearest to `p` lies: 0 at `from`, 1 at `to`.
double nearestOn(Point2 p, Point2 from, Point2 to) {
  const Point2 along = to - from;
  const double square = dot(along, along);
  return square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
}

}  // namespace

Raster::Raster(int width, int height)
    : width_(width),
      height_(height),
      colors_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Rgb{1, 1, 1}),
      depths_(colors_.size(), -std::numeric_limits<double>::infinity()) {}

void Raster::triangle(const std::array<Point3, 3>& corners, const Rgb& color,
                      const std::array<SideLine, 3>& lines) {
  const auto& [a, b, c] = corners;
  const double area = cross(flat(b - a), flat(c - a));
  if (area == 0) return;  // seen along its plane
  const std::array lengths{distance(flat(a), flat(b)), distance(flat(b), flat(c)),
                           distance(flat(c), flat(a))};
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  const PixelRange columns(left, right, width_), rows(top, bottom, height_);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      // Areas between the pixel and the sides ab, bc and ca, as parts of the triangle.
      const double ab = cross(flat(b - a), p - flat(a)) / area;
      const double bc = cross(flat(c - b), p - flat(b)) / area;
      const double ca = cross(flat(a - c), p - flat(c)) / area;
      if (ab < 0 || bc < 0 || ca < 0) continue;
      const double depth = bc * a.z + ca * b.z + ab * c.z;
      const std::size_t pixel = indexOf(x, y);
      if (depth <= depths_[pixel]) continue;
      depths_[pixel] = depth;
      const double size = std::abs(area);
      colors_[pixel] = withLines(
          color, lines, {ab * size / lengths[0], bc * size / lengths[1], ca * size / lengths[2]});
    }
  }
}

void Raster::line(const Point3& from, const Point3& to, double width, const Rgb& color) {
  const auto [left, right] = std::minmax(from.x, to.x);
  const auto [top, bottom] = std::minmax(from.y, to.y);
  const PixelRange columns(left - width, right + width, width_);
  const PixelRange rows(top - width, bottom + width, height_);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      const Point3 nearest = from + nearestOn(p, flat(from), flat(to)) * (to - from);
      if (distance(p, flat(nearest)) >= width / 2) continue;
      const std::size_t pixel = indexOf(x, y);
      // Lines lie on surfaces, which are made of triangles only roughly there.
      const bool isHidden = depths_[pixel] > nearest.z + 2 * width;
      colors_[pixel] = mixed(colors_[pixel], color, isHidden ? kHiddenStrength : 1);
    }
  }
}

Raster Raster::halved() const {
  Raster half(width_ / 2, height_ / 2);
  for (int y = 0; y < half.height_; ++y)
    for (int x = 0; x < half.width_; ++x)
      half.colors_[half.indexOf(x, y)] = 0.25 * (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) +
                                                 at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1));
  return half;
}

}  // namespace af2::geometry
