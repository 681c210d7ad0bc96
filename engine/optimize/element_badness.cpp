#include "engine/optimize/element_badness.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "engine/base/error.h"
#include "engine/mesh/element_shape.h"
#include "engine/step/neighborhood.h"

namespace af2 {
namespace {

/// The strictest level: that an element was made at a higher one is no part of its quality.
constexpr int kFinishLevel = 1;

}  // namespace

ElementBadness::ElementBadness(const Mesh& mesh, const RuleSet& rules,
                               const AF2LocalTransformMaker& charts, const SizeField& size)
    : mesh_(mesh),
      metric_(*rules.definition().metric),
      unit_(rules.definition().unit),
      charts_(charts),
      size_(size),
      sizes_(mesh.vertices.size(), kUnknown) {}

double ElementBadness::of(const Element& element) {
  const double unit = unitOf(element.corners[0], element.corners[1]);
  if (!(unit > 0) || !std::isfinite(unit) || leans(mesh_, element)) return INFINITY;
  try {
    return inItsChart(element, unit);
  } catch (const GeometryError&) {
    return INFINITY;
  }
}

double ElementBadness::inItsChart(const Element& element, double unit) {
  const auto vertices = element.vertices();
  const StepChart chart(charts_.makeLocalTransformIn(slot_, at(vertices[0]), at(vertices[1]), unit),
                        unit);
  std::array<Point2, 4> places;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const ChartPoint drawn = chart.project(at(vertices[i]));
    if (drawn.view == ChartView::Hidden) return INFINITY;
    places[i] = drawn.position;
  }
  const std::span<const Point2> corners(places.data(), vertices.size());
  if (!turnsLeftEverywhere(corners)) return INFINITY;
  const double badness = metric_.badnessAt(corners, kFinishLevel).value_or(INFINITY);
  return std::isfinite(badness) ? badness : INFINITY;
}

double ElementBadness::unitOf(VertexId from, VertexId to) {
  const double length = distance(at(from).position, at(to).position);
  if (unit_ == ChartUnit::BaseLength || !(length > 0)) return length;
  return 0.5 * (sizeAt(from) + sizeAt(to));
}

double ElementBadness::sizeAt(VertexId v) {
  double& size = sizes_[v.value];
  if (size == kUnknown) size = size_.sizeAt(at(v));
  return size;
}

Element ElementBadness::bestRotation(Element triangle) {
  Element best = triangle;
  double least = of(triangle);
  for (int turn = 1; turn < 3; ++turn) {
    auto& [a, b, c, none] = triangle.corners;
    a = std::exchange(b, std::exchange(c, a));
    const double badness = of(triangle);
    if (!(badness < least)) continue;
    least = badness;
    best = triangle;
  }
  return best;
}

}  // namespace af2
