#include "geometry/faceted/flats.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "engine/base/elementary.h"
#include "geometry/base/constants.h"

namespace af2::geometry {
namespace {

class Growth {
 public:
  Growth(const std::vector<HalfEdge>& twins, const std::vector<Point3>& normals)
      : twins_(twins), normals_(normals), of_(normals.size(), kNoHalfEdge) {}

  std::vector<std::uint32_t> grow(const std::vector<double>& areas) {
    std::vector<std::uint32_t> order(areas.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::ranges::greater(), [&](auto t) { return areas[t]; });
    for (const std::uint32_t first : order)
      if (of_[first] == kNoHalfEdge) growFrom(first);
    return std::move(of_);
  }

 private:
  void growFrom(std::uint32_t first) {
    of_[first] = count_;
    flood(twins_, first, [&](std::uint32_t other) {
      if (of_[other] != kNoHalfEdge || !isAlike(other, first)) return false;
      of_[other] = count_;
      return true;
    });
    ++count_;
  }
  bool isAlike(std::uint32_t t, std::uint32_t first) const {
    static const double kAlike = cosine(3 * kDegree);
    return normals_[t] == Point3{} || dot(normals_[t], normals_[first]) > kAlike;
  }

  const std::vector<HalfEdge>& twins_;
  const std::vector<Point3>& normals_;
  std::vector<std::uint32_t> of_;
  std::uint32_t count_ = 0;
};

}  // namespace

double lengthOf(const Facets& facets, HalfEdge h) {
  return distance(facets.vertices[startOf(facets.triangles, h)],
                  facets.vertices[endOf(facets.triangles, h)]);
}

double areaOf(const Facets& facets, std::uint32_t triangle) {
  const auto& c = facets.triangles[triangle];
  const Point3& origin = facets.vertices[c[0]];
  return length(cross(facets.vertices[c[1]] - origin, facets.vertices[c[2]] - origin)) / 2;
}

Point3 middleOf(const Facets& facets, std::uint32_t triangle) {
  const auto& c = facets.triangles[triangle];
  return (1.0 / 3) * (facets.vertices[c[0]] + facets.vertices[c[1]] + facets.vertices[c[2]]);
}

Flats findFlats(const Facets& facets, const std::vector<HalfEdge>& twins,
                const std::vector<Point3>& normals) {
  std::vector<double> areas;
  for (std::uint32_t t = 0; t < normals.size(); ++t) areas.push_back(areaOf(facets, t));
  Flats result;
  result.of = Growth(twins, normals).grow(areas);
  for (std::uint32_t t = 0; t < areas.size(); ++t) {
    if (result.of[t] >= result.flats.size()) result.flats.resize(result.of[t] + 1);
    Flat& flat = result.flats[result.of[t]];
    flat.area += areas[t];
    flat.normal = flat.normal + areas[t] * normals[t];
    flat.middle = flat.middle + areas[t] * middleOf(facets, t);
  }
  for (Flat& flat : result.flats) {
    flat.normal = unit(flat.normal);
    if (flat.area > 0) flat.middle = (1 / flat.area) * flat.middle;
  }
  for (HalfEdge h = 0; h < twins.size(); ++h)
    if (twins[h] == kNoHalfEdge || result.of[twins[h] / 3] != result.of[h / 3])
      result.flats[result.of[h / 3]].perimeter += lengthOf(facets, h);
  return result;
}

}  // namespace af2::geometry
