#include "engine/base/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace af2 {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 toCgal(Point2 p) { return {p.x, p.y}; }

/// For p on the line rs: whether it lies between r and s, ends included.
bool liesBetween(Point2 r, Point2 s, Point2 p) {
  return std::min(r.x, s.x) <= p.x && p.x <= std::max(r.x, s.x) && std::min(r.y, s.y) <= p.y &&
         p.y <= std::max(r.y, s.y);
}

}  // namespace

Turn detail::exactOrientation(Point2 a, Point2 b, Point2 c) {
  return static_cast<Turn>(CGAL::orientation(toCgal(a), toCgal(b), toCgal(c)));
}

bool segmentsMeet(Point2 p, Point2 q, Point2 r, Point2 s) {
  const Turn rTurn = orientation(p, q, r), sTurn = orientation(p, q, s);
  const Turn pTurn = orientation(r, s, p), qTurn = orientation(r, s, q);
  if (rTurn != sTurn && pTurn != qTurn && p != q && r != s) return true;
  return (pTurn == Turn::Straight && liesBetween(r, s, p)) ||
         (qTurn == Turn::Straight && liesBetween(r, s, q)) ||
         (rTurn == Turn::Straight && liesBetween(p, q, r)) ||
         (sTurn == Turn::Straight && liesBetween(p, q, s));
}

}  // namespace af2
