#include "dsl/proof/claim.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace af2::dsl {
namespace {

using MaybeClaim = std::optional<Claim>;

MaybeClaim allKnown(std::vector<MaybeClaim> parts) {
  std::vector<Claim> known;
  for (MaybeClaim& part : parts) {
    if (!part) return std::nullopt;
    known.push_back(std::move(*part));
  }
  return allOf(std::move(known));
}

MaybeClaim anyKnown(std::vector<MaybeClaim> parts) {
  std::vector<Claim> known;
  for (MaybeClaim& part : parts)
    if (part) known.push_back(std::move(*part));
  if (known.empty()) return std::nullopt;
  return anyOf(std::move(known));
}

/// Makes claims which imply that a convex element is inside or outside of shapes.
class Placement {
 public:
  /// cuts  how many more times the element may be split into parts that different shapes contain
  Placement(RuleGraph& graph, const Corners& element, int cuts)
      : graph_(graph), element_(element), cuts_(cuts) {}

  MaybeClaim in(const GraphShape& shape) {
    switch (shape.kind) {
      case ShapeKind::Convex:
        return each([&](NodePair p) { return inConvex(shape, p); });
      case ShapeKind::Hull:
        return each([&](NodePair p) { return inHull(shape, p); });
      case ShapeKind::Disc:
        return each([&](NodePair p) { return near(shape.points[0], shape.numbers[0], p); });
      case ShapeKind::Left:
        return each([&](NodePair p) { return leftOf(shape.points[0], shape.points[1], p); });
      case ShapeKind::Sector:
        return inSector(shape);
      case ShapeKind::Poly:
        return inPath(shape);
      case ShapeKind::Grow:
        return anyKnown({in(shape.parts[0]), inGrown(shape)});
      case ShapeKind::Union:
        return inUnion(shape);
      case ShapeKind::Intersection:
        return allKnown({in(shape.parts[0]), in(shape.parts[1])});
      case ShapeKind::Difference:
        return allKnown({in(shape.parts[0]), beside(shape.parts[1])});
      case ShapeKind::User:
        return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  template <class ClaimOfCorner>
  MaybeClaim each(const ClaimOfCorner& claimOf) {
    std::vector<Claim> claims;
    for (const NodePair p : element_) claims.push_back(claimOf(p));
    return allOf(std::move(claims));
  }

  Claim left(NodePair from, NodePair to, NodePair p) {
    return notNegative(graph_.turn(from, to, p));
  }
  Claim right(NodePair from, NodePair to, NodePair p) {
    return notNegative(graph_.turn(to, from, p));
  }
  Claim leftOf(NodePair point, NodePair direction, NodePair p) {
    return notNegative(graph_.cross(direction, graph_.difference(p, point)));
  }
  /// All corners of the element on one side of a line.
  Claim allLeft(NodePair from, NodePair to) {
    return *each([&](NodePair p) { return left(from, to, p); });
  }
  Claim allRight(NodePair from, NodePair to) {
    return *each([&](NodePair p) { return right(from, to, p); });
  }

  bool isCombination(NodePair p, const std::vector<NodePair>& points) {
    std::vector<LinearPoint> corners;
    for (const NodePair q : points) corners.push_back(graph_.linear(q));
    return !convexCombinations(graph_.linear(p), corners).empty();
  }

  Claim inConvex(const GraphShape& shape, NodePair p) {
    if (isCombination(p, shape.points)) return allOf({});
    std::vector<Claim> sides;
    for (std::size_t i = 0, n = shape.points.size(); i < n; ++i)
      sides.push_back(left(shape.points[i], shape.points[(i + 1) % n], p));
    return allOf(std::move(sides));
  }

  /// In a triangle of the points, in either orientation.
  Claim inHull(const GraphShape& shape, NodePair p) {
    constexpr std::size_t kMaxPoints = 6;
    const auto& q = shape.points;
    if (isCombination(p, q)) return allOf({});
    std::vector<Claim> triangles;
    for (std::size_t i = 0; i < std::min(q.size(), kMaxPoints); ++i)
      for (std::size_t j = i + 1; j < std::min(q.size(), kMaxPoints); ++j)
        for (std::size_t k = j + 1; k < std::min(q.size(), kMaxPoints); ++k) {
          triangles.push_back(
              allOf({left(q[i], q[j], p), left(q[j], q[k], p), left(q[k], q[i], p)}));
          triangles.push_back(
              allOf({right(q[i], q[j], p), right(q[j], q[k], p), right(q[k], q[i], p)}));
        }
    return anyOf(std::move(triangles));
  }

  /// distance <= radius, for a non-negative radius.
  Claim near(NodePair centre, Node radius, NodePair p) {
    const NodePair d = graph_.difference(p, centre);
    return notNegative(graph_.subtract(graph_.multiply(radius, radius), graph_.dot(d, d)));
  }

  MaybeClaim inSector(const GraphShape& shape) {
    const NodePair centre = shape.points[0];
    const Node radius = shape.numbers[0], from = shape.numbers[1], to = shape.numbers[2];
    const auto angle = graph_.constantValue(graph_.subtract(to, from));
    if (!angle || !(*angle > 0)) return std::nullopt;
    const Claim inDisc = *each([&](NodePair p) { return near(centre, radius, p); });
    if (*angle >= 2 * std::numbers::pi) return inDisc;
    const auto ray = [&](Node at) {
      return NodePair{graph_.make(Op::Cosine, {at}), graph_.make(Op::Sine, {at})};
    };
    const NodePair first = ray(from), last = ray(to);
    const NodePair back{graph_.negate(last.x), graph_.negate(last.y)};
    const Claim afterFirst = *each([&](NodePair p) { return leftOf(centre, first, p); });
    const Claim beforeLast = *each([&](NodePair p) { return leftOf(centre, back, p); });
    const Claim between = *angle <= std::numbers::pi ? allOf({afterFirst, beforeLast})
                                                     : anyOf({afterFirst, beforeLast});
    return allOf({inDisc, between});
  }

  /// All corners are within the distance of a convex set.
  MaybeClaim inGrown(const GraphShape& shape) {
    const GraphShape& inner = shape.parts[0];
    const Node distance = shape.numbers[0];
    if (inner.kind == ShapeKind::Disc)
      return each([&](NodePair p) {
        return near(inner.points[0], graph_.add(inner.numbers[0], distance), p);
      });
    if (inner.kind != ShapeKind::Hull && inner.kind != ShapeKind::Convex) return std::nullopt;
    return each([&](NodePair p) {
      std::vector<Claim> ways{inner.kind == ShapeKind::Hull ? inHull(inner, p)
                                                            : inConvex(inner, p)};
      if (ways[0].isTrue()) return ways[0];
      for (const NodePair q : inner.points) ways.push_back(near(q, distance, p));
      return anyOf(std::move(ways));
    });
  }

  /// In one of the shapes of the union; or split into four parts, each of which is in the union.
  MaybeClaim inUnion(const GraphShape& shape) {
    std::vector<MaybeClaim> ways;
    addMembers(shape, ways);
    if (cuts_ > 0) ways.push_back(inUnionByParts(shape));
    return anyKnown(std::move(ways));
  }

  /// Nested unions are flattened, so that each shape is considered once.
  void addMembers(const GraphShape& shape, std::vector<MaybeClaim>& ways) {
    for (const GraphShape& part : shape.parts) {
      if (part.kind == ShapeKind::Union)
        addMembers(part, ways);
      else
        ways.push_back(in(part));
    }
  }

  MaybeClaim inUnionByParts(const GraphShape& shape) {
    std::vector<MaybeClaim> claims;
    for (const Corners& part : quarters())
      claims.push_back(Placement(graph_, part, cuts_ - 1).in(shape));
    return allKnown(std::move(claims));
  }

  std::vector<Corners> quarters() {
    const std::size_t n = element_.size();
    Corners middles;
    for (std::size_t i = 0; i < n; ++i)
      middles.push_back(graph_.between(element_[i], element_[(i + 1) % n], 0.5));
    if (n == 3)
      return {{element_[0], middles[0], middles[2]},
              {middles[0], element_[1], middles[1]},
              {middles[2], middles[1], element_[2]},
              middles};
    const NodePair centre = graph_.between(middles[0], middles[2], 0.5);
    std::vector<Corners> parts;
    for (std::size_t i = 0; i < n; ++i)
      parts.push_back({element_[i], middles[i], centre, middles[(i + n - 1) % n]});
    return parts;
  }

  // ---- paths: no side enters the element, and one side is an edge of it -------------------------

  /// If a side of a counter-clockwise path is also an edge of the element, the path contains the
  /// part of the element next to that edge. It then contains the whole element, unless another side
  /// of the path enters the element.
  MaybeClaim inPath(const GraphShape& shape) {
    std::vector<Claim> claims;
    bool hasCommonEdge = false;
    std::size_t next = 0;
    NodePair from = shape.points.back();
    for (const bool isArc : shape.arcs) {
      std::optional<NodePair> via;
      if (isArc) via = shape.points[next++];
      const NodePair to = shape.points[next++];
      if (!isArc && isEdge(from, to))
        hasCommonEdge = true;
      else if (isArc || !(from == to))
        claims.push_back(via ? arcKeepsOut(from, *via, to) : sideKeepsOut(from, to));
      from = to;
    }
    if (!hasCommonEdge) return std::nullopt;
    return allOf(std::move(claims));
  }

  bool isEdge(NodePair from, NodePair to) const {
    for (std::size_t i = 0, n = element_.size(); i < n; ++i)
      if (element_[i] == from && element_[(i + 1) % n] == to) return true;
    return false;
  }

  Claim sideKeepsOut(NodePair from, NodePair to) {
    std::vector<Claim> ways{allLeft(from, to), allRight(from, to)};
    for (std::size_t i = 0, n = element_.size(); i < n; ++i) {
      const NodePair p = element_[i], q = element_[(i + 1) % n];
      ways.push_back(allOf({right(p, q, from), right(p, q, to)}));
    }
    return anyOf(std::move(ways));
  }

  /// An arc is on one side of its chord, and on its circle.
  Claim arcKeepsOut(NodePair from, NodePair via, NodePair to) {
    return anyOf({allOf({right(from, to, via), allLeft(from, to)}),
                  allOf({left(from, to, via), allRight(from, to)}),
                  allOf({left(from, via, to), allInCircle(from, via, to)}),
                  allOf({right(from, via, to), allInCircle(to, via, from)})});
  }

  /// Of the circle through three points that turn left.
  Claim allInCircle(NodePair a, NodePair b, NodePair c) {
    return *each([&](NodePair p) {
      const NodePair u = graph_.difference(a, p), v = graph_.difference(b, p),
                     w = graph_.difference(c, p);
      const auto term = [&](NodePair k, NodePair m, NodePair n) {
        return graph_.multiply(graph_.dot(k, k), graph_.cross(m, n));
      };
      return notNegative(graph_.add(graph_.add(term(u, v, w), term(v, w, u)), term(w, u, v)));
    });
  }

  // ---- the element is outside of a shape -------------------------------------------------------

  MaybeClaim beside(const GraphShape& shape) {
    switch (shape.kind) {
      case ShapeKind::Disc:
        return discBeside(shape.points[0], shape.numbers[0]);
      case ShapeKind::Hull:
      case ShapeKind::Convex:
        return pointsBeside(shape.points);
      case ShapeKind::Left:
        return each([&](NodePair p) {
          return leftOf(shape.points[0],
                        {graph_.negate(shape.points[1].x), graph_.negate(shape.points[1].y)}, p);
        });
      case ShapeKind::Union:
        return allKnown({beside(shape.parts[0]), beside(shape.parts[1])});
      case ShapeKind::Intersection:
        return anyKnown({beside(shape.parts[0]), beside(shape.parts[1])});
      case ShapeKind::Difference:
        return beside(shape.parts[0]);
      default:
        return std::nullopt;
    }
  }

  template <class ClaimOfEdge>
  Claim behindSomeEdge(const ClaimOfEdge& claimOf) {
    std::vector<Claim> ways;
    for (std::size_t i = 0, n = element_.size(); i < n; ++i)
      ways.push_back(claimOf(element_[i], element_[(i + 1) % n]));
    return anyOf(std::move(ways));
  }

  /// Outside of an edge, or separated from the element by a line through a corner.
  Claim discBeside(NodePair centre, Node radius) {
    std::vector<Claim> ways{behindSomeEdge([&](NodePair p, NodePair q) {
      const Node reach = graph_.multiply(radius, graph_.length(graph_.difference(q, p)));
      return notNegative(graph_.subtract(graph_.turn(q, p, centre), reach));
    })};
    for (const NodePair corner : element_) {
      const NodePair away = graph_.difference(centre, corner);
      Claim isBeyond = *each(
          [&](NodePair p) { return notNegative(graph_.dot(away, graph_.difference(corner, p))); });
      const Node clearance =
          graph_.subtract(graph_.dot(away, away), graph_.multiply(radius, radius));
      ways.push_back(allOf({std::move(isBeyond), notNegative(clearance)}));
    }
    return anyOf(std::move(ways));
  }

  Claim pointsBeside(const std::vector<NodePair>& points) {
    return behindSomeEdge([&](NodePair p, NodePair q) {
      std::vector<Claim> claims;
      for (const NodePair point : points) claims.push_back(right(p, q, point));
      return allOf(std::move(claims));
    });
  }

  RuleGraph& graph_;
  const Corners& element_;
  int cuts_;
};

}  // namespace

Claim notNegative(Node node) { return {Claim::Kind::NotNegative, node, {}}; }

Claim allOf(std::vector<Claim> parts) {
  std::erase_if(parts, [](const Claim& part) { return part.isTrue(); });
  if (parts.size() == 1) return std::move(parts.front());
  return {Claim::Kind::All, -1, std::move(parts)};
}

Claim anyOf(std::vector<Claim> parts) {
  for (const Claim& part : parts)
    if (part.isTrue()) return part;
  return {Claim::Kind::Any, -1, std::move(parts)};
}

std::optional<Claim> liesIn(RuleGraph& graph, const GraphShape& shape, const Corners& element) {
  constexpr int kMaxCuts = 2;  // each multiplies the claims by four for every level of unions
  return Placement(graph, element, kMaxCuts).in(shape);
}

void addShapeFacts(RuleGraph& graph, const GraphShape& shape, std::vector<Node>& facts) {
  const auto& q = shape.points;
  const bool isTriangle = shape.kind == ShapeKind::Poly && q.size() == 3 && shape.arcs.size() == 3;
  if (shape.kind == ShapeKind::Convex || isTriangle)
    for (std::size_t i = 0; i < q.size(); ++i)
      for (std::size_t j = i + 1; j < q.size(); ++j)
        for (std::size_t k = j + 1; k < q.size(); ++k)
          facts.push_back(graph.turn(q[i], q[j], q[k]));
  const bool hasSize = shape.kind == ShapeKind::Disc || shape.kind == ShapeKind::Sector ||
                       shape.kind == ShapeKind::Grow;
  if (hasSize) facts.push_back(shape.numbers[0]);
  for (const GraphShape& part : shape.parts) addShapeFacts(graph, part, facts);
}

}  // namespace af2::dsl
