#include "dsl/shapes/boundary.h"

#include <algorithm>
#include <cmath>

#include "dsl/shapes/arc.h"
#include "engine/base/elementary.h"
#include "engine/base/turn.h"

namespace af2::dsl::shapes {
namespace {

using States = std::vector<std::optional<std::uint8_t>>;

double sizeOf(const Box2& box) { return distance(box.low, box.high); }

Point2 at(const Edge& edge, double t) {
  if (t == 0 || t == 1) return t == 0 ? edge.from : edge.to;
  return edge.from + t * (edge.to - edge.from);
}

// --- straight pieces: following each side through the region shows where it is boundary

bool isPartial(std::uint8_t state) { return state == kLeftSide || state == kRightSide; }

/// Adds the parts of an edge of leaf `own` that have the region on one side only. Parts that are
/// also on the boundary of an earlier leaf are skipped, because that leaf has added them.
void addStretches(const Region& region, const Edge& edge, std::size_t own, const States& known,
                  std::vector<Piece>& pieces) {
  region.alongEdge(edge, known, [&](const Region::Stretch& stretch) {
    const auto earlier = stretch.leafStates.first(own);
    if (!isPartial(stretch.state) || !isPartial(stretch.leafStates[own]) ||
        std::any_of(earlier.begin(), earlier.end(), isPartial))
      return false;
    const Point2 from = at(edge, stretch.from.approximate());
    const Point2 to = at(edge, stretch.to.approximate());
    if (stretch.state == kLeftSide)
      pieces.push_back({from, to, std::nullopt});
    else
      pieces.push_back({to, from, std::nullopt});
    return false;
  });
}

/// The orientation of half plane `other` relative to `plane`, if they have the same line.
std::optional<std::uint8_t> stateAlong(const HalfPlane& plane, const Leaf& other) {
  const auto* set = std::get_if<SmoothSet>(&other.set);
  const auto* second = set ? std::get_if<HalfPlane>(set) : nullptr;
  if (!second || sideOf(*second, plane.point) != 0) return std::nullopt;
  if (turnOf(plane, *second) != 0) return std::nullopt;
  return headsAlong(plane, *second) ? kLeftSide : kRightSide;
}

/// The rounded ends of a long piece of a line may be off the line, so known states are set
/// directly.
void addLine(const Region& region, const HalfPlane& plane, std::size_t own, const Box2& box,
             std::vector<Piece>& pieces) {
  if (plane.isChord) {
    const Point2 end = plane.tip == plane.point ? plane.tail : plane.tip;
    return addStretches(region, {plane.point, end}, own, {}, pieces);
  }
  States known;
  for (const Leaf& leaf : region.leaves()) known.push_back(stateAlong(plane, leaf));
  const Point2 direction = plane.tip - plane.tail;
  const double reach = 2 * sizeOf(box) + 2 * distance(plane.point, box.low);
  const Point2 step = (reach / length(direction)) * direction;
  addStretches(region, {plane.point - step, plane.point + step}, own, known, pieces);
}

// --- arcs: split at all other boundaries, then tested on both sides

std::optional<Disc> circleOf(const Leaf& leaf) {
  const auto* set = std::get_if<SmoothSet>(&leaf.set);
  if (!set) return std::nullopt;
  if (const auto* disc = std::get_if<Disc>(set)) return *disc;
  if (const auto* through = std::get_if<DiscThrough>(set)) return roundedCircle(*through);
  return std::nullopt;
}

bool areSame(const Disc& p, const Disc& q) {
  const double tolerance = 1e-12 * (p.radius + q.radius);
  return distance(p.centre, q.centre) <= tolerance && std::abs(p.radius - q.radius) <= tolerance;
}

double positiveAngleOf(Point2 direction) {
  const double angle = af2::angleOf(direction);
  return angle < 0 ? angle + kFullTurn : angle;
}

/// Adds the angles at which a line crosses the circle.
void addCuts(const Disc& circle, Point2 point, Point2 direction, std::vector<double>& cuts) {
  const double size = length(direction);
  if (size == 0) return;
  const Point2 along = (1 / size) * direction;
  const double offset = cross(along, circle.centre - point);
  const double square = circle.radius * circle.radius - offset * offset;
  if (square < 0) return;
  const Point2 foot = offset * Point2{along.y, -along.x};  // from the centre
  for (const double s : {-std::sqrt(square), std::sqrt(square)})
    cuts.push_back(positiveAngleOf(foot + s * along));
}

void addCuts(const Disc& circle, const Disc& other, std::vector<double>& cuts) {
  const Point2 between = other.centre - circle.centre;
  const double square = dot(between, between);
  if (square == 0) return;
  // The circles cross at the crossings with this line.
  const double share =
      0.5 * (1 + (circle.radius * circle.radius - other.radius * other.radius) / square);
  addCuts(circle, circle.centre + share * between, {-between.y, between.x}, cuts);
}

void addCuts(const Disc& circle, const Leaf& leaf, std::vector<double>& cuts) {
  if (const auto other = circleOf(leaf)) return addCuts(circle, *other, cuts);
  if (const auto* polygon = std::get_if<Polygon>(&leaf.set)) {
    for (std::size_t i = 0, j = polygon->corners.size() - 1; i < polygon->corners.size(); j = i++)
      addCuts(circle, polygon->corners[j], polygon->corners[i] - polygon->corners[j], cuts);
    return;
  }
  const auto& plane = std::get<HalfPlane>(std::get<SmoothSet>(leaf.set));
  addCuts(circle, plane.point, plane.tip - plane.tail, cuts);
}

Point2 onCircle(const Disc& circle, double angle, double factor = 1) {
  return circle.centre + factor * circle.radius * af2::directionAt(angle);
}

/// A crossing is often a corner of some shape; then the corner itself is used as the end.
Point2 snapped(const Region& region, Point2 point, double tolerance) {
  for (const Leaf& leaf : region.leaves()) {
    const auto* polygon = std::get_if<Polygon>(&leaf.set);
    if (!polygon) continue;
    for (const Point2 corner : polygon->corners)
      if (distance(corner, point) <= tolerance) return corner;
  }
  return point;
}

void addArc(const Region& region, const Disc& circle, double start, double end,
            std::vector<Piece>& pieces) {
  constexpr double kAside = 1e-7;
  const double middle = 0.5 * (start + end);
  const bool inner = region.locate(onCircle(circle, middle, 1 - kAside)) != Place::Out;
  const bool outer = region.locate(onCircle(circle, middle, 1 + kAside)) != Place::Out;
  if (inner == outer) return;
  const bool isWhole = end - start >= kFullTurn;
  const double tolerance = 1e-12 * (circle.radius + length(circle.centre));
  const Point2 from = snapped(region, onCircle(circle, start), tolerance);
  const Point2 to = isWhole ? from : snapped(region, onCircle(circle, end), tolerance);
  if (inner)
    pieces.push_back({from, to, Piece::Arc{circle, start, end - start}});
  else
    pieces.push_back({to, from, Piece::Arc{circle, end, start - end}});
}

void addCircle(const Region& region, const Disc& circle, std::size_t own,
               std::vector<Piece>& pieces) {
  std::vector<double> cuts;
  for (std::size_t i = 0; i < region.leaves().size(); ++i) {
    const auto other = circleOf(region.leaves()[i]);
    const bool isSame = i != own && other && areSame(circle, *other);
    if (isSame && i < own) return;
    if (i != own && !isSame) addCuts(circle, region.leaves()[i], cuts);
  }
  std::sort(cuts.begin(), cuts.end());
  constexpr double kSameAngle = 1e-11;
  const auto areClose = [](double a, double b) { return b - a < kSameAngle; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), areClose), cuts.end());
  if (cuts.empty()) return addArc(region, circle, 0, kFullTurn, pieces);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    addArc(region, circle, cuts[i], cuts[i + 1], pieces);
  addArc(region, circle, cuts.back(), cuts.front() + kFullTurn, pieces);
}

// --- loops

void addPoints(const Piece& piece, double sag, std::vector<Point2>& loop) {
  if (piece.arc) {
    const auto& [circle, start, sweep] = *piece.arc;
    const double ratio = std::clamp(1 - sag / circle.radius, -1.0, 1.0);
    const double step =
        std::clamp(2 * af2::angleOf({ratio, std::sqrt(1 - ratio * ratio)}), 0.01, 0.8);
    const int count = static_cast<int>(std::ceil(std::abs(sweep) / step));
    for (int i = 1; i < count; ++i) loop.push_back(onCircle(circle, start + sweep * i / count));
  }
  loop.push_back(piece.to);
}

}  // namespace

std::vector<Piece> boundaryOf(const Region& region, const Box2& box) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < region.leaves().size(); ++i) {
    const Leaf& leaf = region.leaves()[i];
    if (const auto circle = circleOf(leaf)) {
      addCircle(region, *circle, i, pieces);
    } else if (const auto* polygon = std::get_if<Polygon>(&leaf.set)) {
      const auto& corners = polygon->corners;
      for (std::size_t k = 0, j = corners.size() - 1; k < corners.size(); j = k++)
        if (corners[j] != corners[k]) addStretches(region, {corners[j], corners[k]}, i, {}, pieces);
    } else {
      addLine(region, std::get<HalfPlane>(std::get<SmoothSet>(leaf.set)), i, box, pieces);
    }
  }
  return pieces;
}

std::vector<std::vector<Point2>> loopsOf(std::vector<Piece> pieces, double sag) {
  std::vector<std::vector<Point2>> loops;
  while (!pieces.empty()) {
    std::vector<Point2> loop;
    Piece piece = pieces.back();
    pieces.pop_back();
    const Point2 start = piece.from;
    addPoints(piece, sag, loop);
    while (true) {
      const Point2 end = loop.back();
      const auto next =
          std::min_element(pieces.begin(), pieces.end(), [end](const Piece& p, const Piece& q) {
            return distance(p.from, end) < distance(q.from, end);
          });
      if (next == pieces.end() || distance(start, end) <= distance(next->from, end)) break;
      piece = *next;
      pieces.erase(next);
      addPoints(piece, sag, loop);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace af2::dsl::shapes
