#include "geometry/faceted/polygon_triangles.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "engine/base/predicates.h"
#include "geometry/base/plane_axes.h"

namespace af2::geometry {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The mean normal times twice the area.
Point3 normalOf(std::span<const Point3> vertices, std::span<const std::uint32_t> corners) {
  const Point3& origin = vertices[corners[0]];
  Point3 sum;
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum = sum + cross(vertices[corners[i - 1]] - origin, vertices[corners[i]] - origin);
  return sum;
}

/// Cuts off one corner after the other.
class EarClipping {
 public:
  explicit EarClipping(std::vector<Point2> corners) : corners_(std::move(corners)) {
    left_.resize(corners_.size());
    std::iota(left_.begin(), left_.end(), 0u);
  }

  /// Indices of corners; nothing if the polygon crosses itself.
  std::optional<std::vector<Triangle>> run() {
    std::vector<Triangle> triangles;
    while (left_.size() > 3) {
      const std::optional<std::size_t> ear = firstEar();
      if (!ear) return std::nullopt;
      triangles.push_back(triangleAt(*ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(*ear));
    }
    triangles.push_back(triangleAt(1));
    return triangles;
  }

 private:
  Triangle triangleAt(std::size_t i) const {
    const std::size_t n = left_.size();
    return {left_[(i + n - 1) % n], left_[i], left_[(i + 1) % n]};
  }

  std::optional<std::size_t> firstEar() const {
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (isEar(triangleAt(i))) return i;
    return std::nullopt;
  }

  bool isEar(const Triangle& t) const {
    const Point2 a = corners_[t[0]], b = corners_[t[1]], c = corners_[t[2]];
    if (orientation(a, b, c) != Turn::Left) return false;
    return std::ranges::none_of(left_, [&](std::uint32_t k) {
      const Point2 p = corners_[k];
      if (k == t[0] || k == t[1] || k == t[2] || p == a || p == b || p == c) return false;
      return orientation(a, b, p) != Turn::Right && orientation(b, c, p) != Turn::Right &&
             orientation(c, a, p) != Turn::Right;
    });
  }

  std::vector<Point2> corners_;
  std::vector<std::uint32_t> left_;
};

std::vector<Triangle> fan(std::size_t count) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

std::vector<Triangle> dividedInPlane(const std::vector<Point2>& corners) {
  std::vector<Triangle> triangles = fan(corners.size());
  const bool fits = std::ranges::all_of(triangles, [&](const Triangle& t) {
    return orientation(corners[t[0]], corners[t[1]], corners[t[2]]) == Turn::Left;
  });
  if (fits) return triangles;
  return EarClipping(corners).run().value_or(std::move(triangles));
}

}  // namespace

std::vector<Triangle> trianglesOfPolygon(std::span<const Point3> vertices,
                                         std::span<const std::uint32_t> corners) {
  const Point3 normal = normalOf(vertices, corners);
  std::vector<Triangle> triangles;
  if (corners.size() == 3 || !(length(normal) > 0)) {
    triangles = fan(corners.size());
  } else {
    const PlaneAxes axes(vertices[corners[0]], unit(normal));
    std::vector<Point2> inPlane;
    for (const std::uint32_t c : corners) inPlane.push_back(axes(SurfacePoint{vertices[c], {}}));
    triangles = dividedInPlane(inPlane);
  }
  for (Triangle& triangle : triangles)
    for (std::uint32_t& corner : triangle) corner = corners[corner];
  return triangles;
}

}  // namespace af2::geometry
