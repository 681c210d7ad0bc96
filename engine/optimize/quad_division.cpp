#include "engine/optimize/quad_division.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace af2 {
namespace {

using Vertex = QuadPatch::Vertex;

/// A patch of which some elements are replaced.
class Division {
 public:
  /// Takes the elements and those around them.
  Division(PatchEditor& editor, std::span<const std::size_t> elements)
      : editor_(editor), topology_(editor.topology()) {
    const std::size_t middle = elements.size() / 2;
    const Corner seed = middle == 0
                            ? Corner(elements[0], 0)
                            : sideTowards(topology_, elements[middle], elements[middle - 1]);
    if (seed.isNone() || !editor_.take(topology_.vertexAt(seed), elements)) return;
    before_ = editor_.jacobians();
    if (!before_) return;
    patch_ = editor_.patch();
    points_ = editor_.points();
    for (const std::size_t e : elements) gone_.push_back(*editor_.find(e));
  }

  Vertex at(Corner c) const { return editor_.find(topology_.vertexAt(c)); }
  Point2 pointAt(Corner c) const { return points_[at(c)]; }
  /// The mean of the corners of a quadrilateral.
  Point2 centerOf(Corner c) const {
    Point2 sum;
    for (int i = 0; i < 4; ++i, c = topology_.next(c)) sum = sum + pointAt(c);
    return 0.25 * sum;
  }

  /// Adds a vertex; QuadPatch::kNone if the patch has no room, or there is no patch.
  Vertex add(Point2 point) {
    const std::optional<Vertex> added = before_ ? patch_.addInner(0) : std::nullopt;
    isSound_ &= added.has_value();
    if (!added) return QuadPatch::kNone;
    points_.push_back(point);
    return *added;
  }
  Vertex addMiddle(Corner side) {
    return before_ ? add(0.5 * (pointAt(side) + pointAt(topology_.next(side)))) : QuadPatch::kNone;
  }
  /// Adds an element.
  void add(const QuadPatch::Ring& ring) { rings_.push_back(ring); }

  bool hasPatch() const { return before_.has_value(); }
  const PatchJacobians& before() const { return *before_; }
  /// Of the first of the elements.
  double jacobian() const { return jacobianOf(patch_, gone_.front(), points_); }
  bool putBack(const PatchJacobians& wanted, FinishAct::Kind kind) {
    return isSound_ && patch_.refill(gone_, rings_) &&
           editor_.putBack(patch_, std::move(points_), wanted, kind);
  }

 private:
  PatchEditor& editor_;
  const MeshTopology& topology_;
  std::optional<PatchJacobians> before_;  ///< none: there is no patch
  QuadPatch patch_;
  std::vector<Point2> points_;
  std::vector<std::size_t> gone_;
  std::vector<QuadPatch::Ring> rings_;
  bool isSound_ = true;
};

std::array<Corner, 4> outlineOf(std::size_t quad) {
  return {Corner(quad, 0), Corner(quad, 1), Corner(quad, 2), Corner(quad, 3)};
}

/// Puts a quadrilateral with four others around it within an outline.
bool divideOutline(Division& division, const std::array<Corner, 4>& outline,
                   const PatchJacobians& wanted, FinishAct::Kind kind) {
  Point2 center;
  for (const Corner c : outline) center = center + 0.25 * division.pointAt(c);
  std::array<Vertex, 4> inner{};
  for (std::size_t i = 0; i < 4; ++i)
    inner[i] = division.add(0.5 * (center + division.pointAt(outline[i])));
  division.add(inner);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    division.add({division.at(outline[i]), division.at(outline[next]), inner[next], inner[i]});
  }
  return division.putBack(wanted, kind);
}

/// A side of an element, and the vertex in its middle.
struct Gate {
  Corner side;
  Vertex middle;
};

/// Divides a quadrilateral between two of its sides: in two, or in three where the way turns.
void divideQuad(Division& division, const MeshTopology& topology, const Gate& in, const Gate& out) {
  const Corner second = topology.next(in.side), third = topology.next(second);
  const Vertex a = division.at(in.side), b = division.at(second), c = division.at(third),
               d = division.at(topology.next(third)), entry = in.middle, exit = out.middle;
  if (out.side == third) {
    division.add({a, entry, exit, d});
    division.add({entry, b, c, exit});
    return;
  }
  const Vertex center = division.add(division.centerOf(in.side));
  if (out.side == second) {
    division.add({entry, b, exit, center});
    division.add({center, exit, c, d});
    division.add({a, entry, center, d});
  } else {
    division.add({entry, b, c, center});
    division.add({center, c, d, exit});
    division.add({a, entry, center, exit});
  }
}

/// Divides the last quadrilateral of a way in a quadrilateral and a triangle that has the side
/// `out`.
void leaveTriangle(Division& division, const MeshTopology& topology, Corner in, Corner out,
                   Vertex entry) {
  constexpr Vertex kNone = QuadPatch::kNone;
  const Corner second = topology.next(in), third = topology.next(second);
  const Vertex a = division.at(in), b = division.at(second), c = division.at(third),
               d = division.at(topology.next(third));
  if (out == second) {
    division.add({a, entry, c, d});
    division.add({entry, b, c, kNone});
  } else if (out == third) {
    division.add({a, entry, b, c});
    division.add({a, c, d, kNone});
  } else {
    division.add({entry, b, c, d});
    division.add({d, a, entry, kNone});
  }
}

/// Whether an element has a corner with fixed sides.
bool hasFixedCorner(const MeshTopology& topology, std::size_t element) {
  const auto corners = topology.mesh().elements[element].vertices();
  const auto isFixed = [&](std::size_t i) { return topology.isFixed(corners[i % corners.size()]); };
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (isFixed(i) && isFixed(i + 1) && isFixed(i + 2)) return true;
  return false;
}

}  // namespace

Corner sideTowards(const MeshTopology& topology, std::size_t e, std::size_t other) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(topology.mesh().elements[e].size()); ++k) {
    const Corner beyond = topology.across(Corner(e, k));
    if (!beyond.isNone() && beyond.element() == other) return Corner(e, k);
  }
  return {};
}

bool divideAlong(PatchEditor& editor, std::span<const std::size_t> path,
                 std::optional<std::size_t> beyond, double leastJacobian) {
  const MeshTopology& topology = editor.topology();
  Division division(editor, path);
  if (!division.hasPatch()) return false;
  // Beside a triangle the middle lies within the quadrilateral, where smoothing will put it.
  const auto addMiddleNear = [&](Corner side, std::size_t triangle) {
    constexpr double kWithin = 0.3;
    const Corner in = topology.across(side).element() == triangle ? side : topology.across(side);
    const Point2 middle = 0.5 * (division.pointAt(in) + division.pointAt(topology.next(in)));
    return division.add((1 - kWithin) * middle + kWithin * division.centerOf(in));
  };
  const auto divideTriangle = [&](Corner side, Vertex middle) {
    division.add({division.at(side), middle, division.at(topology.next(side)),
                  division.at(topology.previous(side))});
  };
  const std::size_t ending = path.back();
  Corner out = sideTowards(topology, path[0], path[1]);
  Vertex exit = addMiddleNear(out, path[0]);
  divideTriangle(out, exit);
  for (std::size_t i = 1; i < path.size() && (beyond || i + 1 < path.size()); ++i) {
    const Corner in = topology.across(out);
    if (i + 1 == path.size()) {
      leaveTriangle(division, topology, in, sideTowards(topology, path[i], *beyond), exit);
      break;
    }
    const Vertex entry = exit;
    out = sideTowards(topology, path[i], path[i + 1]);
    exit = path[i + 1] == ending && !beyond ? addMiddleNear(out, ending) : division.addMiddle(out);
    divideQuad(division, topology, {in, entry}, {out, exit});
  }
  if (!beyond) divideTriangle(topology.across(out), exit);
  return division.putBack({std::min(leastJacobian, division.before().least)},
                          FinishAct::Kind::Pairing);
}

bool divideInRing(PatchEditor& editor, std::size_t triangle, std::size_t beyond,
                  double leastJacobian) {
  const MeshTopology& topology = editor.topology();
  const Corner side = sideTowards(topology, triangle, beyond);
  if (side.isNone()) return false;
  const std::array both{triangle, beyond};
  Division division(editor, both);
  return division.hasPatch() &&
         divideOutline(division,
                       {topology.previous(side), side, topology.previous(topology.across(side)),
                        topology.next(side)},
                       {std::min(leastJacobian, division.before().least)},
                       FinishAct::Kind::Pairing);
}

bool divideTurned(PatchEditor& editor, std::size_t quad) {
  const std::array one{quad};
  Division division(editor, one);
  if (!division.hasPatch() || division.before().turned == 0) return false;
  return divideOutline(division, outlineOf(quad), {.turned = division.before().turned - 1},
                       FinishAct::Kind::Search);
}

std::size_t divideFlatQuads(PatchEditor& editor, const WorkWatch& watch) {
  constexpr double kFlat = 0.35, kGain = 0.1;
  const MeshTopology& topology = editor.topology();
  std::size_t divided = 0;
  for (std::size_t e = 0, n = topology.mesh().elements.size(); e < n; ++e) {
    if (watch.mustStop()) break;
    if (topology.isDead(e) || !topology.mesh().elements[e].isQuad()) continue;
    if (!hasFixedCorner(topology, e)) continue;
    const std::array one{e};
    Division division(editor, one);
    if (!division.hasPatch()) continue;
    const std::array<Corner, 4> outline = outlineOf(e);
    const double here = division.jacobian();
    if (here < kFlat && divideOutline(division, outline, {here + kGain}, FinishAct::Kind::Search))
      ++divided;
  }
  return divided;
}

}  // namespace af2
