#include "geometry/deviation/measured_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "engine/base/parallel.h"
#include "geometry/base/nearest_on_segment.h"

namespace af2::geometry {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The size aims below the bound: lengths of edges scatter around it.
constexpr double kAim = 0.9;

/// How far around the middle of an element its size is to be smaller, in longest sides: so that its
/// corners know of it.
constexpr double kReach = 0.7;

/// The size that brings what is `farthest` away within its bound. Lengths exceed sizes, so both
/// count.
template <class Vertices>
double smallerSize(const ModelMesh& mesh, const Vertices& vertices, double longest, double ratio) {
  double size = longest;
  for (const VertexId v : vertices) size = std::min(size, mesh.wantedSizes[v.value]);
  return kAim * size / std::sqrt(ratio);
}

/// Whether an element is clearly larger than was wanted there.
template <class Vertices>
bool isLong(const ModelMesh& mesh, const Vertices& vertices, double longest) {
  constexpr double kLong = 1.15;
  double wanted = kNone;
  for (const VertexId v : vertices) wanted = std::min(wanted, mesh.wantedSizes[v.value]);
  return longest > kLong * wanted;
}

struct OnFace {
  FarPoint farthest;
  double scatter = 0;
  std::vector<SizeSource> tooFar;
};

using Corners = std::vector<Point3>;

Corners cornersOf(const ModelMesh& mesh, const Element& element) {
  Corners corners;
  for (const VertexId v : element.vertices()) corners.push_back(mesh.vertices[v.value]);
  return corners;
}

FarPoint farthestOfElement(const Corners& p, FaceDistance& surface) {
  FarPoint farthest = farthestOf(p[0], p[1], p[2], surface);
  if (p.size() == 4) {
    const FarPoint other = farthestOf(p[0], p[2], p[3], surface);
    if (other.distance > farthest.distance) farthest = other;
  }
  return farthest;
}

double longestSide(const Corners& corners) {
  double longest = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    longest = std::max(longest, distance(corners[i], corners[(i + 1) % corners.size()]));
  return longest;
}

Point3 middleOf(const Corners& corners) {
  Point3 sum;
  for (const Point3& p : corners) sum = sum + p;
  return 1.0 / static_cast<double>(corners.size()) * sum;
}

/// No size brings an element nearer than its corners, which are on edges of the model that are off
/// the surface.
bool areCornersOff(const Corners& corners, double bound, FaceDistance& surface) {
  constexpr double kShare = 0.75;
  return std::ranges::any_of(corners,
                             [&](const Point3& p) { return surface.of(p) > kShare * bound; });
}

OnFace measureFace(const ModelMesh& mesh, const std::vector<std::size_t>& elements,
                   FaceDistance& surface, double bound) {
  OnFace result;
  for (const std::size_t e : elements) {
    const Corners corners = cornersOf(mesh, mesh.elements[e]);
    const FarPoint farthest = farthestOfElement(corners, surface);
    if (farthest.distance > result.farthest.distance) result.farthest = farthest;
    if (!(farthest.distance > bound) || areCornersOff(corners, bound, surface)) continue;
    const auto vertices = mesh.elements[e].vertices();
    const double longest = longestSide(corners), ratio = farthest.distance / bound;
    if (isLong(mesh, vertices, longest)) {
      result.scatter = std::max(result.scatter, ratio);
      continue;
    }
    const double size = smallerSize(mesh, vertices, longest, ratio);
    result.tooFar.push_back({middleOf(corners), size, kReach * longest});
  }
  return result;
}

/// Adds what was found at a segment.
void measureSegment(const ModelMesh& mesh, std::size_t s, const std::vector<Point3>& curve,
                    double bound, Deviations& all) {
  const EdgeSegment& segment = mesh.segments[s];
  const Point3 &from = mesh.vertices[segment.from.value], &to = mesh.vertices[segment.to.value];
  FarPoint farthest;
  for (const Point3& p : curve) {
    const double gap = distance(p, nearestOnSegment(p, from, to));
    if (gap > farthest.distance) farthest = {gap, p};
  }
  if (farthest.distance > all.largest.largest)
    all.largest = {farthest.distance, farthest.place, 0, segment.edge};
  all.excess = std::max(all.excess, farthest.distance / bound);
  if (farthest.distance > bound)
    all.tooFar.push_back({0.5 * (from + to),
                          smallerSize(mesh, std::array{segment.from, segment.to},
                                      distance(from, to), farthest.distance / bound),
                          kReach * distance(from, to)});
}

}  // namespace

FarPoint farthestOf(const Point3& a, const Point3& b, const Point3& c, FaceDistance& surface) {
  constexpr int kParts = 4;  // of each side
  FarPoint farthest;
  const auto look = [&](const Point3& p) {
    if (const double gap = surface.of(p); gap > farthest.distance) farthest = {gap, p};
  };
  for (int i = 0; i <= kParts; ++i)
    for (int j = 0; i + j <= kParts; ++j) {
      const int k = kParts - i - j;
      if (i == kParts || j == kParts || k == kParts) continue;
      look(1.0 / kParts * (double(i) * a + double(j) * b + double(k) * c));
    }
  look(1.0 / 3 * (a + b + c));
  return farthest;
}

std::vector<double> boundsOfSegments(const ModelMesh& mesh,
                                     const std::function<double(int face)>& boundOf) {
  std::map<std::pair<VertexId, VertexId>, double> bounds;
  for (const EdgeSegment& segment : mesh.segments)
    bounds[std::minmax(segment.from, segment.to)] = kNone;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto corners = mesh.elements[e].vertices();
    const double bound = boundOf(mesh.face[e]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto found = bounds.find(std::minmax(corners[i], corners[(i + 1) % corners.size()]));
      if (found != bounds.end()) found->second = std::min(found->second, bound);
    }
  }
  std::vector<double> result;
  for (const EdgeSegment& segment : mesh.segments)
    result.push_back(bounds[std::minmax(segment.from, segment.to)]);
  return result;
}

Deviations measureDeviations(ModelMesh& mesh, const EdgeCurves& curves, const DeviationTask& task) {
  std::map<int, std::vector<std::size_t>> elements;  // by face
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) elements[mesh.face[e]].push_back(e);
  std::vector<OnFace> found(mesh.faces.size());
  forEachInParallel(mesh.faces.size(), task.threads, [&](std::size_t i) {
    const int face = mesh.faces[i].id;
    const auto own = elements.find(face);
    if (own == elements.end()) return;
    if (const auto surface = task.distanceFrom(face))
      found[i] = measureFace(mesh, own->second, *surface, task.boundOf(face));
  });
  Deviations all;
  for (std::size_t i = 0; i < found.size(); ++i) {
    FaceReport& face = mesh.faces[i];
    if (!elements.contains(face.id)) continue;
    const FarPoint& farthest = found[i].farthest;
    face.deviation = farthest.distance;
    all.excess = std::max(all.excess, farthest.distance / task.boundOf(face.id));
    if (farthest.distance > all.largest.largest)
      all.largest = {farthest.distance, farthest.place, face.id, 0};
    if (found[i].scatter > 0) all.scatter[face.id] = found[i].scatter;
    all.tooFar.insert(all.tooFar.end(), found[i].tooFar.begin(), found[i].tooFar.end());
  }
  for (std::size_t s = 0; s < mesh.segments.size(); ++s)
    measureSegment(mesh, s, curves[s], task.boundsOfSegments[s], all);
  return all;
}

}  // namespace af2::geometry
