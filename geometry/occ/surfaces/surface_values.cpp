#include "geometry/occ/surfaces/surface_values.h"

#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Precision.hxx>

#include "geometry/charts/offset_surface.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {

namespace {

SplineBasis bezierBasis(int degree) {
  const auto order = static_cast<std::size_t>(degree) + 1;
  SplineBasis basis{degree, std::vector<double>(2 * order, 0.0)};
  std::fill_n(basis.knots.begin() + static_cast<std::ptrdiff_t>(order), order, 1.0);
  return basis;
}

/// Poles and weights of a surface of either kind.
template <class Surface>
void takePoles(const Surface& surface, SplineDefinition& definition) {
  const bool isRational = surface.IsURational() || surface.IsVRational();
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      definition.poles.push_back(toPoint(surface.Pole(i, j)));
      if (isRational) definition.weights.push_back(surface.Weight(i, j));
    }
}

SplineDefinition definitionOf(const Handle(Geom_BezierSurface) & surface) {
  SplineDefinition definition{
      bezierBasis(surface->UDegree()), bezierBasis(surface->VDegree()), {}, {}};
  takePoles(*surface, definition);
  return definition;
}

SplineDefinition definitionOf(Handle(Geom_BSplineSurface) surface) {
  const bool uPeriodic = surface->IsUPeriodic(), vPeriodic = surface->IsVPeriodic();
  if (uPeriodic || vPeriodic) surface = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
  // The same surface on the same range, with poles and knots of its own at both ends.
  if (uPeriodic) surface->SetUNotPeriodic();
  if (vPeriodic) surface->SetVNotPeriodic();
  SplineDefinition definition;
  definition.u = {surface->UDegree(),
                  {surface->UKnotSequence().begin(), surface->UKnotSequence().end()}};
  definition.v = {surface->VDegree(),
                  {surface->VKnotSequence().begin(), surface->VKnotSequence().end()}};
  if (uPeriodic) definition.u.period = definition.u.high() - definition.u.low();
  if (vPeriodic) definition.v.period = definition.v.high() - definition.v.low();
  takePoles(*surface, definition);
  return definition;
}

/// Basis, poles and weights of a curve, as a definition without v.
std::optional<SplineDefinition> definitionOf(const Handle(Adaptor3d_Curve) & adaptor) {
  SplineDefinition definition;
  const auto take = [&](const auto& curve) {
    for (int i = 1; i <= curve.NbPoles(); ++i) {
      definition.poles.push_back(toPoint(curve.Pole(i)));
      if (curve.IsRational()) definition.weights.push_back(curve.Weight(i));
    }
  };
  if (adaptor->GetType() == GeomAbs_BezierCurve) {
    definition.u = bezierBasis(adaptor->Bezier()->Degree());
    take(*adaptor->Bezier());
    return definition;
  }
  if (adaptor->GetType() != GeomAbs_BSplineCurve) return std::nullopt;
  Handle(Geom_BSplineCurve) curve = adaptor->BSpline();
  const bool isPeriodic = curve->IsPeriodic();
  if (isPeriodic) {
    curve = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
    curve->SetNotPeriodic();
  }
  definition.u = {curve->Degree(), {curve->KnotSequence().begin(), curve->KnotSequence().end()}};
  if (isPeriodic) definition.u.period = definition.u.high() - definition.u.low();
  take(*curve);
  return definition;
}

std::optional<SplineDefinition> extrusion(const GeomAdaptor_Surface& surface,
                                          const SplineSurface::Box& box) {
  if (!(box.v1 < box.v2)) return std::nullopt;
  const auto curve = definitionOf(surface.BasisCurve());
  if (!curve) return std::nullopt;
  const Point3 direction = toPoint(surface.Direction());
  SplineDefinition definition{curve->u, {1, {box.v1, box.v1, box.v2, box.v2}}, {}, {}};
  for (const Point3& pole : curve->poles)
    for (const double v : {box.v1, box.v2}) definition.poles.push_back(pole + v * direction);
  for (const double weight : curve->weights)
    definition.weights.insert(definition.weights.end(), 2, weight);
  return definition;
}

}  // namespace

std::optional<SplineDefinition> splineDefinitionOf(const GeomAdaptor_Surface& surface,
                                                   const SplineSurface::Box& box) {
  switch (surface.GetType()) {
    case GeomAbs_BSplineSurface:
      return definitionOf(surface.BSpline());
    case GeomAbs_BezierSurface:
      return definitionOf(surface.Bezier());
    case GeomAbs_SurfaceOfExtrusion:
      return extrusion(surface, box);
    default:
      return std::nullopt;
  }
}

SurfaceValues::SurfaceValues(const Handle(Geom_Surface) & surface, const SplineSurface::Box& box)
    : surface_(surface), adaptor_(std::make_unique<GeomAdaptor_Surface>(surface)) {
  const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
  const auto definition = splineDefinitionOf(
      offset.IsNull() ? *adaptor_ : GeomAdaptor_Surface(offset->BasisSurface()), box);
  if (!definition) return;
  auto spline = SplineSurface::make(*definition, box);
  if (!spline) return;
  spline_ = std::make_shared<const SplineSurface>(std::move(*spline));
  if (offset.IsNull())
    adaptor_.reset();
  else
    offset_ = offset->Offset();
}

SurfaceValues::SurfaceValues(const SurfaceValues& other)
    : surface_(other.surface_),
      spline_(other.spline_),
      offset_(other.offset_),
      adaptor_(other.adaptor_ ? std::make_unique<GeomAdaptor_Surface>(surface_) : nullptr) {}

SurfaceFrame SurfaceValues::frameAt(double u, double v) const {
  if (offset_ != 0) {
    if (const auto bend = offsetBendAt(u, v)) return {bend->position, bend->du, bend->dv};
  } else if (spline_) {
    if (const auto frame = spline_->frameAt(u, v)) return *frame;
  }
  gp_Pnt position;
  gp_Vec du, dv;
  if (adaptor_)
    adaptor_->D1(u, v, position, du, dv);
  else
    surface_->D1(u, v, position, du, dv);
  return {toPoint(position), toPoint(du), toPoint(dv)};
}

SurfaceJet SurfaceValues::jetAt(double u, double v) const {
  if (spline_ && offset_ == 0)
    if (const auto jet = spline_->jetAt(u, v)) return *jet;
  gp_Pnt position;
  gp_Vec du, dv, duu, dvv, duv;
  if (adaptor_)
    adaptor_->D2(u, v, position, du, dv, duu, dvv, duv);
  else
    surface_->D2(u, v, position, du, dv, duu, dvv, duv);
  return {toPoint(position), toPoint(du), toPoint(dv), toPoint(duu), toPoint(duv), toPoint(dvv)};
}

SurfaceJet SurfaceValues::bendAt(double u, double v) const {
  if (offset_ != 0)
    if (const auto bend = offsetBendAt(u, v)) return *bend;
  return jetAt(u, v);
}

std::optional<SurfaceJet> SurfaceValues::offsetBendAt(double u, double v) const {
  const auto base = spline_->jetAt(u, v);
  return base ? offsetBend(*base, offset_) : std::nullopt;
}

}  // namespace af2::geometry
