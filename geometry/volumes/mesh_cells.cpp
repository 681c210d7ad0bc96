#include "geometry/volumes/mesh_cells.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "engine/base/elementary.h"
#include "geometry/base/box_tree.h"
#include "geometry/volumes/triangle_sides.h"

namespace af2::geometry {
namespace {

/// Connected sides of triangles. They are the outer boundary of a cell if their volume is positive;
/// else the cell lies around them.
struct Shell {
  std::vector<std::uint32_t> sides;
  Box3 box;
  double volume = 0;  ///< 0 for a sheet
};

class CellFinder {
 public:
  CellFinder(const std::vector<Point3>& vertices, const std::vector<Triangle>& triangles)
      : vertices_(vertices), triangles_(triangles), lowest_(connectedSides(vertices, triangles)) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const VertexId v : triangles[t]) box_.add(vertices[v.value]);
  }

  MeshCells cells(PointsInside points) {
    findShells();
    const bool isNested = std::ranges::any_of(shells_, [&](const Shell& inner) {
      return std::ranges::any_of(shells_,
                                 [&](const Shell& outer) { return mayBeAround(outer, inner); });
    });
    // Most meshes need no tree if no points are wanted.
    if (points == PointsInside::Wanted || isNested) tree_.emplace(boxesOf(triangles_));
    MeshCells cells;
    cells.inside.emplace_back();
    std::vector<std::uint32_t> cellOf(shells_.size(), MeshCells::kOutside);
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      if (shells_[i].volume <= 0) continue;
      cellOf[i] = static_cast<std::uint32_t>(cells.inside.size());
      cells.inside.emplace_back();
      if (points == PointsInside::Wanted) cells.inside.back() = pointInside(shells_[i]);
    }
    for (std::size_t i = 0; i < shells_.size(); ++i)
      if (isNested && shells_[i].volume <= 0)
        if (const std::size_t around = shellAround(shells_[i]); around < shells_.size())
          cellOf[i] = cellOf[around];
    cells.ofSide.resize(lowest_.size());
    for (std::size_t i = 0; i < shells_.size(); ++i)
      for (const std::uint32_t side : shells_[i].sides) cells.ofSide[side] = cellOf[i];
    return cells;
  }

 private:
  /// From the middle of a triangle halfway to what is seen from there.
  struct Step {
    Point3 to;
    double length = 0;
  };

  std::array<Point3, 3> corners(std::size_t triangle) const {
    const Triangle& t = triangles_[triangle];
    return {vertices_[t[0].value], vertices_[t[1].value], vertices_[t[2].value]};
  }

  std::vector<Box3> boxesOf(const std::vector<Triangle>& triangles) const {
    std::vector<Box3> boxes(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const Point3& p : corners(t)) boxes[t].add(p);
    return boxes;
  }

  void findShells() {
    std::vector<std::uint32_t> shellOf(lowest_.size());
    for (std::uint32_t side = 0; side < lowest_.size(); ++side) {
      if (lowest_[side] == side) {
        shellOf[side] = static_cast<std::uint32_t>(shells_.size());
        shells_.emplace_back();
      }
      Shell& shell = shells_[shellOf[lowest_[side]]];
      shell.sides.push_back(side);
      const auto [a, b, c] = corners(side / 2);
      for (const Point3& p : {a, b, c}) shell.box.add(p);
      // Both sides of a sheet cancel; left out, they do so without rounding.
      if (lowest_[side] == lowest_[side ^ 1]) continue;
      const Point3 origin = vertices_[triangles_[lowest_[side] / 2][0].value];
      const double volume = dot(a - origin, cross(b - origin, c - origin)) / 6;
      shell.volume += side % 2 == 0 ? -volume : volume;
    }
  }

  /// Where the half-line from `from` first meets a triangle other than `own`, as a multiple of
  /// `way`; `farthest` if it meets none before.
  double firstHit(const Point3& from, const Point3& way, double farthest, std::size_t own) const {
    double first = farthest;
    tree_->forEachIn(Segment3(from, from + farthest * way), [&](std::uint32_t triangle) {
      if (triangle == own) return;
      const auto [a, b, c] = corners(triangle);
      const Point3 ab = b - a, ac = c - a, across = cross(way, ac), to = from - a;
      const double det = dot(ab, across);
      if (det == 0) return;
      const Point3 other = cross(to, ab);
      const double u = dot(to, across) / det, v = dot(way, other) / det;
      // A ray through an edge must not slip between its two triangles.
      constexpr double kRounding = 1e-9;
      if (u < -kRounding || v < -kRounding || u + v > 1 + kRounding) return;
      if (const double t = dot(ac, other) / det; t >= 0) first = std::min(first, t);
    });
    return first;
  }

  /// Steps into the cell from some of the sides, the longest first.
  std::vector<Step> stepsFrom(const Shell& shell) const {
    constexpr std::size_t kSides = 32;
    const double farthest = 2 * distance(box_.low, box_.high);
    std::vector<Step> steps;
    const std::size_t count = std::min(kSides, shell.sides.size());
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t side = shell.sides[i * shell.sides.size() / count];
      const auto [a, b, c] = corners(side / 2);
      const Point3 normal = unit(cross(b - a, c - a));
      const Point3 way = (side % 2 == 0 ? 1.0 : -1.0) * normal;
      const Point3 middle = (1.0 / 3) * (a + b + c);
      if (way == Point3{}) continue;
      const double half = firstHit(middle, way, farthest, side / 2) / 2;
      steps.push_back({middle + half * way, half});
    }
    std::ranges::stable_sort(steps, std::greater(), &Step::length);
    return steps;
  }

  /// The solid angle under which a closed shell is seen, in full spheres: 1 inside, 0 outside.
  double windingNumber(const Shell& shell, const Point3& p) const {
    double angle = 0;
    for (const std::uint32_t side : shell.sides) {
      if (lowest_[side] == lowest_[side ^ 1]) continue;
      const auto [a, b, c] = corners(side / 2);
      const Point3 x = a - p, y = b - p, z = c - p;
      const double i = length(x), j = length(y), k = length(z);
      const double half =
          angleOf({i * j * k + dot(x, y) * k + dot(y, z) * i + dot(z, x) * j, dot(x, cross(y, z))});
      angle += side % 2 == 0 ? -half : half;
    }
    return angle / (2 * std::numbers::pi);
  }

  std::optional<Point3> pointInside(const Shell& shell) const {
    for (const Step& step : stepsFrom(shell))
      if (step.length > 0 && std::abs(windingNumber(shell, step.to) - 1) < 0.1) return step.to;
    return std::nullopt;
  }

  /// Whether the cell in `outer` may have `inner` as an inner boundary, as far as boxes tell. Equal
  /// boxes are those of the two sides of the same surface.
  static bool mayBeAround(const Shell& outer, const Shell& inner) {
    if (outer.volume <= 0 || inner.volume > 0) return false;
    const Box3 &big = outer.box, &small = inner.box;
    return big.low.x <= small.low.x && big.low.y <= small.low.y && big.low.z <= small.low.z &&
           big.high.x >= small.high.x && big.high.y >= small.high.y && big.high.z >= small.high.z &&
           !(big.low == small.low && big.high == small.high);
  }

  /// The outer boundary of the cell around a shell: of those around it, the one with the least
  /// volume. The number of shells if there is none.
  std::size_t shellAround(const Shell& shell) const {
    if (std::ranges::none_of(shells_, [&](const Shell& o) { return mayBeAround(o, shell); }))
      return shells_.size();
    const std::vector<Step> steps = stepsFrom(shell);
    if (steps.empty()) return shells_.size();
    const Point3 p = steps.front().to;
    Box3 here;
    here.add(p);
    std::size_t least = shells_.size();
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      const Shell& other = shells_[i];
      if (!mayBeAround(other, shell) || !other.box.meets(here)) continue;
      if (least < shells_.size() && other.volume >= shells_[least].volume) continue;
      if (windingNumber(other, p) > 0.5) least = i;
    }
    return least;
  }

  const std::vector<Point3>& vertices_;
  const std::vector<Triangle>& triangles_;
  std::vector<std::uint32_t> lowest_;  ///< by side: the lowest one that is connected to it
  std::optional<BoxTree> tree_;        ///< of the triangles
  Box3 box_;                           ///< around all
  std::vector<Shell> shells_;          ///< in the order of their first sides
};

}  // namespace

MeshCells cellsOf(const std::vector<Point3>& vertices, const std::vector<Triangle>& triangles,
                  PointsInside points) {
  return CellFinder(vertices, triangles).cells(points);
}

}  // namespace af2::geometry
