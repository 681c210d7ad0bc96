#include "geometry/faceted/facet_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace af2::geometry {
namespace {

using Corners = std::array<std::uint32_t, 3>;

struct Barycentric {
  double a = 1, b = 0, c = 0;
};

/// The point of a triangle that is nearest to p: by the region of the plane in which p lies.
Barycentric nearestIn(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
  const Point3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp),
               d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double t = (d4 - d3) / (d4 - d3 + d5 - d6);
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  if (sum == 0) return {1, 0, 0};
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace

struct FacetSurface::Data {
  Data(const Facets& facets, const Patch& patch) : tree(takeTriangles(facets, patch)) {
    findNormals();
    findCurvatures();
  }

  std::vector<Box3> takeTriangles(const Facets& facets, const Patch& patch) {
    std::vector<std::uint32_t> used;
    for (const std::uint32_t t : patch.triangles)
      used.insert(used.end(), facets.triangles[t].begin(), facets.triangles[t].end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t v : used) vertices.push_back(facets.vertices[v]);
    std::vector<Box3> boxes;
    for (const std::uint32_t t : patch.triangles) {
      Corners corners = facets.triangles[t];
      boxes.emplace_back();
      for (std::uint32_t& v : corners) {
        boxes.back().add(facets.vertices[v]);
        v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) -
                                       used.begin());
      }
      triangles.push_back(corners);
    }
    return boxes;
  }

  Point3 areaVector(const Corners& t) const {
    return 0.5 * cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]);
  }

  void findNormals() {
    normals.resize(vertices.size());
    for (const Corners& t : triangles) {
      const Point3 normal = unit(areaVector(t));
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3 p = vertices[t[(i + 1) % 3]] - vertices[t[i]];
        const Point3 q = vertices[t[(i + 2) % 3]] - vertices[t[i]];
        const double angle = std::atan2(length(cross(p, q)), dot(p, q));
        normals[t[i]] = normals[t[i]] + angle * normal;
      }
    }
    for (Point3& normal : normals) normal = unit(normal);
  }

  void findCurvatures() {
    curvatures.assign(vertices.size(), 0);
    for (const Corners& t : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        const double turn = distance(normals[a], normals[b]) / distance(vertices[a], vertices[b]);
        curvatures[a] = std::max(curvatures[a], turn);
        curvatures[b] = std::max(curvatures[b], turn);
      }
    }
  }

  SurfacePoint pointIn(std::uint32_t triangle, const Barycentric& w) const {
    const auto& [a, b, c] = triangles[triangle];
    SurfacePoint point;
    point.position = w.a * vertices[a] + w.b * vertices[b] + w.c * vertices[c];
    point.normal = unit(w.a * normals[a] + w.b * normals[b] + w.c * normals[c]);
    return point;
  }

  Barycentric nearestTo(const Point3& p, std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles[triangle];
    return nearestIn(p, vertices[a], vertices[b], vertices[c]);
  }

  std::uint32_t nearestTriangle(const Point3& p) const {
    return tree.nearest(p, std::numeric_limits<double>::infinity(), [&](std::uint32_t t) {
      return distance(p, pointIn(t, nearestTo(p, t)).position);
    });
  }

  std::vector<Point3> vertices, normals;
  std::vector<double> curvatures;
  std::vector<Corners> triangles;
  BoxTree tree;  // last: it is made while the triangles are taken
};

FacetSurface::FacetSurface(const Facets& facets, const Patch& patch)
    : data_(std::make_shared<const Data>(facets, patch)) {}

std::optional<SurfacePoint> FacetSurface::hit(const SurfaceLine& line) const {
  constexpr double kReach = 2.5, kNear = 0.5;  // in wanted edge lengths
  constexpr double kRim = 1e-9;                // so that no line slips between two triangles
  const double reach = kReach * line.edgeLength;
  Box3 way;
  way.add(line.start + reach * line.direction);
  way.add(line.start - reach * line.direction);
  double best = reach;
  std::optional<SurfacePoint> hit;
  data_->tree.forEachIn(way, [&](std::uint32_t t) {
    const auto& [a, b, c] = data_->triangles[t];
    const Point3 origin = data_->vertices[a];
    const Point3 u = data_->vertices[b] - origin, v = data_->vertices[c] - origin;
    const Point3 p = cross(line.direction, v);
    const double det = dot(u, p);
    if (det == 0) return;
    const Point3 s = line.start - origin, q = cross(s, u);
    const double x = dot(s, p) / det, y = dot(line.direction, q) / det, along = dot(v, q) / det;
    if (x < -kRim || y < -kRim || x + y > 1 + kRim || std::abs(along) >= best) return;
    SurfacePoint point = data_->pointIn(t, {1 - x - y, x, y});
    if (dot(point.normal, line.direction) <= 0) return;  // another sheet
    best = std::abs(along);
    hit = point;
  });
  if (hit) return hit;
  const SurfacePoint beside = nearest(line.start);
  if (distance(beside.position, line.start) > kNear * line.edgeLength) return std::nullopt;
  return beside;
}

SurfacePoint FacetSurface::nearest(const Point3& position) const {
  const std::uint32_t triangle = data_->nearestTriangle(position);
  return data_->pointIn(triangle, data_->nearestTo(position, triangle));
}

double FacetSurface::radiusAt(const Point3& position) const {
  const std::uint32_t triangle = data_->nearestTriangle(position);
  const Barycentric w = data_->nearestTo(position, triangle);
  const auto& [a, b, c] = data_->triangles[triangle];
  const double turn =
      w.a * data_->curvatures[a] + w.b * data_->curvatures[b] + w.c * data_->curvatures[c];
  return turn > 0 ? 1 / turn : std::numeric_limits<double>::infinity();
}

double FacetSurface::area() const {
  double area = 0;
  for (const Corners& t : data_->triangles) area += length(data_->areaVector(t));
  return area;
}

}  // namespace af2::geometry
