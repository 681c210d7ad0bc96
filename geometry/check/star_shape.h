// Whether each ray from a point meets a closed surface once.
// Not installed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/mesh/mesh.h"
#include "geometry/check/drawn_part.h"

namespace af2::geometry {

/// Triangles of a closed surface as seen from a point inside. If all of them turn the same way,
/// each direction meets as many of them as any other.
class StarShape {
 public:
  explicit StarShape(const Point3& centre) : centre_(centre) {}

  /// For other triangles of the same surface: they have to look the same way as those of this one.
  StarShape forOthers() const {
    StarShape others(centre_);
    others.side_ = side_;
    return others;
  }
  void add(const StarShape& others) { count_ += others.count_; }

  /// False: the triangle does not look the same way as those before, or too little, or it is not
  /// certain whether it is met.
  bool takes(const Point3& a, const Point3& b, const Point3& c) {
    const Point3 p = a - centre_, q = b - centre_, r = c - centre_;
    const Point3 normal = cross(b - a, c - a);
    const double facing = dot(normal, p);
    if (side_ == 0) side_ = facing > 0 ? 1 : -1;
    if (!(side_ * facing > 0) ||
        !(facing * facing > kMinFacing * kMinFacing * dot(normal, normal) * dot(p, p)))
      return false;
    return meets(p, q, r);
  }
  /// The same for all triangles of an element.
  ///
  /// at  the position of a vertex
  template <class At>
  bool takes(const Element& element, const At& at) {
    const auto corners = element.vertices();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      if (!takes(at(corners[0]), at(corners[k]), at(corners[k + 1]))) return false;
    return true;
  }
  bool goesAroundOnce() const { return count_ == 1; }

 private:
  static constexpr Point3 kRay{0.5257, 0.6143, 0.5885};  // parallel to no usual direction
  static constexpr double kCertain = 1e-9;  // of the largest value that the terms can have

  bool meets(const Point3& p, const Point3& q, const Point3& r) {
    const double reach = kCertain * (dot(p, p) + dot(q, q) + dot(r, r));
    double least = 1e300;
    for (const Point3& edge : {cross(p, q), cross(q, r), cross(r, p)})
      least = std::min(least, side_ * dot(kRay, edge));
    count_ += least > reach;
    return std::abs(least) > reach;
  }

  Point3 centre_;
  double side_ = 0;
  int count_ = 0;
};

}  // namespace af2::geometry
