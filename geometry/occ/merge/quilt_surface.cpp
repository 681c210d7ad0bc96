#include "geometry/occ/merge/quilt_surface.h"

#include <BRepClass_FaceClassifier.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>

#include "engine/base/error.h"

namespace af2::geometry {

namespace {

using SideOfTriangle = std::pair<std::uint32_t, std::uint32_t>;

/// The unit normals of triangles; on narrow faces those of the faces beside them, which spread from
/// triangle to triangle.
std::vector<Point3> normalsOf(const BackgroundFacets& background,
                              const std::vector<std::uint32_t>& triangles,
                              const FaceGrouping& grouping) {
  std::vector<Point3> normals;
  std::map<SideOfTriangle, std::size_t> bySide;
  std::deque<std::size_t> toSpread;
  std::vector<bool> isKnown;
  const auto isNarrow = [&](std::size_t i) {
    const int face = background.face[triangles[i]];
    return grouping.isNarrow[static_cast<std::size_t>(face) - 1];
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = background.triangles[triangles[i]];
    const Point3& origin = background.vertices[a];
    normals.push_back(
        unit(cross(background.vertices[b] - origin, background.vertices[c] - origin)));
    for (const SideOfTriangle& side : {SideOfTriangle{a, b}, {b, c}, {c, a}}) bySide[side] = i;
    isKnown.push_back(!isNarrow(i));
    if (!isNarrow(i)) toSpread.push_back(i);
  }
  while (!toSpread.empty()) {
    const std::size_t i = toSpread.front();
    toSpread.pop_front();
    const auto& [a, b, c] = background.triangles[triangles[i]];
    for (const SideOfTriangle& twin : {SideOfTriangle{b, a}, {c, b}, {a, c}}) {
      const auto beside = bySide.find(twin);
      if (beside == bySide.end() || isKnown[beside->second]) continue;
      isKnown[beside->second] = true;
      normals[beside->second] = normals[i];
      toSpread.push_back(beside->second);
    }
  }
  return normals;
}

/// Moves a point of a surface to where a line meets it, if that is not far: the triangles that led
/// to the point are off the surface.
void drawToLine(const SurfaceLine& line, const GeneralSurface& surface, SurfacePoint& point) {
  constexpr double kNear = 2e-3;  // in wanted edge lengths, as on single faces
  constexpr int kMaxSteps = 3;
  double last = std::numeric_limits<double>::infinity();
  SurfacePoint at = point;
  for (int step = 0; step <= kMaxSteps; ++step) {
    const SurfaceFrame s = surface.frameAt(at.u, at.v);
    const Point3 r = line.start - s.position;
    const double rx = dot(r, line.xAxis), ry = dot(r, line.yAxis);
    const double gap = std::abs(rx) + std::abs(ry);
    if (!(gap < last)) return;
    if (step > 0) point = surface.pointAt(at.u, at.v);
    if (gap <= kNear * line.edgeLength) return;
    last = gap;
    const double a = dot(s.du, line.xAxis), b = dot(s.dv, line.xAxis);
    const double c = dot(s.du, line.yAxis), d = dot(s.dv, line.yAxis);
    const double det = a * d - b * c;
    if (det == 0) return;
    at.u += (d * rx - b * ry) / det;
    at.v += (a * ry - c * rx) / det;
  }
}

}  // namespace

QuiltParts quiltPartsOf(std::shared_ptr<const ModelShape> model, const BackgroundFacets& background,
                        const std::vector<std::uint32_t>& triangles, std::vector<int> faces,
                        const FaceGrouping& grouping) {
  constexpr std::size_t kMaxDrawn = 4000;
  PatchedFacets patched;
  patched.facets.vertices = background.vertices;
  Patch patch;
  std::vector<std::size_t> faceOf;
  std::vector<std::array<Point2, 3>> parameters;
  for (const std::uint32_t t : triangles) {
    patch.triangles.push_back(static_cast<std::uint32_t>(patched.facets.triangles.size()));
    patched.facets.triangles.push_back(background.triangles[t]);
    const auto face = std::ranges::lower_bound(faces, background.face[t]);
    faceOf.push_back(static_cast<std::size_t>(face - faces.begin()));
    parameters.push_back(background.parameters[t]);
  }
  patched.normals = normalsOf(background, triangles, grouping);
  std::vector<bool> isNarrow;
  for (const int face : faces)
    isNarrow.push_back(grouping.isNarrow[static_cast<std::size_t>(face) - 1]);
  std::map<SideOfTriangle, std::uint32_t> bySide;
  const auto sidesOf = [&](std::size_t t) {
    const auto& [a, b, c] = patched.facets.triangles[t];
    return std::array<SideOfTriangle, 3>{{{a, b}, {b, c}, {c, a}}};
  };
  for (std::uint32_t t = 0; t < faceOf.size(); ++t)
    for (const SideOfTriangle& side : sidesOf(t)) bySide[side] = t;
  std::vector<std::vector<std::uint32_t>> beside(faceOf.size());
  for (std::size_t t = 0; t < faceOf.size(); ++t)
    for (const auto& [from, to] : sidesOf(t)) {
      const auto twin = bySide.find({to, from});
      if (twin != bySide.end() && faceOf[twin->second] != faceOf[t])
        beside[t].push_back(twin->second);
    }
  const auto drawing = triangles.size() <= kMaxDrawn ? FacetSurface::Drawing::IfPossible
                                                     : FacetSurface::Drawing::None;
  return {std::move(model),      FacetSurface(patched, patch, drawing),
          std::move(faces),      std::move(faceOf),
          std::move(parameters), std::move(beside),
          std::move(isNarrow)};
}

QuiltSurface::QuiltSurface(std::shared_ptr<const QuiltParts> parts)
    : parts_(std::move(parts)), surfaces_(parts_->faces.size()) {}

const FaceSurface& QuiltSurface::surfaceOf(std::size_t index) const {
  auto& surface = surfaces_[index];
  if (!surface)
    surface = std::make_unique<const FaceSurface>(parts_->model->surface(parts_->faces[index]));
  return *surface;
}

Point2 QuiltSurface::parametersAt(const FacetSurface::Place& place) const {
  const auto& at = parts_->parameters[place.triangle];
  const auto& w = place.weights;
  return w[0] * at[0] + w[1] * at[1] + w[2] * at[2];
}

QuiltSurface::OnFace QuiltSurface::onFace(const SurfacePoint& point) const {
  const FacetSurface::Place place = parts_->facets.placeOf(point);
  const std::size_t index = parts_->faceOf[place.triangle];
  const Point2 uv = parametersAt(place);
  return {index, surfaceOf(index).inOccParameters().pointAt(uv.x, uv.y)};
}

SurfacePoint QuiltSurface::lifted(SurfacePoint point) const { return lifted(point, onFace(point)); }

SurfacePoint QuiltSurface::lifted(SurfacePoint point, const OnFace& on) const {
  point.position = on.point.position;
  if (!parts_->isNarrow[on.index] && on.point.normal != Point3{}) point.normal = on.point.normal;
  return point;
}

SurfacePoint QuiltSurface::pointAt(double u, double v) const {
  return lifted(parts_->facets.pointAt(u, v));
}

std::optional<SurfacePoint> QuiltSurface::hit(const SurfaceLine& line) const {
  const std::optional<SurfacePoint> found = parts_->facets.hit(line);
  if (!found) return std::nullopt;
  OnFace on = onFace(*found);
  drawToLine(line, surfaceOf(on.index).inOccParameters(), on.point);
  return lifted(*found, on);
}

SurfacePoint QuiltSurface::nearest(const Point3& position) const {
  return lifted(parts_->facets.nearest(position));
}

SurfacePoint QuiltSurface::nearestAmong(std::span<const std::uint32_t> triangles,
                                        const Point3& position) const {
  double least = std::numeric_limits<double>::infinity();
  SurfacePoint best;
  for (const std::uint32_t t : triangles) {
    const SurfacePoint point = parts_->facets.nearestOn(t, position);
    const double gap = distance(point.position, position);
    if (!(gap < least)) continue;
    least = gap;
    best = point;
  }
  return lifted(best);
}

double QuiltSurface::distanceFrom(const Point3& position) const {
  const OnFace on = onFace(parts_->facets.nearest(position));
  const GeneralSurface& surface = surfaceOf(on.index).inOccParameters();
  double u = on.point.u, v = on.point.v;
  surface.refine(position, u, v);
  return std::min(distance(on.point.position, position),
                  distance(surface.frameAt(u, v).position, position));
}

Point3 QuiltSurface::settled(const Point3& position) const {
  const auto footOn = [&](std::uint32_t triangle) {
    const FacetSurface::Place place =
        parts_->facets.placeOf(parts_->facets.nearestOn(triangle, position));
    Point2 uv = parametersAt({triangle, place.weights});
    const GeneralSurface& surface = surfaceOf(parts_->faceOf[triangle]).inOccParameters();
    surface.refine(position, uv.x, uv.y);
    return std::pair(uv, surface.frameAt(uv.x, uv.y).position);
  };
  const auto isOn = [&](std::uint32_t triangle, Point2 uv) {
    const TopoDS_Face face =
        TopoDS::Face(parts_->model->face(parts_->faces[parts_->faceOf[triangle]]));
    BRepClass_FaceClassifier classifier(face, gp_Pnt2d(uv.x, uv.y), BRep_Tool::Tolerance(face));
    return classifier.State() != TopAbs_OUT;
  };
  const SurfacePoint nearest = parts_->facets.nearest(position);
  const std::uint32_t here = parts_->facets.placeOf(nearest).triangle;
  if (parts_->beside[here].empty() || isOn(here, footOn(here).first)) return position;
  for (const std::uint32_t other : parts_->beside[here]) {
    const auto [uv, foot] = footOn(other);
    if (isOn(other, uv)) return foot;
  }
  return position;
}

}  // namespace af2::geometry
