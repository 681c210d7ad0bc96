#include "geometry/occ/surfaces/face_surface.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "engine/surface/plane_chart.h"
#include "geometry/charts/normal_line_chart.h"
#include "geometry/charts/stereographic_chart.h"
#include "geometry/charts/torus_map.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/surfaces/flat_surfaces.h"
#include "geometry/occ/surfaces/surface_bend.h"
#include "geometry/occ/surfaces/swept_maps.h"

namespace af2::geometry {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

/// OpenCASCADE's projections on a surface of which this is false may not come to an end.
bool hasNumbers(const Geom_Surface& surface) {
  double u1, u2, v1, v2;
  surface.Bounds(u1, u2, v1, v2);
  const auto middle = [](double a, double b) { return b - a < 1e50 ? (a + b) / 2 : 0; };
  const Point3 p = toPoint(surface.Value(middle(u1, u2), middle(v1, v2)));
  return std::isfinite(dot(p, p));
}

Handle(Geom_Surface) surfaceOf(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull()) throw GeometryError("the face has no surface");
  if (!hasNumbers(*surface))
    throw GeometryError("the face has a surface with values that are not numbers");
  return surface;
}

/// A closed form whose normals agree with those of the parametrisation at a place of the face.
template <class Quadric>
Quadric oriented(Quadric outer, Quadric inner, const Point3& position, const Point3& normal) {
  return dot(outer.normalAt(position), normal) > 0 ? outer : inner;
}

/// The part of the parameters that a face takes up.
struct Bounds : SplineSurface::Box {
  double u(double share) const { return u1 + share * (u2 - u1); }
  double v(double share) const { return v1 + share * (v2 - v1); }
};

SplineSurface::Box boxOf(const TopoDS_Face& face) {
  // A plane is the same everywhere, and files often lack curves in its parameters.
  if (GeomAdaptor_Surface(surfaceOf(face)).GetType() == GeomAbs_Plane) return {0, 1, 0, 1};
  SplineSurface::Box bounds{};
  BRepTools::UVBounds(face, bounds.u1, bounds.u2, bounds.v1, bounds.v2);
  return bounds;
}

/// The nappe on which the face lies; nothing if it lies on both.
std::optional<ConeSurface> nappeOf(const gp_Cone& cone, const Bounds& bounds,
                                   const Point3& position, const Point3& normal, double extent) {
  const double v1 = bounds.v1, v2 = bounds.v2;
  const double sine = af2::sine(cone.SemiAngle());
  const double reference = cone.RefRadius();
  const double slack = 1e-9 * (std::abs(reference) + std::abs(sine) * (v2 - v1));
  const double low = std::min(reference + v1 * sine, reference + v2 * sine);
  const double high = std::max(reference + v1 * sine, reference + v2 * sine);
  if (low < -slack && high > slack) return std::nullopt;

  const Point3 apex = toPoint(cone.Apex());
  Point3 axis = toPoint(cone.Axis().Direction());
  if (dot(position - apex, axis) < 0) axis = -1 * axis;
  const double tangent = std::abs(af2::tangent(cone.SemiAngle()));
  return oriented(ConeSurface(apex, axis, tangent, Side::Outer, extent),
                  ConeSurface(apex, axis, tangent, Side::Inner, extent), position, normal);
}

AxisFrame axisFrame(const gp_Ax3& position, const Point3& origin) {
  return {origin, toPoint(position.XDirection()), toPoint(position.YDirection()),
          toPoint(position.Direction())};
}

/// The nappe of a cone that holds a place.
std::shared_ptr<const UnrolledSurface> unrolled(const gp_Cone& cone, const ConeSurface& nappe,
                                                double middle, const Point3& place) {
  AxisFrame frame = axisFrame(cone.Position(), toPoint(cone.Apex()));
  const bool isOther = dot(place - frame.origin, frame.axis) < 0;
  if (isOther) frame.axis = -1 * frame.axis;
  // The angle of OpenCASCADE's parameters may point to the other side of the axis.
  if (isOther != (cone.SemiAngle() < 0)) {
    frame.x = -1 * frame.x;
    frame.y = -1 * frame.y;
  }
  return std::make_shared<UnrolledCone>(frame, std::abs(cone.SemiAngle()), middle, nappe);
}

bool reachesTip(const gp_Cone& cone, const Bounds& bounds) {
  const double tip = -cone.RefRadius() / af2::sine(cone.SemiAngle());
  const double slack = 1e-6 * (bounds.v2 - bounds.v1);
  return tip > bounds.v1 - slack && tip < bounds.v2 + slack;
}

/// A place of the face's part of the surface that is no pole.
SurfacePoint samplePoint(const Bounds& bounds, const GeneralSurface& surface) {
  const double u = bounds.u(0.4142), v = bounds.v(0.4142);
  return {surface.frameAt(u, v).position, surface.normalAt(u, v), u, v};
}

}  // namespace

FaceSurface::FaceSurface(const TopoDS_Face& face)
    : FaceSurface(surfaceOf(face), boxOf(face), face.Orientation() == TopAbs_REVERSED) {}

FaceSurface::FaceSurface(const TopoDS_Face& face, FaceCells cells)
    : FaceSurface(surfaceOf(face), boxOf(face), face.Orientation() == TopAbs_REVERSED,
                  std::move(cells)) {}

FaceSurface FaceSurface::ofCell(const TopoDS_Face& face, const Stretch& u, const Stretch& v) {
  FaceSurface cell(surfaceOf(face), {u.low, u.high, v.low, v.high},
                   face.Orientation() == TopAbs_REVERSED, {{u}, {v}});
  cell.parametric_.endAtBox();
  if (auto* general = std::get_if<GeneralSurface>(&cell.surface_)) general->endAtBox();
  return cell;
}

FaceSurface::FaceSurface(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box,
                         bool flipped, FaceCells cells)
    : box_(box),
      cells_(std::move(cells)),
      parametric_(surface, flipped, box),
      surface_(parametric_) {
  const GeomAdaptor_Surface adaptor(surface);
  const Bounds bounds{box};
  const SurfacePoint sample = samplePoint(bounds, parametric_);
  const Point3 &p = sample.position, &n = sample.normal;
  if (!(length(n) > 0)) return;
  if (adaptor.GetType() != GeomAbs_Plane) measure();
  if (isFlat(surface, box, extent_)) {
    surface_ = PlaneSurface{p, n};
    return;
  }
  switch (adaptor.GetType()) {
    case GeomAbs_Plane:
      surface_ = PlaneSurface{p, n};
      break;
    case GeomAbs_Cylinder: {
      const gp_Cylinder c = adaptor.Cylinder();
      const Point3 onAxis = toPoint(c.Location()), axis = toPoint(c.Axis().Direction());
      const CylinderSurface cylinder =
          oriented(CylinderSurface(onAxis, axis, c.Radius(), Side::Outer),
                   CylinderSurface(onAxis, axis, c.Radius(), Side::Inner), p, n);
      surface_ = cylinder;
      unrolled_ = std::make_shared<UnrolledCylinder>(axisFrame(c.Position(), onAxis), cylinder);
      break;
    }
    case GeomAbs_Cone:
      if (const auto cone = nappeOf(adaptor.Cone(), bounds, p, n, extent_)) {
        surface_ = *cone;
        hasTip_ = reachesTip(adaptor.Cone(), bounds);
        unrolled_ = unrolled(adaptor.Cone(), *cone, bounds.u(0.5), p);
      }
      break;
    case GeomAbs_Sphere: {
      const gp_Sphere s = adaptor.Sphere();
      const Point3 centre = toPoint(s.Location());
      surface_ = oriented(SphereSurface(centre, s.Radius(), Side::Outer),
                          SphereSurface(centre, s.Radius(), Side::Inner), p, n);
      break;
    }
    case GeomAbs_Torus: {
      const gp_Torus t = adaptor.Torus();
      if (t.MinorRadius() >= t.MajorRadius()) break;  // crosses itself: leave it to the parameters
      const Point3 centre = toPoint(t.Location()), axis = toPoint(t.Axis().Direction());
      surface_ =
          oriented(TorusSurface(centre, axis, t.MajorRadius(), t.MinorRadius(), Side::Outer),
                   TorusSurface(centre, axis, t.MajorRadius(), t.MinorRadius(), Side::Inner), p, n);
      sweep_ = Sweep::Torus;
      sweepAxis_ = axisFrame(t.Position(), centre);
      break;
    }
    case GeomAbs_SurfaceOfRevolution: {
      const gp_Ax1 axis = adaptor.AxeOfRevolution();
      sweep_ = Sweep::Revolution;
      sweepAxis_ = {toPoint(axis.Location()), {}, {}, toPoint(axis.Direction())};
      break;
    }
    case GeomAbs_SurfaceOfExtrusion:
      extrusion_ = Extrusion{toPoint(adaptor.Direction())};
      break;
    default:
      if (const auto spline = splineDefinitionOf(adaptor, box)) extrusion_ = extrusionOf(*spline);
  }
}

void FaceSurface::measure() {
  tips_ = SharpTips(parametric_, box_);
  const SurfaceBend bend = cells_.count() == 0 ? bendOf(parametric_, box_) : bendBetweenCreases();
  isBentInU_ = bend.inU;
  isBentInV_ = bend.inV;
  extent_ = bend.extent;
  breadth_ = bend.breadth;
  girth_ = bend.girth;
  creaseRadius_ = bend.creaseRadius;
  isWavy_ = bend.isWavy;
}

SurfaceBend FaceSurface::bendBetweenCreases() const {
  SurfaceBend bend;
  for (const Stretch& u : cells_.u)
    for (const Stretch& v : cells_.v)
      bend.add(bendOf(parametric_, {u.calmLow, u.calmHigh, v.calmLow, v.calmHigh}));
  return bend;
}

const ParametricSurface* FaceSurface::inParameters() const {
  if (unrolled_) return unrolled_.get();
  return &parametric_;
}

SurfacePoint FaceSurface::at(double u, double v) const {
  return pointAt(inParameters()->pointAt(u, v).position, u, v);
}

SurfacePoint FaceSurface::boundaryPoint(const Point3& position, double u, double v) const {
  if (const auto* general = std::get_if<GeneralSurface>(&surface_)) {
    general->refine(position, u, v);
    const auto atTip = tips_.normalAt(position);
    const auto normal = [&] {
      return general->normalAtBoundary(calm(cells_.u, u), calm(cells_.v, v));
    };
    return {position, atTip ? *atTip : normal(), u, v};
  }
  if (const auto* plane = std::get_if<PlaneSurface>(&surface_))
    return pointAt(plane->drawnOnto(position), u, v);
  if (!unrolled_) return pointAt(position, u, v);
  const Point2 flat = unrolled_->develop(position, u, v);
  return pointAt(position, flat.x, flat.y);
}

SurfacePoint FaceSurface::pointAt(const Point3& position, double u, double v) const {
  return std::visit(Overloaded{[&](const PlaneSurface& plane) {
                                 return SurfacePoint{position, plane.normal, u, v};
                               },
                               [&](const GeneralSurface& general) {
                                 general.refine(position, u, v);
                                 return SurfacePoint{position, general.normalAt(u, v), u, v};
                               },
                               [&](const auto& quadric) {
                                 return SurfacePoint{position, quadric.normalAt(position), u, v};
                               }},
                    surface_);
}

FaceSurface::Radii FaceSurface::radiiAt(const SurfacePoint& point, double reach) const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto alike = [&](double radius) { return Radii{radius, isBent() ? radius : kInfinite}; };
  return std::visit(
      Overloaded{
          [&](const PlaneSurface&) {
            return Radii{kInfinite, kInfinite};
          },
          [&](const CylinderSurface& cylinder) { return alike(cylinder.radius()); },
          [&](const SphereSurface& sphere) { return alike(sphere.radius()); },
          [&](const ConeSurface& cone) {
            const double here = cone.curvatureRadiusAt(point.position);
            return alike(hasTip_ ? std::max(here, cone.curvatureRadiusAtDistance(reach)) : here);
          },
          [&](const TorusSurface& torus) {
            const double radius = torus.curvatureRadiusAt(point.position);
            const double bent = isBentInV_   ? radius
                                : isBentInU_ ? torus.radiusAroundAxisAt(point.position)
                                             : kInfinite;
            return Radii{radius, bent};
          },
          [&](const GeneralSurface& general) {
            if (const auto radius = tips_.radiusAtTip(point.position, reach))
              return Radii{*radius, *radius};
            const auto radii = general.radiiAt(calm(cells_.u, point.u), calm(cells_.v, point.v));
            const double easing = tips_.easing(point.position, reach);
            return Radii{easing * radii.smallest,
                         easing * std::min(isBentInU_ ? radii.u : kInfinite,
                                           isBentInV_ ? radii.v : kInfinite)};
          }},
      surface_);
}

std::vector<SharpTip> FaceSurface::sharpTips() const {
  const auto* cone = std::get_if<ConeSurface>(&surface_);
  if (!cone)
    return std::holds_alternative<GeneralSurface>(surface_) ? tips_.all() : std::vector<SharpTip>{};
  if (!hasTip_) return {};
  constexpr double kSlack = 1e-6;  // of the extent
  return {{cone->apex(), kSlack * extent_, cone->angleAroundApex()}};
}

SurfacePoint FaceSurface::aroundTip(const SurfacePoint& from, const SurfacePoint& to,
                                    double share) const {
  const auto between = [&](double a, double b) { return a + share * (b - a); };
  if (!std::holds_alternative<ConeSurface>(surface_))
    return at(between(from.u, to.u), between(from.v, to.v));
  const Point2 p{from.u, from.v}, q{to.u, to.v};  // unrolled, around the tip
  const Point2 place = between(length(p), length(q)) * directionAt(between(angleOf(p), angleOf(q)));
  return at(place.x, place.y);
}

double FaceSurface::angleAroundTip(const SurfacePoint& from, const SurfacePoint& to,
                                   const Point3& tip) const {
  if (!std::holds_alternative<ConeSurface>(surface_)) return tips_.angleBetween(from, to, tip);
  return std::abs(angleOf({from.u, from.v}) - angleOf({to.u, to.v}));
}

std::unique_ptr<AF2LocalTransformMaker> FaceSurface::makeCharts(const ChartLimits& limits) const {
  using Maker = std::unique_ptr<AF2LocalTransformMaker>;
  return std::visit(Overloaded{[](const PlaneSurface& plane) -> Maker {
                                 return std::make_unique<PlaneChartMaker>(plane.normal);
                               },
                               [&](const auto& curved) -> Maker {
                                 using Curved = std::decay_t<decltype(curved)>;
                                 return std::make_unique<MeanNormalChartMaker<Curved>>(curved,
                                                                                       limits);
                               }},
                    surface_);
}

bool FaceSurface::has(ChartKind kind) const {
  switch (kind) {
    case ChartKind::Auto:
      return true;
    case ChartKind::Plane:
      return isPlane();
    case ChartKind::MeanNormal:
    case ChartKind::NormalLines:
    case ChartKind::Parametric:
    case ChartKind::Affine:
      return !isPlane();
    case ChartKind::Developed:
    case ChartKind::Conformal:
      return makePlaneMap(kind) != nullptr;
    case ChartKind::Stereographic:
      return std::holds_alternative<SphereSurface>(surface_);
  }
  return false;
}

std::unique_ptr<AF2LocalTransformMaker> FaceSurface::makeCharts(ChartKind kind) const {
  if (kind == ChartKind::Parametric) return std::make_unique<MetricChartMaker>(*inParameters());
  if (kind == ChartKind::Affine)
    return std::make_unique<MetricChartMaker>(*inParameters(), MetricOrder::First);
  if (const auto* sphere = std::get_if<SphereSurface>(&surface_);
      sphere && kind == ChartKind::Stereographic)
    return std::make_unique<StereographicChartMaker>(*sphere);
  if (kind == ChartKind::NormalLines) return normalLineCharts();
  return makeCharts(ChartLimits{});
}

std::unique_ptr<AF2LocalTransformMaker> FaceSurface::normalLineCharts() const {
  using Maker = std::unique_ptr<AF2LocalTransformMaker>;
  return std::visit(
      Overloaded{[&](const PlaneSurface&) -> Maker { return makeCharts(ChartLimits{}); },
                 [&](const auto& curved) -> Maker {
                   using Curved = std::decay_t<decltype(curved)>;
                   return std::make_unique<NormalLineChartMaker<Curved>>(curved);
                 }},
      surface_);
}

std::unique_ptr<PlaneMap> FaceSurface::makePlaneMap(ChartKind kind) const {
  if (kind == ChartKind::Developed) {
    if (unrolled_) return std::make_unique<UnrolledMap>(*unrolled_);
    if (extrusion_) return makeExtrusionMap(parametric_, box_, *extrusion_);
  }
  if (kind == ChartKind::Conformal) {
    if (const auto* torus = std::get_if<TorusSurface>(&surface_))
      return std::make_unique<TorusMap>(sweepAxis_, *torus);
    if (sweep_ == Sweep::Revolution)
      return makeRevolutionMap(parametric_, box_, sweepAxis_.origin, sweepAxis_.axis);
  }
  return nullptr;
}

}  // namespace af2::geometry
