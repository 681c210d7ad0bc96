#include "geometry/occ/faces/face_area.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "engine/base/error.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

/// Integrates by the rule of Gauss and Kronrod with 7 and 15 points, halving where they differ.
class Integral {
 public:
  /// tolerance  for each part: absolute, or a share of the part
  explicit Integral(double tolerance) : tolerance_(tolerance) {}

  template <class Function>
  double of(const Function& function, double low, double high, int depth = 0) const {
    const double middle = (low + high) / 2, half = (high - low) / 2;
    const double centre = function(middle);
    double gauss = kGauss[3] * centre, kronrod = kKronrod[7] * centre;
    for (std::size_t i = 0; i < 7; ++i) {
      const double sum = function(middle - half * kNodes[i]) + function(middle + half * kNodes[i]);
      kronrod += kKronrod[i] * sum;
      if (i % 2 == 1) gauss += kGauss[i / 2] * sum;
    }
    const double error = std::abs(half * (kronrod - gauss));
    constexpr int kDeepest = 8;
    if (depth == kDeepest || error <= tolerance_ + kRelative * std::abs(half * kronrod))
      return half * kronrod;
    return of(function, low, middle, depth + 1) + of(function, middle, high, depth + 1);
  }

 private:
  static constexpr double kRelative = 1e-5;
  // Nodes from the end of the interval inwards; every second one, and the middle, are those of
  // Gauss.
  static constexpr std::array kNodes{
      0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
      0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
      0.586087235467691130294144838258730, 0.405845151377397166906606412076961,
      0.207784955007898467600689403773245};
  static constexpr std::array kKronrod{
      0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
      0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
      0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
      0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
  static constexpr std::array kGauss{
      0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
      0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

  double tolerance_;
};

/// Area of the strip of width dv, per dv, from the middle of the box to the u that is given. From
/// the middle, because there the gaps of a boundary that is not quite closed do least harm.
using StripArea = std::function<double(double u, double v)>;

/// Strips of the surfaces whose parameters are at right angles: as high everywhere as they are at
/// v.
std::optional<StripArea> closedForm(const GeomAdaptor_Surface& surface,
                                    const SplineSurface::Box& box) {
  const double from = (box.u1 + box.u2) / 2;
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      return [=, r = surface.Cylinder().Radius()](double u, double) { return r * (u - from); };
    case GeomAbs_Sphere:
      return [=, r = surface.Sphere().Radius()](double u, double v) {
        return r * r * std::cos(v) * (u - from);
      };
    case GeomAbs_Cone: {
      const double r = surface.Cone().RefRadius(), sine = std::sin(surface.Cone().SemiAngle());
      if ((r + box.v1 * sine) * (r + box.v2 * sine) < 0) return std::nullopt;  // on both nappes
      return [=](double u, double v) { return (r + v * sine) * (u - from); };
    }
    case GeomAbs_Torus: {
      const double major = surface.Torus().MajorRadius(), minor = surface.Torus().MinorRadius();
      if (minor > major) return std::nullopt;
      return [=](double u, double v) { return minor * (major + minor * std::cos(v)) * (u - from); };
    }
    default:
      return std::nullopt;
  }
}

/// Strips of any other surface, piece by piece between the u where its formula changes.
class SummedStrips {
 public:
  SummedStrips(const FaceSurface& surface, const GeomAdaptor_Surface& adaptor, double tolerance)
      : surface_(surface.inOccParameters()),
        integral_(tolerance),
        from_((surface.box().u1 + surface.box().u2) / 2) {
    const int count = adaptor.NbUIntervals(GeomAbs_C2);
    TColStd_Array1OfReal bounds(1, count + 1);
    adaptor.UIntervals(bounds, GeomAbs_C2);
    breaks_.assign(bounds.begin(), bounds.end());
  }

  double operator()(double u, double v) const {
    const auto width = [&](double at) {
      const SurfaceFrame frame = surface_.frameAt(at, v);
      return length(cross(frame.du, frame.dv));
    };
    const double low = std::min(from_, u), high = std::max(from_, u);
    double sum = 0, last = low;
    for (const double b : breaks_) {
      if (!(b > last && b < high)) continue;
      sum += integral_.of(width, last, b);
      last = b;
    }
    sum += integral_.of(width, last, high);
    return u < from_ ? -sum : sum;
  }

 private:
  const GeneralSurface& surface_;
  Integral integral_;
  double from_;
  std::vector<double> breaks_;
};

/// What the rules of Gauss and Kronrod may differ by, as a share. Kronrod's alone is better by some
/// digits.
constexpr double kShare = 1e-5;

/// Integrates a rate along a curve, piece by piece between the parameters where its formula
/// changes.
template <class Curve, class Rate>
double integrateAlong(const Curve& curve, const Integral& integral, const Rate& rate) {
  const int count = curve.NbIntervals(GeomAbs_C2);
  TColStd_Array1OfReal bounds(1, count + 1);
  curve.Intervals(bounds, GeomAbs_C2);
  double sum = 0;
  for (int i = 1; i <= count; ++i) sum += integral.of(rate, bounds(i), bounds(i + 1));
  return sum;
}

double signOf(const TopoDS_Edge& edge) { return edge.Orientation() == TopAbs_REVERSED ? -1 : 1; }

/// Along some chords, so a little too short.
double roughLength(const TopoDS_Edge& edge) {
  double first, last;
  if (BRep_Tool::Degenerated(edge) || BRep_Tool::Curve(edge, first, last).IsNull()) return 0;
  constexpr int kChords = 4;
  const BRepAdaptor_Curve curve(edge);
  double length = 0;
  for (int i = 0; i < kChords; ++i) {
    const auto at = [&](int k) { return curve.Value(first + (last - first) * k / kChords); };
    length += at(i).Distance(at(i + 1));
  }
  return length;
}

/// By Green's theorem the area is the integral of the strips up to the boundary over dv, once
/// around the face.
class CurvedArea {
 public:
  CurvedArea(const TopoDS_Face& face, const FaceSurface& surface,
             const GeomAdaptor_Surface& adaptor, const Stretch& u, const Stretch& v)
      : face_(face), box_(surface.box()), u_(u), v_(v) {
    const SplineSurface::Box& box = box_;
    const SurfaceFrame middle =
        surface.inOccParameters().frameAt((box.u1 + box.u2) / 2, (box.v1 + box.v2) / 2);
    const double perStrip = kShare * length(cross(middle.du, middle.dv)) * (box.u2 - box.u1);
    integral_ = Integral(perStrip * (box.v2 - box.v1));
    if (auto closed = closedForm(adaptor, box))
      strip_ = std::move(*closed);
    else
      strip_ = SummedStrips(surface, adaptor, perStrip);
  }

  void add(const TopoDS_Edge& edge) {
    double first, last;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face_, first, last);
    if (curve.IsNull()) throw Standard_Failure("an edge has no curve in the parameters");
    const Geom2dAdaptor_Curve adaptor(curve, first, last);
    const gp_Pnt2d start = adaptor.Value(first), end = adaptor.Value(last);
    doubt_ += BRep_Tool::Tolerance(edge) * roughLength(edge);
    gapU_ += signOf(edge) * (end.X() - start.X());
    gapV_ += signOf(edge) * (end.Y() - start.Y());
    sum_ += signOf(edge) * integrateAlong(adaptor, integral_, [&](double t) {
              gp_Pnt2d place;
              gp_Vec2d tangent;
              adaptor.D1(t, place, tangent);
              if (tangent.Y() == 0 || !v_.has(place.Y())) return 0.0;
              return strip_(std::clamp(place.X(), u_.low, u_.high), place.Y()) * tangent.Y();
            });
  }

  /// A wire may go around the period of its surface: it is not closed in the parameters then.
  void endWire() {
    constexpr double kGap = 0.1;  // share of the box; wires of damaged files have smaller gaps
    if (!(std::abs(gapU_) <= kGap * (box_.u2 - box_.u1) &&
          std::abs(gapV_) <= kGap * (box_.v2 - box_.v1)))
      isClosed_ = false;
    gapU_ = gapV_ = 0;
  }

  /// 0 if some wire is not closed in the parameters, or if the curves there may lie beside the
  /// edges by more than the face is wide.
  double area() const { return isClosed_ && std::abs(sum_) > doubt_ ? std::abs(sum_) : 0; }

 private:
  const TopoDS_Face& face_;
  SplineSurface::Box box_;
  Stretch u_, v_;  ///< outside nothing counts
  StripArea strip_;
  Integral integral_{0};
  double sum_ = 0, gapU_ = 0, gapV_ = 0, doubt_ = 0;
  bool isClosed_ = true;
};

/// In a plane, the triangles from some point to the boundary. The edges are taken in space: many
/// files have no curves in the parameters of planes, and to make them takes long.
class PlaneArea {
 public:
  explicit PlaneArea(const Point3& normal) : normal_(normal) {}

  void add(const TopoDS_Edge& edge) {
    if (BRep_Tool::Degenerated(edge)) return;
    const BRepAdaptor_Curve curve(edge);
    const Point3 start = toPoint(curve.Value(curve.FirstParameter()));
    const Point3 end = toPoint(curve.Value(curve.LastParameter()));
    const Point3 middle =
        toPoint(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2));
    if (!origin_) origin_ = start;
    extent_ = std::max({extent_, distance(middle, *origin_), distance(end, *origin_)});
    sum_ += signOf(edge) * (triangles(curve, start, end) + gaps(edge, start, end));
  }

  void endWire() {}
  double area() const { return std::abs(sum_); }

 private:
  double between(const Point3& p, const Point3& d) const {
    return dot(cross(p - *origin_, d), normal_) / 2;
  }

  /// From the first vertex to the curve, and from the curve to the last one: they may lie apart.
  double gaps(const TopoDS_Edge& edge, const Point3& start, const Point3& end) const {
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
    if (first.IsNull() || last.IsNull()) return 0;
    const Point3 from = toPoint(BRep_Tool::Pnt(first)), to = toPoint(BRep_Tool::Pnt(last));
    return between(from, start - from) + between(end, to - end);
  }

  double triangles(const BRepAdaptor_Curve& curve, const Point3& start, const Point3& end) const {
    if (curve.GetType() == GeomAbs_Line) return between(start, end - start);
    return integrateAlong(curve, Integral(kShare * extent_ * extent_), [&](double t) {
      gp_Pnt place;
      gp_Vec tangent;
      curve.D1(t, place, tangent);
      return between(toPoint(place), toPoint(tangent));
    });
  }

  Point3 normal_;
  std::optional<Point3> origin_;
  double sum_ = 0, extent_ = 0;
};

template <class Area>
double areaWithin(const TopoDS_Face& face, Area area) {
  for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
    for (TopExp_Explorer it(wire.Value(), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED)
        area.add(edge);
    }
    area.endWire();
  }
  return area.area();
}

double areaOf(const TopoDS_Face& face, const FaceSurface& surface, const Stretch& u,
              const Stretch& v) {
  const GeomAdaptor_Surface adaptor(BRep_Tool::Surface(face));
  if (surface.isPlane()) return areaWithin(face, PlaneArea(surface.pointAt({}, 0, 0).normal));
  return areaWithin(face, CurvedArea(face, surface, adaptor, u, v));
}

}  // namespace

double areaOf(const ModelShape& model, int face) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Stretch all{-kFar, kFar, -kFar, kFar};
  return areaOf(model, face, all, all);
}

double areaOf(const ModelShape& model, int face, const Stretch& u, const Stretch& v) {
  try {
    const TopoDS_Face forward = TopoDS::Face(model.face(face).Oriented(TopAbs_FORWARD));
    const double area = areaOf(forward, model.surface(face), u, v);
    return area < Precision::Infinite() ? area : 0;  // no boundary, or not a number
  } catch (const GeometryError&) {                   // no surface
    return 0;
  } catch (const Standard_Failure&) {
    return 0;
  }
}

}  // namespace af2::geometry
