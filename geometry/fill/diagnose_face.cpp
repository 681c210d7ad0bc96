#include "geometry/fill/diagnose_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "engine/base/elementary.h"
#include "engine/base/parallel.h"
#include "engine/mesh/element_area.h"
#include "engine/mesh/element_shape.h"
#include "engine/mesh/mesh_check.h"
#include "geometry/base/constants.h"
#include "geometry/check/boundary_crossings.h"
#include "geometry/check/model_check.h"
#include "geometry/fill/fill_limits.h"

namespace af2::geometry {

namespace {

Point3 middle(const Point3& a, const Point3& b) { return 0.5 * (a + b); }

void addEdge(std::vector<SizeSource>& places, const Point3& a, const Point3& b, double share) {
  if (places.size() < kMaxPlacesAtFault) places.push_back({middle(a, b), share * distance(a, b)});
}

void addStuck(const MeshingResult& result, std::vector<SizeSource>& places) {
  for (const StuckEdge& edge : result.stuck)
    addEdge(places, result.mesh.vertices[edge.from.value].position,
            result.mesh.vertices[edge.to.value].position, kFinerAtFaults);
}

/// Whether an edge cannot become shorter.
bool isShortest(const IsLeast& isLeast, const SurfacePoint& from, const SurfacePoint& to) {
  return isLeast && isLeast(from) && isLeast(to);
}

void addSides(std::vector<SizeSource>& places, const Mesh& mesh, const Element& element,
              const IsLeast& isLeast = {}) {
  const auto c = element.vertices();
  for (std::size_t i = 0; i < c.size(); ++i) {
    const SurfacePoint &from = mesh.vertices[c[i].value],
                       &to = mesh.vertices[c[(i + 1) % c.size()].value];
    if (!isShortest(isLeast, from, to)) addEdge(places, from.position, to.position, kFinerAtFaults);
  }
}

void addFaults(const MeshingResult& result, const MeshBoundary& boundary,
               std::vector<SizeSource>& places) {
  if (result.outcome != Outcome::Complete || result.mesh.vertices.empty()) return;
  const auto at = [&](VertexId v) -> const Point3& {
    return result.mesh.vertices[v.value].position;
  };
  for (const Element& element : result.mesh.elements)
    if (leans(result.mesh, element)) addSides(places, result.mesh, element);
  for (const MeshFault& fault : checkMesh(result.mesh, boundary)) {
    if (!fault.element.isNone()) {
      addSides(places, result.mesh, result.mesh.elements[fault.element.value]);
    } else if (!fault.from.isNone() && !fault.to.isNone()) {
      addEdge(places, at(fault.from), at(fault.to), kFinerAtFaults);
    }
  }
}

void addSegment(const FrontInput& input, SegmentPlace place, double share,
                std::vector<SizeSource>& places) {
  const auto& loop = input.loops[place.loop];
  addEdge(places, loop[place.corner].point.position,
          loop[(place.corner + 1) % loop.size()].point.position, share);
}

void addCrossings(const ChartedSurface& surface, const FaceBoundary& boundary,
                  std::vector<SizeSource>& places) {
  if (boundary.input.loops.empty()) return;
  if (!surface.isPlane() && !(boundary.closedInParameters && surface.inParameters())) return;
  const BoundaryPicture picture(surface, boundary.input);
  for (const auto& [a, b] : crossingsOf(boundary.input, picture, kMaxCrossedSegments)) {
    addSegment(boundary.input, a, kFinerAtCrossedSegments, places);
    addSegment(boundary.input, b, kFinerAtCrossedSegments, places);
  }
}

void addBoundary(const FrontInput& input, double share, const IsLeast& isLeast,
                 std::vector<SizeSource>& places) {
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const SurfacePoint &from = loop[i].point, &to = loop[(i + 1) % loop.size()].point;
      if (!isShortest(isLeast, from, to)) addEdge(places, from.position, to.position, share);
    }
}

/// The least angle of an element in degrees.
double leastAngle(const Mesh& mesh, std::span<const VertexId> c) {
  double least = 180;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto at = [&](std::size_t k) -> const Point3& {
      return mesh.vertices[c[k % c.size()].value].position;
    };
    const Point3 p = at(i + 1) - at(i), q = at(i + c.size() - 1) - at(i);
    least = std::min(least, angleBetween(p, q));
  }
  return least * 180 / std::numbers::pi;
}

/// Whether the angle between two edges is below kSharpAngle, or nearly so.
///
/// turned  the square of their cross product
bool isSharp(double along, double turned) {
  return along >= 0 && turned <= kSharpTangent * kSharpTangent * along * along;
}

/// Whether some angle is: nearly all are not.
bool hasSharpAngle(const Mesh& mesh, std::span<const VertexId> c) {
  const auto at = [&](std::size_t i) -> const Point3& {
    return mesh.vertices[c[i].value].position;
  };
  if (c.size() == 3) {
    const Point3 p = at(1) - at(0), q = at(2) - at(1), r = at(0) - at(2);
    const Point3 normal = cross(p, q);
    const double turned = dot(normal, normal);
    return isSharp(-dot(p, q), turned) || isSharp(-dot(q, r), turned) ||
           isSharp(-dot(r, p), turned);
  }
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Point3 p = at(i + 1 == c.size() ? 0 : i + 1) - at(i);
    const Point3 q = at(i == 0 ? c.size() - 1 : i - 1) - at(i);
    const Point3 normal = cross(p, q);
    if (isSharp(dot(p, q), dot(normal, normal))) return true;
  }
  return false;
}

/// All along its longest edge an element wants a share of that.
void openAngle(const Mesh& mesh, std::span<const VertexId> c, double share, const IsLeast& isLeast,
               std::vector<SizeSource>& places) {
  std::size_t longest = 0;
  const auto vertex = [&](std::size_t i) -> const SurfacePoint& {
    return mesh.vertices[c[i % c.size()].value];
  };
  const auto at = [&](std::size_t i) -> const Point3& { return vertex(i).position; };
  for (std::size_t i = 1; i < c.size(); ++i)
    if (distance(at(i), at(i + 1)) > distance(at(longest), at(longest + 1))) longest = i;
  if (isShortest(isLeast, vertex(longest), vertex(longest + 1))) return;
  const Point3 from = at(longest), along = at(longest + 1) - from;
  const double size = share * length(along);
  const double count = std::ceil(1 / (kOpeningSpacing * share));
  for (double k = 0; k < count && places.size() < kMaxPlacesAtFault; ++k)
    places.push_back({from + (k + 0.5) / count * along, size});
}

/// Above the longest edge of an element.
double heightOf(const Mesh& mesh, std::span<const VertexId> c) {
  const auto at = [&](std::size_t i) -> const Point3& {
    return mesh.vertices[c[i % c.size()].value].position;
  };
  double longest = 0;
  for (std::size_t i = 0; i < c.size(); ++i)
    longest = std::max(longest, distance(at(i), at(i + 1)));
  return length(cross(at(1) - at(0), at(2) - at(0))) / longest;
}

/// The corners of a face that are sharper than any element should be. In such a wedge all elements
/// are thin, however short their edges are.
class SharpCorners {
 public:
  SharpCorners(const Mesh& mesh, const FrontInput& boundary) : mesh_(mesh) {
    std::vector<int> uses(mesh.vertices.size(), 0);
    for (const Element& element : mesh.elements)
      for (const VertexId v : element.vertices()) ++uses[v.value];
    for (const auto& loop : boundary.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        if (uses[loop[i].vertex.value] == 1) add(loop, i);
  }

  /// Whether an element is as thin as the wedge that contains it.
  bool hold(std::span<const VertexId> c) const {
    return std::ranges::any_of(corners_, [&](const Corner& corner) {
      double far = 0;
      for (const VertexId v : c) far = std::max(far, distance(at(v), corner.place));
      const double width = corner.tangent * far, height = heightOf(mesh_, c);
      return height < kMaxInWedge * width && height > kMinInWedge * width;
    });
  }

 private:
  struct Corner {
    Point3 place;
    double tangent;
  };

  const Point3& at(VertexId v) const { return mesh_.vertices[v.value].position; }

  void add(const std::vector<BoundaryCorner>& loop, std::size_t i) {
    const double first = tangentAt(loop, i, 1), second = tangentAt(loop, i, 2);
    if (!(first > 0) || first >= kSharpTangent) return;
    // A wedge whose width decreases more slowly than the distance to its end has a blunt end: there
    // shorter edges give better elements.
    if (second < kBluntWedge * first) return;
    corners_.push_back({loop[i].point.position, first});
  }

  /// The tangent of the angle between two sides at a corner, each `steps` segments long; infinite
  /// above 90 degrees.
  static double tangentAt(const std::vector<BoundaryCorner>& loop, std::size_t i,
                          std::size_t steps) {
    const std::size_t n = loop.size();
    const Point3& place = loop[i].point.position;
    const Point3 p = loop[(i + steps) % n].point.position - place;
    const Point3 q = loop[(i + n - steps) % n].point.position - place;
    const double along = dot(p, q);
    return along > 0 ? length(cross(p, q)) / along : std::numeric_limits<double>::infinity();
  }

  const Mesh& mesh_;
  std::vector<Corner> corners_;
};

/// Elements that are looked at together.
constexpr std::size_t kAtOnce = 1 << 14;

/// In order, those with an angle below kSharpAngle, or nearly so: few.
std::vector<std::size_t> sharpElements(const Mesh& mesh) {
  const Ranges ranges(mesh.elements.size(), kAtOnce);
  std::vector<std::vector<std::size_t>> found(ranges.count());
  forEachInParallel(found.size(), 0, [&](std::size_t range) {
    for (const std::size_t i : ranges[range])
      if (hasSharpAngle(mesh, mesh.elements[i].vertices())) found[range].push_back(i);
  });
  std::vector<std::size_t> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

/// Edges as long as the height of the element allows at the wanted angle.
///
/// A few merely poor elements among very many do not count: to mesh the face again would cost more
/// than it could bring.
///
/// unseen  heights below this would take far too many elements
void openAngles(const Mesh& mesh, const FrontInput& boundary, double unseen, const IsLeast& isLeast,
                FaceDiagnosis& diagnosis) {
  std::optional<SharpCorners> corners;  // seldom asked for
  FaceDiagnosis found;
  std::size_t poor = 0;
  for (const std::size_t i : sharpElements(mesh)) {
    const auto c = mesh.elements[i].vertices();
    const double angle = leastAngle(mesh, c);
    if (angle >= kSharpAngle) continue;
    found.hasBadAngle = found.hasBadAngle || angle < kUselessAngle;
    if (!corners) corners.emplace(mesh, boundary);
    if (corners->hold(c) || heightOf(mesh, c) < unseen) continue;
    ++poor;
    found.isBad = found.isBad || angle < kUselessAngle;
    // The worst one counts: shorter edges make more of them, though better ones.
    found.poorness = std::max(found.poorness, logarithm(kSharpAngle / std::max(angle, 1e-6)));
    const double aim = std::clamp(kAngleOpening * angle, kMinOpenedAngle, kMaxOpenedAngle);
    openAngle(mesh, c, std::max(angle / aim, kMinOpeningShare), isLeast, found.places);
  }
  const bool isWorthIt = found.isBad || poor * kElementsForOnePoor >= mesh.elements.size();
  if (!isWorthIt) found = {{}, 0, false, found.hasBadAngle};
  diagnosis = std::move(found);
}

void addElements(const Mesh& mesh, double share, const IsLeast& isLeast,
                 std::vector<SizeSource>& places) {
  for (const Element& element : mesh.elements) {
    if (places.size() >= kMaxPlacesAtFault) return;
    const auto c = element.vertices();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const VertexId first = c[i], second = c[(i + 1) % c.size()];
      if (!(first < second)) continue;  // the element on the other side adds it
      const SurfacePoint &from = mesh.vertices[first.value], &to = mesh.vertices[second.value];
      if (!isShortest(isLeast, from, to)) addEdge(places, from.position, to.position, share);
    }
  }
}

}  // namespace

BoundaryPicture::BoundaryPicture(const ChartedSurface& surface, const FrontInput& boundary)
    : isPlane_(surface.isPlane()), axes_(boundary.loops[0][0].point) {
  if (isPlane_) return;
  double du = 0, dv = 0;
  std::size_t count = 0;
  for (const auto& loop : boundary.loops)
    for (const BoundaryCorner& corner : loop) {
      const auto frame = surface.inParameters()->frameAt(corner.point.u, corner.point.v);
      du += length(frame.du);
      dv += length(frame.dv);
      ++count;
    }
  u_ = du / static_cast<double>(count);
  v_ = (surface.inParameters()->isFlipped() ? -1 : 1) * dv / static_cast<double>(count);
}

Point2 BoundaryPicture::operator()(const SurfacePoint& point) const {
  return isPlane_ ? axes_(point) : Point2{u_ * point.u, v_ * point.v};
}

FaceDiagnosis diagnoseFailure(const ChartedSurface& surface, const FaceBoundary& boundary,
                              const std::vector<MeshingResult>& results) {
  FaceDiagnosis diagnosis;
  diagnosis.poorness = 1e300;
  diagnosis.isBad = true;
  const MeshBoundary kept = boundaryOf(boundary.input);
  for (const MeshingResult& result : results) {
    if (result.outcome == Outcome::Stuck) addStuck(result, diagnosis.places);
    addFaults(result, kept, diagnosis.places);
  }
  // Fronts that were stopped tell less: where edges had been refused until then.
  if (diagnosis.places.empty())
    for (const MeshingResult& result : results) addStuck(result, diagnosis.places);
  addCrossings(surface, boundary, diagnosis.places);
  return diagnosis;
}

FaceDiagnosis diagnoseMesh(const Mesh& mesh, const FaceBoundary& boundary, bool isPlane,
                           double area, double unseen, const IsLeast& isLeast) {
  FaceDiagnosis diagnosis;
  openAngles(mesh, boundary.input, unseen, isLeast, diagnosis);
  if (!(area > 0)) return diagnosis;
  const double ratio = areaOfElements(mesh) / area, error = std::abs(ratio - 1);
  if (!(error > kMaxAreaError)) return diagnosis;
  diagnosis.isBad = true;
  diagnosis.hasWrongArea = isWrongArea(ratio, mesh.elements.size());
  diagnosis.poorness += error / kMaxAreaError - 1;
  // What a chord cuts off goes with the third power of its length, their number with the first.
  const double share =
      std::clamp(std::sqrt(kAimedAreaError / error), kMinShareForArea, kMaxShareForArea);
  addBoundary(boundary.input, share, isLeast, diagnosis.places);
  if (!isPlane) addElements(mesh, share, isLeast, diagnosis.places);
  return diagnosis;
}

void askForRoom(const Mesh& mesh, const IsLeast& isLeast, FaceDiagnosis& diagnosis) {
  constexpr double kPoornessOfTriangle = 100;  // more than that of any angles
  for (const Element& element : mesh.elements) {
    if (element.isQuad()) continue;
    diagnosis.poorness += kPoornessOfTriangle;
    addSides(diagnosis.places, mesh, element, isLeast);
  }
}

double areaOfElements(const Mesh& mesh) {
  const Ranges ranges(mesh.elements.size(), kAtOnce);
  std::vector<double> areas(ranges.count(), 0);
  forEachInParallel(areas.size(), 0, [&](std::size_t range) {
    for (const std::size_t i : ranges[range]) areas[range] += areaOf(mesh, mesh.elements[i]);
  });
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

}  // namespace af2::geometry
