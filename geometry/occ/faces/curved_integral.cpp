#include "geometry/occ/faces/curved_integral.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <utility>
#include <vector>

namespace af2::geometry {

namespace {

class SummedStrips {
 public:
  SummedStrips(const TopoDS_Face& face, const FaceSurface& surface,
               std::function<double(const SurfaceFrame&)> density, double tolerance)
      : surface_(surface.inOccParameters()),
        density_(std::move(density)),
        integral_(tolerance),
        from_((surface.box().u1 + surface.box().u2) / 2) {
    const GeomAdaptor_Surface adaptor(BRep_Tool::Surface(face));
    const int count = adaptor.NbUIntervals(GeomAbs_C2);
    TColStd_Array1OfReal bounds(1, count + 1);
    adaptor.UIntervals(bounds, GeomAbs_C2);
    breaks_.assign(bounds.begin(), bounds.end());
  }

  double operator()(double u, double v) const {
    const auto rate = [&](double at) { return density_(surface_.frameAt(at, v)); };
    const double low = std::min(from_, u), high = std::max(from_, u);
    double sum = 0, last = low;
    for (const double b : breaks_) {
      if (!(b > last && b < high)) continue;
      sum += integral_.of(rate, last, b);
      last = b;
    }
    sum += integral_.of(rate, last, high);
    return u < from_ ? -sum : sum;
  }

 private:
  const GeneralSurface& surface_;
  std::function<double(const SurfaceFrame&)> density_;
  Integral integral_;
  double from_;
  std::vector<double> breaks_;
};

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

}  // namespace

Strip summedStrips(const TopoDS_Face& face, const FaceSurface& surface,
                   std::function<double(const SurfaceFrame&)> density, double tolerance) {
  return SummedStrips(face, surface, std::move(density), tolerance);
}

double widthOfBox(const FaceSurface& surface) {
  const SplineSurface::Box box = surface.box();
  const SurfaceFrame middle =
      surface.inOccParameters().frameAt((box.u1 + box.u2) / 2, (box.v1 + box.v2) / 2);
  return length(cross(middle.du, middle.dv)) * (box.u2 - box.u1);
}

CurvedIntegral::CurvedIntegral(const TopoDS_Face& face, const SplineSurface::Box& box, Strip strip,
                               double perStrip, const Stretch& u, const Stretch& v)
    : face_(face),
      box_(box),
      strip_(std::move(strip)),
      integral_(perStrip * (box.v2 - box.v1)),
      u_(u),
      v_(v) {}

void CurvedIntegral::add(const TopoDS_Edge& edge) {
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
void CurvedIntegral::endWire() {
  constexpr double kGap = 0.1;  // share of the box; wires of damaged files have smaller gaps
  if (!(std::abs(gapU_) <= kGap * (box_.u2 - box_.u1) &&
        std::abs(gapV_) <= kGap * (box_.v2 - box_.v1)))
    isClosed_ = false;
  gapU_ = gapV_ = 0;
}

}  // namespace af2::geometry
