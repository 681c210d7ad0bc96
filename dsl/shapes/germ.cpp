#include "dsl/shapes/germ.h"

#include <algorithm>

#include "engine/base/predicates.h"

namespace af2::dsl::shapes {
namespace {

/// A boundary that starts at the point. Rays are sorted by direction, then by their bend to the
/// left.
struct Ray {
  Vector<Dyadic> direction;
  Dyadic
      bend;  ///< offset to the left is bend * s^2 after s times the direction, up to second order
  int leaf = 0;
  enum class Beyond { In, Out, Other } beyond = Beyond::Other;  ///< the state to the left of it
};

/// Directions from 0 to below a half turn precede the others.
bool isUpper(const Vector<Dyadic>& d) {
  return d.y.sign() > 0 || (d.y.sign() == 0 && d.x.sign() > 0);
}

bool pointsAlongX(const Ray& ray) {
  return ray.direction.y.sign() == 0 && ray.direction.x.sign() > 0;
}

/// The sign of the counter-clockwise order, from the x axis on.
int compare(const Ray& p, const Ray& q) {
  if (isUpper(p.direction) != isUpper(q.direction)) return isUpper(p.direction) ? -1 : 1;
  const int turn = cross(p.direction, q.direction).sign();
  if (turn != 0) return -turn;
  // One direction, q's longer by a factor: offsets compare after the same distance. With q's step
  // s_q = s_p |p|/|q|, bend_q s_q^2 |q| against bend_p s_p^2 |p|.
  return (p.bend * dot(q.direction, p.direction) - q.bend * dot(p.direction, p.direction)).sign();
}

void addRays(const SmoothSet& set, Point2 point, int leaf, std::vector<Ray>& rays) {
  const Curve<Dyadic> curve = curveOf<Dyadic>(set);
  const Vector<Dyadic> g = gradientAt(curve, point);
  const Dyadic zero(0);
  // f rises to the left of (g.y, -g.x); f = 0 there bends towards where f rises.
  rays.push_back({{g.y, zero - g.x}, curve.bend, leaf, Ray::Beyond::In});
  rays.push_back({{zero - g.y, g.x}, zero - curve.bend, leaf, Ray::Beyond::Out});
}

bool isOnSide(Point2 point, Point2 p, Point2 q) {
  return orientation(p, q, point) == Turn::Straight && std::min(p.x, q.x) <= point.x &&
         point.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= point.y &&
         point.y <= std::max(p.y, q.y);
}

/// Adds a ray for each half side at `point`. Returns the state just counter-clockwise of the x
/// axis.
bool addRays(const Polygon& polygon, Point2 point, int leaf, std::vector<Ray>& rays) {
  bool inside = false;
  const auto& corners = polygon.corners;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point2 p = corners[j], q = corners[i];
    if (isOnSide(point, p, q)) {
      if (p != point) rays.push_back({difference<Dyadic>(point, p), Dyadic(0), leaf});
      if (q != point) rays.push_back({difference<Dyadic>(point, q), Dyadic(0), leaf});
    } else if ((p.y > point.y) != (q.y > point.y) &&
               (orientation(p, q, point) == Turn::Left) == (q.y > p.y)) {
      inside = !inside;
    }
  }
  return inside;
}

void cross(const Ray& ray, std::vector<std::uint8_t>& states) {
  auto& state = states[ray.leaf];
  state = ray.beyond == Ray::Beyond::Other ? !state : ray.beyond == Ray::Beyond::In;
}

}  // namespace

std::vector<std::vector<std::uint8_t>> sectorsAround(Point2 point, std::span<const Leaf> leaves,
                                                     std::span<const Place> places) {
  std::vector<Ray> rays;
  std::vector<std::uint8_t> states(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const int leaf = static_cast<int>(i);
    states[i] = places[i] == Place::In;
    if (places[i] != Place::On) continue;
    if (const auto* polygon = std::get_if<Polygon>(&leaves[i].set)) {
      states[i] = addRays(*polygon, point, leaf, rays);
    } else {
      addRays(std::get<SmoothSet>(leaves[i].set), point, leaf, rays);
    }
  }
  std::stable_sort(rays.begin(), rays.end(),
                   [](const Ray& p, const Ray& q) { return compare(p, q) < 0; });

  // The state before the first ray. Smooth leaves have the state after their last ray. Polygons
  // have the state just above the x axis, with the rays along the axis undone.
  for (const Ray& ray : rays)
    if (ray.beyond != Ray::Beyond::Other || pointsAlongX(ray)) cross(ray, states);

  std::vector<std::vector<std::uint8_t>> sectors;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    cross(rays[i], states);
    const bool ends = i + 1 == rays.size() || compare(rays[i], rays[i + 1]) != 0;
    if (ends) sectors.push_back(states);
  }
  return sectors;
}

}  // namespace af2::dsl::shapes
