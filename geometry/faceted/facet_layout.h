// A patch of triangles, parametrised by its layout in a plane.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/point.h"
#include "geometry/base/box_tree.h"

namespace af2::geometry {

/// Weights of the corners of a triangle.
struct Barycentric {
  double a = 1, b = 0, c = 0;
};

/// The first fundamental form: squares of the derivatives by the parameters, and their product.
struct Metric {
  double uu = 0, uv = 0, vv = 0;
};

/// Immutable, so threads may share it.
class FacetLayout {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  /// places  by vertex; all triangles are counter-clockwise
  FacetLayout(std::vector<Point2> places, const std::vector<Point3>& vertices,
              const std::vector<Corners>& triangles);

  struct Found {
    std::uint32_t triangle = 0;
    Barycentric where;
  };
  /// The triangle that contains a place; beyond the boundary and in holes the nearest one.
  Found at(Point2 place) const;
  Point2 placeIn(std::uint32_t triangle, const Barycentric& where) const;
  /// Smooth: at each vertex the mean over the triangles around it, and linear in between.
  Metric metricAt(const Found& found) const;

 private:
  std::vector<Box3> takeMetrics(const std::vector<Point3>& vertices);
  bool contains(std::uint32_t triangle, Point2 place) const;
  /// Of a place in the triangle.
  Barycentric weightsIn(std::uint32_t triangle, Point2 place) const;
  Barycentric nearestIn(std::uint32_t triangle, Point2 place) const;

  std::vector<Point2> places_;
  std::vector<Corners> triangles_;
  std::vector<Metric> metrics_;  // by vertex
  BoxTree tree_;
};

}  // namespace af2::geometry
