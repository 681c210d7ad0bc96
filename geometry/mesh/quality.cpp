#include "geometry/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "geometry/base/parallel.h"
#include "geometry/mesh/mesh_sides.h"

namespace af2::geometry {
namespace {

double squared(const Point3& p) { return dot(p, p); }

double triangleQuality(const Point3& a, const Point3& b, const Point3& c) {
  const double edges = squared(b - a) + squared(c - b) + squared(a - c);
  return edges > 0 ? 2 * std::sqrt(3.0) * length(cross(b - a, c - a)) / edges : 0;
}

/// Quality of the corner between the edges `p` and `q` of a quadrilateral with normal `normal`.
double cornerQuality(const Point3& p, const Point3& q, const Point3& normal) {
  const double edges = squared(p) + squared(q);
  if (edges == 0) return 0;
  const Point3 turn = cross(p, q);
  return std::copysign(2 * length(turn) / edges, dot(turn, normal));
}

double quadQuality(const std::array<Point3, 4>& corner) {
  const Point3 normal = cross(corner[2] - corner[0], corner[3] - corner[1]);
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 toNext = corner[(i + 1) % 4] - corner[i];
    const Point3 toLast = corner[(i + 3) % 4] - corner[i];
    least = std::min(least, cornerQuality(toNext, toLast, normal));
  }
  return least;
}

/// The angle at a corner of an element. Angles are compared without being computed.
struct Corner {
  double sine = 0, cosine = 1;  ///< times the lengths of both sides

  Corner(const Point3& p, const Point3& q) : sine(length(cross(p, q))), cosine(dot(p, q)) {}
  double degrees() const { return std::atan2(sine, cosine) * 180 / std::numbers::pi; }
  bool isSharperThan(const Corner& other) const {
    const double turn = other.sine * cosine - sine * other.cosine;
    return turn > 0 || (turn == 0 && cosine > 0 && other.cosine < 0);  // 0 and 180 degrees
  }
};

void measureAngles(const ModelMesh& mesh, MeshQuality& result) {
  std::optional<Corner> sharpest, bluntest;
  for (const Element& element : mesh.elements) {
    const std::size_t size = element.vertices().size();
    const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i % size].value]; };
    for (std::size_t i = 0; i < size; ++i) {
      const Corner here(at(i + 1) - at(i), at(i + size - 1) - at(i));
      if (!sharpest || here.isSharperThan(*sharpest)) sharpest = here;
      if (!bluntest || bluntest->isSharperThan(here)) bluntest = here;
    }
  }
  result.minAngle = sharpest->degrees();
  result.maxAngle = bluntest->degrees();
}

void measureShapes(const ModelMesh& mesh, MeshQuality& result) {
  std::vector<double> values;
  values.reserve(mesh.elements.size());
  for (const Element& element : mesh.elements) {
    values.push_back(shapeQuality(mesh.vertices, element));
  }
  const auto worst = std::ranges::min_element(values);
  result.min = *worst;
  const auto element = static_cast<std::size_t>(worst - values.begin());
  if (element < mesh.face.size()) result.worstFace = mesh.face[element];
  const auto corners = mesh.elements[element].vertices();
  for (const VertexId v : corners)
    result.worstPlace =
        result.worstPlace + 1.0 / static_cast<double>(corners.size()) * mesh.vertices[v.value];
  result.mean = std::reduce(values.begin(), values.end()) / static_cast<double>(values.size());
  result.p1 = percentile(values, 0.01);
}

void countFreeEdges(const MeshSides& sides, MeshQuality& result) {
  sides.forEachEdge([&](VertexId, std::span<const MeshSide> used) {
    if (used.size() == 1) ++result.freeEdges;
  });
}

/// Layers have the heights that were asked for, not the sizes.
bool isOfLayer(const ModelMesh& mesh, std::size_t element) {
  return element < mesh.origins.size() &&
         mesh.origins[element].rule + std::size_t{1} == mesh.ruleNames.size();
}

LengthRatio measureLengths(const ModelMesh& mesh, const MeshSides& sides) {
  LengthRatio result;
  if (mesh.wantedSizes.empty()) return result;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  result.leastLength = result.leastWanted = kFar;
  std::vector<double> ratios;  // nothing else is kept for each edge: there are millions
  ratios.reserve(sides.count() / 2 + mesh.segments.size());
  const auto isLayer = [&](const MeshSide& side) { return isOfLayer(mesh, side.element()); };
  const bool hasLayers = !mesh.ruleNames.empty() && mesh.ruleNames.back() == kLayerName;
  sides.forEachEdge([&](VertexId from, std::span<const MeshSide> used) {
    if (hasLayers && std::ranges::all_of(used, isLayer)) return;
    const std::uint32_t to = used.front().to;
    const double length = distance(mesh.vertices[from.value], mesh.vertices[to]);
    const double wanted = (mesh.wantedSizes[from.value] + mesh.wantedSizes[to]) / 2;
    result.leastLength = std::min(result.leastLength, length);
    result.mostLength = std::max(result.mostLength, length);
    result.leastWanted = std::min(result.leastWanted, wanted);
    result.mostWanted = std::max(result.mostWanted, wanted);
    ratios.push_back(length / wanted);
    const auto bin = std::ranges::upper_bound(LengthRatio::kBounds, ratios.back());
    ++result.histogram[static_cast<std::size_t>(bin - LengthRatio::kBounds.begin())];
  });
  if (ratios.empty()) return {};
  result.mean = std::reduce(ratios.begin(), ratios.end()) / static_cast<double>(ratios.size());
  result.p5 = percentile(ratios, 0.05);
  result.p95 = percentile(ratios, 0.95);
  return result;
}

}  // namespace

double shapeQuality(const std::vector<Point3>& vertices, const Element& element) {
  const auto corner = [&](std::size_t i) { return vertices[element.corners[i].value]; };
  if (!element.isQuad()) return triangleQuality(corner(0), corner(1), corner(2));
  return quadQuality({corner(0), corner(1), corner(2), corner(3)});
}

MeshQuality measureQuality(const ModelMesh& mesh, int threads) {
  MeshQuality result;
  if (mesh.elements.empty()) return result;
  forEachInParallel(3, threads, [&](std::size_t part) {
    if (part == 0) {
      const MeshSides sides(mesh);
      countFreeEdges(sides, result);
      result.edges = measureLengths(mesh, sides);
    }
    if (part == 1) measureShapes(mesh, result);
    if (part == 2) measureAngles(mesh, result);
  });
  return result;
}

double percentile(std::span<double> values, double part) {
  if (values.empty()) return 0;
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at, values.end());
  if (below + 1 == values.size()) return *at;
  const double next = *std::min_element(at + 1, values.end());
  return *at + (place - static_cast<double>(below)) * (next - *at);
}

}  // namespace af2::geometry
