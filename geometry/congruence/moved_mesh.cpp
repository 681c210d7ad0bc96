#include "geometry/congruence/moved_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "geometry/fill/odd_loops.h"

namespace af2::geometry {
namespace {

/// Sizes by position above so many wanted sizes do not matter: the face itself wants less there.
constexpr double kAbove = 1.001;
/// Of a size. Lengths of edges differ from what is wanted by several times as much.
constexpr double kSameSize = 0.01;

std::vector<Point3> placesOf(const FrontInput& input) {
  std::vector<Point3> places(input.vertexCount);
  for (const auto& loop : input.loops)
    for (const BoundaryCorner& corner : loop) places[corner.vertex.value] = corner.point.position;
  return places;
}

}  // namespace

bool MovableMesh::isMovable(const FaceMesh& mesh) {
  const FaceReport& report = mesh.report;
  const auto hasPlace = [](const FaceReport::OddLoop& odd) { return odd.longest.sizes > 0; };
  return report.status == FaceStatus::Complete && !mesh.elements.empty() && !mesh.hasVanished &&
         !mesh.bulk && report.reason.empty() && report.stuck.empty() && report.layers.empty() &&
         report.triangles == 0 && std::ranges::none_of(report.oddLoops, hasPlace);
}

MovableMesh::MovableMesh(const FaceOutline& outline, const FaceMesh& mesh)
    : outline_(outline), mesh_(mesh) {
  if (!outline.sizes) return;
  std::vector<Point3> places = placesOf(outline.form.input);
  places.insert(places.end(), mesh.inside.begin(), mesh.inside.end());
  byPosition_ = mostByPosition(places, outline.sizes);
}

std::vector<double> MovableMesh::mostByPosition(const std::vector<Point3>& places,
                                                const PositionSize& sizes) const {
  std::vector<double> most;
  most.reserve(places.size());
  for (const double size : mesh_.wantedSizes) most.push_back(kAbove * size);
  sizes.lower(places, most);
  return most;
}

bool MovableMesh::wantsSameSizes(const std::vector<Point3>& places,
                                 const PositionSize& sizes) const {
  if (!outline_.sizes) return true;
  return std::ranges::equal(byPosition_, mostByPosition(places, sizes),
                            [](double a, double b) { return std::abs(a - b) <= kSameSize * a; });
}

/// inside  the moved vertices
bool MovableMesh::isSurfaceMoved(const FaceOutline& other, const std::vector<Point3>& inside,
                                 const Congruence& congruence) const {
  if (outline_.distance && other.distance)
    return std::ranges::none_of(
        inside, [&](const Point3& p) { return other.distance(p) > congruence.tolerance; });
  return !outline_.distance && !other.distance &&
         std::ranges::equal(outline_.samples, other.samples, [&](const Point3& p, const Point3& q) {
           return distance(congruence.motion.moved(p), q) <= congruence.tolerance;
         });
}

bool MovableMesh::moveTo(const FaceOutline& other, FaceMesh& into) const {
  if (outline_.numbers != other.numbers || mesh_.history != outline_.history) return false;
  const std::optional<Congruence> congruence = congruenceOf(outline_.form, other.form);
  if (!congruence) return false;
  const Motion& motion = congruence->motion;
  std::vector<Point3> places = placesOf(outline_.form.input);
  for (Point3& place : places) place = motion.moved(place);
  const std::size_t before = places.size();
  for (const Point3& place : mesh_.inside) places.push_back(motion.moved(place));
  const std::vector<Point3> inside(places.begin() + static_cast<std::ptrdiff_t>(before),
                                   places.end());
  if (!isSurfaceMoved(other, inside, *congruence)) return false;
  if (!wantsSameSizes(places, other.sizes)) return false;

  FaceReport report = std::move(into.report);
  into = mesh_;
  into.report = std::move(report);
  into.report.congruentTo = mesh_.report.id;
  into.report.chart = mesh_.report.chart;
  into.report.elements = mesh_.report.elements;
  into.report.withoutRule = mesh_.report.withoutRule;
  into.report.acts = mesh_.report.acts;
  into.report.oddLoops = oddLoopsOf(other.form.input, nullptr);
  into.optimizeSeconds = 0;
  into.history = other.history;
  into.boundary = other.points;
  into.uses = other.uses;
  into.inside = inside;
  for (SizeSource& place : into.diagnosis.places) place.position = motion.moved(place.position);
  for (std::size_t v = 0; v < before; ++v)
    into.wantedSizes[congruence->vertices[v].value] = mesh_.wantedSizes[v];
  for (std::size_t e = 0; e < into.elements.size(); ++e) {
    Element& element = into.elements[e];
    const auto n = static_cast<std::ptrdiff_t>(element.size());
    for (VertexId& v : std::span(element.corners).first(static_cast<std::size_t>(n)))
      if (v.value < before) v = congruence->vertices[v.value];
    // In a mirror, corners and sides run the other way; the first corner stays the first.
    if (congruence->isReflection)
      std::reverse(element.corners.begin() + 1, element.corners.begin() + n);
    if (into.middles.empty()) continue;
    SideMiddles& middles = into.middles[e];
    for (Point3& middle : middles) middle = motion.moved(middle);
    if (congruence->isReflection) std::reverse(middles.begin(), middles.begin() + n);
  }
  return true;
}

}  // namespace af2::geometry
