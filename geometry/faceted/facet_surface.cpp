#include "geometry/faceted/facet_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "geometry/base/plane_axes.h"
#include "geometry/faceted/facet_layout.h"
#include "geometry/faceted/flattening.h"
#include "geometry/faceted/half_edges.h"
#include "geometry/faceted/nearest_in_triangle.h"

namespace af2::geometry {
namespace {

using Corners = std::array<std::uint32_t, 3>;

}  // namespace

struct FacetSurface::Data {
  Data(const PatchedFacets& patched, const Patch& patch, Drawing drawing)
      : tree(takeTriangles(patched.facets, patch)) {
    for (const std::uint32_t t : patch.triangles) directions.push_back(patched.normals[t]);
    findNormals();
    findCurvatures();
    twins = orientedTwins(triangles);
    if (drawing == Drawing::None) return;
    if (auto places = flatten(vertices, triangles))
      layout.emplace(*std::move(places), vertices, triangles);
  }

  std::vector<Box3> takeTriangles(const Facets& facets, const Patch& patch) {
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

  /// Weighted by the angles of the triangles, but thin ones count less: the direction of a sliver
  /// is what is left of rounding and noise.
  void findNormals() {
    constexpr double kThin = 0.1;  // height over longest edge
    normals.resize(vertices.size());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const Corners& t = triangles[k];
      const Point3 area = areaVector(t);
      double longest = 0;
      for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, distance(vertices[t[i]], vertices[t[(i + 1) % 3]]));
      const double slenderness = longest > 0 ? 2 * length(area) / (longest * longest) : 0;
      const double trust = slenderness / (slenderness + kThin);
      for (std::size_t i = 0; i < 3; ++i) {
        const Point3 p = vertices[t[(i + 1) % 3]] - vertices[t[i]];
        const Point3 q = vertices[t[(i + 2) % 3]] - vertices[t[i]];
        const double angle = angleBetween(p, q);
        normals[t[i]] = normals[t[i]] + (trust * angle) * directions[k];
      }
    }
    for (Point3& normal : normals) normal = unit(normal);
  }

  /// How the normal changes along the surface, as a matrix: its mean over the triangles around a
  /// vertex, by their areas, in which noise cancels out. What counts is its largest stretch.
  void findCurvatures() {
    using Matrix = std::array<Point3, 3>;  // rows
    std::vector<Matrix> sums(vertices.size());
    std::vector<double> areas(vertices.size(), 0);
    for (const Corners& t : triangles) {
      const Point3 u = vertices[t[1]] - vertices[t[0]], v = vertices[t[2]] - vertices[t[0]];
      const Point3 n = cross(u, v);
      const double square = dot(n, n);
      if (!(square > 0)) continue;
      // Vectors in the triangle with which those along its sides make 1 and 0.
      const Point3 alongU = (1 / square) * cross(v, n), alongV = (1 / square) * cross(n, u);
      const Point3 du = normals[t[1]] - normals[t[0]], dv = normals[t[2]] - normals[t[0]];
      const double area = std::sqrt(square) / 2;
      const Matrix change{du.x * alongU + dv.x * alongV, du.y * alongU + dv.y * alongV,
                          du.z * alongU + dv.z * alongV};
      for (const std::uint32_t c : t) {
        for (std::size_t row = 0; row < 3; ++row) sums[c][row] = sums[c][row] + area * change[row];
        areas[c] += area;
      }
    }
    for (std::size_t v = 0; v < vertices.size(); ++v)
      curvatures.push_back(areas[v] > 0 ? stretchOf(sums[v]) / areas[v] : 0);
  }

  /// The largest stretch of a matrix, by applying it and its transpose some times.
  static double stretchOf(const std::array<Point3, 3>& rows) {
    constexpr int kTimes = 12;
    double largest = 0;
    for (const Point3& start : rows) largest = std::max(largest, dot(start, start));
    if (!(largest > 0)) return 0;
    Point3 x = rows[0] + rows[1] + rows[2];
    for (const Point3& row : rows)
      if (dot(row, row) == largest) x = row;  // the last of equals; never across the direction
    double stretch = 0;
    for (int i = 0; i < kTimes; ++i) {
      x = unit(x);
      const Point3 y{dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)};
      stretch = length(y);
      x = y.x * rows[0] + y.y * rows[1] + y.z * rows[2];
    }
    return stretch;
  }

  SurfacePoint pointIn(std::uint32_t triangle, const Barycentric& w) const {
    const auto& [a, b, c] = triangles[triangle];
    SurfacePoint point;
    point.position = w.a * vertices[a] + w.b * vertices[b] + w.c * vertices[c];
    point.normal = unit(w.a * normals[a] + w.b * normals[b] + w.c * normals[c]);
    if (layout) {
      const Point2 place = layout->placeIn(triangle, w);
      point.u = place.x;
      point.v = place.y;
    } else {
      point.u = triangle;  // whoever looks for a point near this one begins there
    }
    return point;
  }
  std::uint32_t triangleOf(const SurfacePoint& point) const {
    if (layout) return layout->at({point.u, point.v}).triangle;
    const bool isKnown = point.u >= 0 && point.u < static_cast<double>(triangles.size());
    return isKnown ? static_cast<std::uint32_t>(point.u) : BoxTree::kNone;
  }

  /// How a walk over the triangles to a line came out.
  struct Walk {
    enum Outcome { Found, AtBorder, AtFold } outcome = AtFold;
    std::uint32_t triangle = 0;
    Barycentric where;
  };

  /// From the base edge over sides of triangles towards the line, as long as these face the chart:
  /// so that what is found is on the same sheet of the surface.
  Walk walk(const SurfaceLine& line, const SurfacePoint& from) const {
    constexpr int kMaxSteps = 2000;
    Walk walk;
    std::uint32_t t = triangleOf(from);
    if (t == BoxTree::kNone) return walk;
    std::uint32_t before = BoxTree::kNone;
    for (int step = 0; step < kMaxSteps; ++step) {
      const std::array<double, 3> beside = sidesOf(line, t);
      const double area = beside[0] + beside[1] + beside[2];
      const double rim = -1e-9 * area;
      if (area > 0 && beside[0] >= rim && beside[1] >= rim && beside[2] >= rim)
        return {Walk::Found, t, {beside[1] / area, beside[2] / area, beside[0] / area}};
      std::uint32_t next = BoxTree::kNone;
      double farthest = 0;
      bool isAtBorder = false;
      for (std::uint32_t side = 0; side < 3; ++side) {
        if (!(beside[side] < farthest)) continue;
        const HalfEdge twin = twins[3 * t + side];
        const std::uint32_t other = twin / 3;
        if (twin == kNoHalfEdge) isAtBorder = true;
        if (twin == kNoHalfEdge || other == before || !faces(line, other)) continue;
        farthest = beside[side];
        next = other;
      }
      if (next == BoxTree::kNone) {
        walk.outcome = isAtBorder ? Walk::AtBorder : Walk::AtFold;
        return walk;
      }
      before = t;
      t = next;
    }
    return walk;
  }

  /// Twice the areas, seen along the line, of the triangles that its foot makes with the sides:
  /// negative where it is beyond the side.
  std::array<double, 3> sidesOf(const SurfaceLine& line, std::uint32_t t) const {
    std::array<Point2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 d = vertices[triangles[t][i]] - line.start;
      p[i] = {dot(d, line.xAxis), dot(d, line.yAxis)};
    }
    return {cross(p[0], p[1]), cross(p[1], p[2]), cross(p[2], p[0])};
  }
  bool faces(const SurfaceLine& line, std::uint32_t t) const {
    return dot(areaVector(triangles[t]), line.direction) > 0;
  }

  Barycentric nearestTo(const Point3& p, std::uint32_t triangle) const {
    const auto& [a, b, c] = triangles[triangle];
    return nearestIn(p, vertices[a], vertices[b], vertices[c]);
  }

  std::uint32_t nearestTriangle(const Point3& p) const {
    return tree.nearest(p, std::numeric_limits<double>::infinity(), [&](std::uint32_t t) {
      const Barycentric w = nearestTo(p, t);
      const auto& [a, b, c] = triangles[t];
      return distance(p, w.a * vertices[a] + w.b * vertices[b] + w.c * vertices[c]);
    });
  }

  std::vector<std::uint32_t> used;  // by vertex: that of the facets
  std::vector<Point3> vertices, normals;
  std::vector<Point3> directions;  // by triangle: the basis of the normals
  std::vector<double> curvatures;
  std::vector<Corners> triangles;
  std::vector<HalfEdge> twins;
  std::optional<FacetLayout> layout;
  BoxTree tree;  // last: it is made while the triangles are taken
};

FacetSurface::FacetSurface(const PatchedFacets& patched, const Patch& patch, Drawing drawing)
    : data_(std::make_shared<const Data>(patched, patch, drawing)) {}

bool FacetSurface::isOf(const PatchedFacets& patched, const Patch& patch) const {
  if (patch.triangles.size() != triangleCount()) return false;
  for (std::size_t k = 0; k < triangleCount(); ++k) {
    const std::uint32_t t = patch.triangles[k];
    const Corners& corners = patched.facets.triangles[t];
    if (verticesOf(k) != corners || data_->directions[k] != patched.normals[t]) return false;
    const std::array<Point3, 3> positions = positionsOf(k);
    for (std::size_t i = 0; i < 3; ++i)
      if (positions[i] != patched.facets.vertices[corners[i]]) return false;
  }
  return true;
}

bool FacetSurface::isDrawn() const { return data_->layout.has_value(); }

SurfacePoint FacetSurface::pointAt(double u, double v) const {
  const FacetLayout::Found found = data_->layout->at({u, v});
  SurfacePoint point = data_->pointIn(found.triangle, found.where);
  point.u = u;  // beyond the boundary, too, so that no two places become one
  point.v = v;
  return point;
}

SurfaceFrame FacetSurface::frameAt(double u, double v) const {
  const FacetLayout::Found found = data_->layout->at({u, v});
  const SurfacePoint point = data_->pointIn(found.triangle, found.where);
  const Metric metric = data_->layout->metricAt(found);
  const PlaneAxes axes(point.position, point.normal);
  if (!(metric.uu > 0) || !std::isfinite(metric.vv))
    throw GeometryError("the layout of the patch in a plane is degenerate here");
  const double du = std::sqrt(metric.uu), along = metric.uv / du;
  const double across = std::sqrt(std::max(metric.vv - along * along, 0.0));
  return {point.position, du * axes.xAxis(), along * axes.xAxis() + across * axes.yAxis()};
}

std::optional<SurfacePoint> FacetSurface::hit(const SurfaceLine& line) const {
  constexpr double kReach = 2.5, kNear = 0.5;  // in wanted edge lengths
  bool isAtBorder = false;
  constexpr double kRim = 1e-9;  // so that no line slips between two triangles
  for (const SurfacePoint* from : {&line.from, &line.to}) {
    const Data::Walk walk = data_->walk(line, *from);
    if (walk.outcome == Data::Walk::Found) return data_->pointIn(walk.triangle, walk.where);
    isAtBorder = isAtBorder || walk.outcome == Data::Walk::AtBorder;
  }
  // Across a hole the surface may go on; beyond a fold, what is far is another sheet.
  const double reach = (isAtBorder ? kReach : kNear) * line.edgeLength;
  const Segment3 way(line.start - reach * line.direction, line.start + reach * line.direction);
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

SurfacePoint FacetSurface::nearestOn(std::uint32_t triangle, const Point3& position) const {
  return data_->pointIn(triangle, data_->nearestTo(position, triangle));
}

FacetSurface::Place FacetSurface::placeOf(const SurfacePoint& point) const {
  if (data_->layout) {
    const FacetLayout::Found found = data_->layout->at({point.u, point.v});
    return {found.triangle, {found.where.a, found.where.b, found.where.c}};
  }
  const std::uint32_t triangle = data_->triangleOf(point);
  const Barycentric where = data_->nearestTo(point.position, triangle);
  return {triangle, {where.a, where.b, where.c}};
}

double FacetSurface::interpolated(const std::vector<double>& values, const Point3& position) const {
  const std::uint32_t triangle = data_->nearestTriangle(position);
  const Barycentric w = data_->nearestTo(position, triangle);
  const auto& [a, b, c] = data_->triangles[triangle];
  const auto at = [&](std::uint32_t v) { return values[data_->used[v]]; };
  return w.a * at(a) + w.b * at(b) + w.c * at(c);
}

const std::vector<std::uint32_t>& FacetSurface::usedVertices() const { return data_->used; }
const std::vector<double>& FacetSurface::curvatures() const { return data_->curvatures; }
std::size_t FacetSurface::triangleCount() const { return data_->triangles.size(); }

std::array<std::uint32_t, 3> FacetSurface::verticesOf(std::size_t triangle) const {
  const auto& [a, b, c] = data_->triangles[triangle];
  return {data_->used[a], data_->used[b], data_->used[c]};
}

std::array<Point3, 3> FacetSurface::positionsOf(std::size_t triangle) const {
  const auto& [a, b, c] = data_->triangles[triangle];
  return {data_->vertices[a], data_->vertices[b], data_->vertices[c]};
}

std::optional<FlatSurface> FacetSurface::plane() const {
  constexpr double kFlat = 1e-7;    // of its extent
  constexpr double kFolded = 0.01;  // of its area: programs leave slivers that lie on others
  Point3 sum;
  Box3 box;
  for (const Corners& t : data_->triangles) sum = sum + data_->areaVector(t);
  for (const Point3& v : data_->vertices) box.add(v);
  const double extent = distance(box.low, box.high);
  const Point3 normal = unit(sum), origin = data_->vertices.front();
  if (normal == Point3{}) return std::nullopt;
  for (const Point3& v : data_->vertices)
    if (!(std::abs(dot(v - origin, normal)) <= kFlat * extent)) return std::nullopt;
  if (length(sum) < (1 - 2 * kFolded) * area()) return std::nullopt;
  const PlaneAxes axes(origin, normal);
  return FlatSurface(origin, axes.xAxis(), axes.yAxis());
}

double FacetSurface::projectedArea() const {
  Point3 sum;
  for (const Corners& t : data_->triangles) sum = sum + data_->areaVector(t);
  return length(sum);
}

double FacetSurface::area() const {
  double area = 0;
  for (const Corners& t : data_->triangles) area += length(data_->areaVector(t));
  return area;
}

}  // namespace af2::geometry
