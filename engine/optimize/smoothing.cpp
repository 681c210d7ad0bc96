#include "engine/optimize/smoothing.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/mesh/element_shape.h"
#include "engine/mesh/triangle_grades.h"
#include "engine/optimize/vertex_step.h"
#include "engine/step/chart_drawing.h"

namespace af2 {
namespace {

constexpr double kTriangleScale = 0.28867513459481287;  // 1 / (2 sqrt(3))
constexpr double kQuadScale = 0.5;
/// Of the cotangents of corners at vertices that do not move, so that rows along a boundary have
/// upright sides there. Lengths of sides do not matter for these, so that rows keep their heights.
constexpr double kUprightScale = 5;

DistortionTerm triangleTerm(Point2 p, Point2 q) {
  return {kTriangleScale,         2,          p + q, dot(p, p) + dot(q, q) + dot(p - q, p - q),
          {p.y - q.y, q.x - p.x}, cross(p, q)};
}

/// The corner of a quadrilateral at the moving point itself, between p ahead and q behind.
DistortionTerm ownCornerTerm(Point2 p, Point2 q) {
  return {kQuadScale, 2, p + q, dot(p, p) + dot(q, q), {p.y - q.y, q.x - p.x}, cross(p, q)};
}

/// The corner at the next vertex n, between o ahead and the moving point behind.
DistortionTerm nextCornerTerm(Point2 n, Point2 o) {
  const Point2 u = o - n;
  return {kQuadScale, 1, n, dot(n, n) + dot(u, u), {-u.y, u.x}, -cross(u, n)};
}

/// The corner at the previous vertex p, between the moving point ahead and o behind.
DistortionTerm previousCornerTerm(Point2 p, Point2 o) {
  const Point2 u = o - p;
  return {kQuadScale, 1, p, dot(p, p) + dot(u, u), {u.y, -u.x}, -cross(p, u)};
}

/// The cotangent of the angle of a corner, from the term of its distortion.
///
/// n, o  the corner is at n, between the moving point and o
DistortionTerm cotangentTerm(const DistortionTerm& corner, Point2 n, Point2 o) {
  const Point2 u = o - n;
  return {kUprightScale, 0, -0.5 * u, -dot(u, n), corner.a, corner.a0};
}

/// x^n for even n > 0.
template <int kPower>
double power(double x) {
  if constexpr (kPower == 2)
    return x * x;
  else if constexpr (kPower % 4 == 0)
    return power<kPower / 2>(x * x);
  else
    return x * x * power<kPower - 2>(x);
}

/// Sum of a power of the distortions: a higher power gives bad elements more weight. Infinite where
/// an element has no positive area.
template <int kPower>
double energyAt(std::span<const DistortionTerm> terms, Point2 x) {
  double energy = 0;
  for (const DistortionTerm& t : terms) {
    const double area = dot(t.a, x) + t.a0;
    if (!(area > 0)) return INFINITY;
    const double f = t.scale * (t.count * dot(x, x) - 2 * dot(t.sum, x) + t.fixed) / area;
    energy += power<kPower>(f);
  }
  return energy;
}

/// The same with derivatives, at the origin.
template <int kPower>
Energy derivativesOf(std::span<const DistortionTerm> terms) {
  Energy e;
  for (const DistortionTerm& t : terms) {
    if (!(t.a0 > 0)) {
      e.value = INFINITY;
      return e;
    }
    const double inverse = 1 / t.a0;
    const double ratio = t.fixed * inverse;
    const double gx = (-2 * t.sum.x - ratio * t.a.x) * inverse;
    const double gy = (-2 * t.sum.y - ratio * t.a.y) * inverse;
    const double hxx = (2 * t.count - 2 * gx * t.a.x) * inverse;
    const double hyy = (2 * t.count - 2 * gy * t.a.y) * inverse;
    const double hxy = -(gx * t.a.y + gy * t.a.x) * inverse;
    double weight = t.scale * t.scale;
    if constexpr (kPower > 2) weight *= power<kPower - 2>(t.scale * ratio);
    constexpr double kFactor = kPower - 1;
    e.value += weight * ratio * ratio;
    e.gradient.x += kPower * weight * ratio * gx;
    e.gradient.y += kPower * weight * ratio * gy;
    e.xx += kPower * weight * (kFactor * gx * gx + ratio * hxx);
    e.xy += kPower * weight * (kFactor * gx * gy + ratio * hxy);
    e.yy += kPower * weight * (kFactor * gy * gy + ratio * hyy);
  }
  return e;
}

/// Distortion of an element with an angle of about three degrees.
constexpr double kThinDistortion = 12;

/// Doubles a step while that lowers the energy. Next to an element of almost no area the energy is
/// so steep that one step of Newton's method covers only a small part of the way to a fair element.
///
/// energy  after `step`
template <int kPower>
Point2 lengthened(std::span<const DistortionTerm> terms, Point2 step, double energy, double reach) {
  while (2 * length(step) <= kMaxOfReach * reach) {
    const double next = energyAt<kPower>(terms, 2 * step);
    if (!(next < energy)) break;
    step = 2 * step;
    energy = next;
  }
  return step;
}

/// A step of Newton's method from the origin, shortened until it lowers the energy; (0, 0) if none
/// does.
///
/// relaxation  factor of the first step tried
template <int kPower>
Point2 improvedPosition(std::span<const DistortionTerm> terms, double reach, double relaxation) {
  const Energy e = derivativesOf<kPower>(terms);
  if (!std::isfinite(e.value)) return {};
  const auto [step, energy] = descent(newtonStep(e, reach, relaxation), e.value,
                                      [&](Point2 at) { return energyAt<kPower>(terms, at); });
  const bool isThin = kPower > 2 && energy > power<kPower>(kThinDistortion);
  return isThin ? lengthened<kPower>(terms, step, energy, reach) : step;
}

/// Elements below this are good, and may get worse in favour of their neighbours.
constexpr double kGoodDistortion = 1.2;
/// Above this, shape matters more than sides that stand upright on a boundary.
constexpr double kFair = 2;
/// Moves below this fraction of an edge are not worth evaluating the surface.
constexpr double kMinMove = 1e-3;
/// Triangles need not follow smaller moves than this: the vertex then sleeps, and its neighbours
/// are not woken. Quadrilaterals converge in many small moves, so this does not apply to them.
constexpr double kWakingMove = 0.025;
/// Over-relaxation: neighbours move the same way, so that a vertex that is moved on to where they
/// will want it settles in half as many visits. Not where the worst element decides, and not beside
/// quadrilaterals, which move too little for it to save visits.
constexpr double kRelaxation = 1.3;

}  // namespace

VertexSmoother::VertexSmoother(MeshTopology& topology, Mesh& mesh,
                               const AF2LocalTransformMaker& maker, ActRecorder* recorder)
    : topology_(topology), mesh_(mesh), maker_(maker), recorder_(recorder) {
  isAwake_.assign(mesh.vertices.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (!topology.isDead(e) && gradeOf(topology, e) != TriangleGrade::Even)
      wake(mesh.elements[e].vertices());
}

void VertexSmoother::wake(std::span<const VertexId> vertices) {
  isAwake_.resize(mesh_.vertices.size(), 1);
  for (const VertexId v : vertices) isAwake_[v.value] = 1;
}

std::size_t VertexSmoother::sweep(const WorkWatch& watch) {
  std::size_t moved = 0;
  for (std::size_t v = topology_.fixedCount(); v < mesh_.vertices.size(); ++v) {
    if (watch.mustStopAt(v)) break;
    if (!isAwake_[v]) continue;
    isAwake_[v] = 0;
    const double move = smooth(VertexId(v), Goal::All);
    moved += move > 0;
    if (!(move > 0)) continue;
    for (Corner c : star_) {
      const Element& element = mesh_.elements[c.element()];
      if (move < kWakingMove && !element.isQuad()) continue;
      for (const VertexId w : element.vertices()) isAwake_[w.value] = 1;
    }
  }
  return moved;
}

std::size_t VertexSmoother::mend(std::span<const VertexId> vertices) {
  std::size_t moved = 0;
  for (const VertexId v : vertices) moved += smooth(v, Goal::Worst) > 0;
  return moved;
}

double VertexSmoother::smooth(VertexId v, Goal goal) {
  const Corner first = topology_.cornerOf(v);
  if (first.isNone() || !collectStar(first)) return 0;
  const SurfacePoint& here = mesh_.vertices[v.value];
  const SurfacePoint& neighbor = at(topology_.next(first));
  const double unit = distance(here.position, neighbor.position);
  if (!(unit > 0)) return 0;
  if (recorder_) recorder_->begin(star_, v);
  try {
    const double move =
        moveInChart(v, {maker_.makeLocalTransformIn(slot_, here, neighbor, unit), unit}, goal);
    if (recorder_ && move > 0) recorder_->end(FinishAct::Kind::Move);
    return move;
  } catch (const GeometryError&) {
    return 0;  // there is no chart at this vertex: it does not move
  }
}

/// Collects the corners of the vertex; returns false if it lies on the rim.
bool VertexSmoother::collectStar(Corner first) {
  star_.clear();
  isBetweenTriangles_ = true;
  Corner c = first;
  do {
    star_.push_back(c);
    isBetweenTriangles_ &= topology_.sizeOf(c) == 3;
    c = topology_.aroundVertex(c);
  } while (!c.isNone() && c != first);
  isBetweenTriangles_ &= star_.size() <= TriangleStar::kMost;
  return c == first;
}

double VertexSmoother::moveInChart(VertexId v, const StepChart& chart, Goal goal) {
  const Point2 step = stepInChart(chart, goal);
  const double move = length(step) / reach_;
  if (!(move >= kMinMove)) return 0;
  const auto lifted = chart.lift(step);
  if (!lifted) return 0;
  SurfacePoint& here = mesh_.vertices[v.value];
  const SurfacePoint before = std::exchange(here, *lifted);
  if (!isImproved(here, before, chart, goal)) {
    here = before;
    return 0;
  }
  for (Corner c : star_) topology_.dropGrade(c.element());
  return move;
}

/// Also tells the reach. (0, 0) if the vertex is to stay.
Point2 VertexSmoother::stepInChart(const StepChart& chart, Goal goal) {
  if (goal == Goal::All && isBetweenTriangles_) {
    ring_.clear();
    for (Corner c : star_) ring_.push_back(&at(topology_.next(c)));
    if (!triangles_.draw(at(star_.front()), ring_, chart)) return {};
    reach_ = triangles_.reach();
    return triangles_.improvedPosition(kRelaxation);
  }
  if (!makeTerms(chart)) return {};
  if (goal == Goal::Worst) return improvedPosition<16>(terms_, reach_, 1);
  const bool hasQuads = terms_.size() > star_.size();  // three terms for each
  return improvedPosition<2>(terms_, reach_, hasQuads ? 1 : kRelaxation);
}

/// Whether the elements around a vertex are better for its move.
bool VertexSmoother::isImproved(SurfacePoint& here, const SurfacePoint& before,
                                const StepChart& chart, Goal goal) const {
  const bool isForAll = goal == Goal::All;
  if (isForAll && chart.isPlane()) return true;  // for certain
  if (isForAll && isBetweenTriangles_ && triangles_.isPlainlyBelow(kGoodDistortion, here))
    return true;
  const double worst = worstDistortion();
  if (isForAll && worst <= kGoodDistortion) return true;
  const SurfacePoint after = std::exchange(here, before);
  const double worstBefore = worstDistortion();
  here = after;
  return !(worst > worstBefore);
}

bool VertexSmoother::isFixed(Corner c) const {
  return topology_.vertexAt(c).value < topology_.fixedCount();
}

/// Returns false if an edge at the vertex is hidden in the chart.
bool VertexSmoother::makeTerms(const StepChart& chart) {
  bool isSeen = false;
  withDrawing(chart, [&](const auto& drawing) { isSeen = makeTerms(chart, drawing); });
  return isSeen;
}

template <class Drawing>
bool VertexSmoother::makeTerms(const StepChart& chart, const Drawing& drawing) {
  terms_.clear();
  upright_.clear();
  double shortest = INFINITY;  // squared
  const Point3& here = at(star_.front()).position;
  const double squaredUnit = chart.unit() * chart.unit();
  const auto drawn = [&](Corner c) {
    const Drawn where = drawing(at(c));
    ChartPoint point{pointAt(where.position), where.view};
    if (chart.isPlane()) return point;
    const Point3 edge = at(c).position - here;
    const double seen = squaredUnit * dot(point.position, point.position);
    point.position = stretchOf(dot(edge, edge), seen) * point.position;
    return point;
  };
  // Around the vertex, the edge behind one element is the edge ahead of the next.
  ChartPoint ahead = drawn(topology_.next(star_.front()));
  for (Corner c : star_) {
    const ChartPoint behind = drawn(topology_.previous(c));
    if (behind.view == ChartView::Hidden) return false;
    shortest = std::min(shortest, dot(ahead.position, ahead.position));
    if (topology_.sizeOf(c) == 3) {
      terms_.push_back(triangleTerm(ahead.position, behind.position));
    } else {
      const Point2 opposite = drawn(topology_.next(topology_.next(c))).position;
      terms_.push_back(ownCornerTerm(ahead.position, behind.position));
      terms_.push_back(nextCornerTerm(ahead.position, opposite));
      if (isFixed(topology_.next(c)))
        upright_.push_back(cotangentTerm(terms_.back(), ahead.position, opposite));
      terms_.push_back(previousCornerTerm(behind.position, opposite));
      if (isFixed(topology_.previous(c)))
        upright_.push_back(cotangentTerm(terms_.back(), behind.position, opposite));
    }
    ahead = behind;
  }
  reach_ = std::sqrt(shortest);
  // In slivers, any angle at the boundary is better than worse ones elsewhere.
  const auto isFair = [](const DistortionTerm& t) { return t.scale * t.fixed < kFair * t.a0; };
  if (!upright_.empty() && std::ranges::all_of(terms_, isFair))
    terms_.insert(terms_.end(), upright_.begin(), upright_.end());
  return true;
}

double VertexSmoother::worstDistortion() const {
  double worst = 0;
  for (Corner c : star_) {
    const Element& element = mesh_.elements[c.element()];
    const auto corner = [&](std::size_t i) -> const SurfacePoint& {
      return mesh_.vertices[element.corners[i].value];
    };
    const double distortion =
        element.isQuad()
            ? elementDistortion(std::array{&corner(0), &corner(1), &corner(2), &corner(3)})
            : triangleDistortion(corner(0), corner(1), corner(2));
    worst = std::max(worst, distortion);
  }
  return worst;
}

}  // namespace af2
