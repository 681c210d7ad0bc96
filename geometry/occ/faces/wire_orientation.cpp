#include "geometry/occ/faces/wire_orientation.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {

namespace {

struct Segment {
  Point2 p, q;
};
using Wire = std::vector<Segment>;  // in no particular order

double signedArea(const Wire& wire) {
  double area = 0;
  for (const Segment& s : wire) area += cross(s.p - wire[0].p, s.q - wire[0].p) / 2;
  return area;
}

double lengthOf(const Wire& wire) {
  double sum = 0;
  for (const Segment& s : wire) sum += distance(s.p, s.q);
  return sum;
}

/// Whether a ray from the point crosses the wire an odd number of times.
bool contains(const Wire& wire, Point2 point) {
  bool inside = false;
  for (const Segment& s : wire) {
    if ((s.p.y > point.y) == (s.q.y > point.y)) continue;
    const double x = s.p.x + (point.y - s.p.y) / (s.q.y - s.p.y) * (s.q.x - s.p.x);
    if (point.x < x) inside = !inside;
  }
  return inside;
}

/// Wires may touch, so a single point would not do: the greater part of the length counts.
bool liesIn(const Wire& inner, const Wire& outer) {
  double inside = 0;
  for (const Segment& s : inner)
    if (contains(outer, 0.5 * (s.p + s.q))) inside += distance(s.p, s.q);
  return inside > 0.5 * lengthOf(inner);
}

void turnRound(Chain& chain) {
  std::reverse(chain.corners.begin(), chain.corners.end());
  chain.reversed = !chain.reversed;
}

}  // namespace

int orientWires(std::vector<Chain>& chains, const std::vector<std::size_t>& wire,
                const std::function<Point2(const SurfacePoint&)>& inPlane) {
  /// An area below this share of the squared length has no direction that could be trusted.
  constexpr double kFlat = 1e-6;
  std::vector<Wire> wires(wire.empty() ? 0 : *std::max_element(wire.begin(), wire.end()) + 1);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const auto& corners = chains[i].corners;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
      wires[wire[i]].push_back({inPlane(corners[k].point), inPlane(corners[k + 1].point)});
  }
  std::vector<bool> isWrong(wires.size(), false);
  for (std::size_t w = 0; w < wires.size(); ++w) {
    if (wires[w].empty()) continue;
    const double area = signedArea(wires[w]), length = lengthOf(wires[w]);
    if (!(std::abs(area) > kFlat * length * length)) continue;
    std::size_t depth = 0;
    for (std::size_t o = 0; o < wires.size(); ++o)
      if (o != w && !wires[o].empty() && std::abs(signedArea(wires[o])) > std::abs(area) &&
          liesIn(wires[w], wires[o]))
        ++depth;
    isWrong[w] = (depth % 2 == 0) != (area > 0);
  }
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (isWrong[wire[i]]) turnRound(chains[i]);
  return static_cast<int>(std::count(isWrong.begin(), isWrong.end(), true));
}

}  // namespace af2::geometry
