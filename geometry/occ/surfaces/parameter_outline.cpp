#include "geometry/occ/surfaces/parameter_outline.h"

#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <limits>

namespace af2::geometry {

namespace {

int chordsOf(const Geom2dAdaptor_Curve& curve) {
  constexpr int kOfCircle = 24, kFewest = 4;
  if (curve.GetType() == GeomAbs_Line) return 1;
  const int intervals = curve.NbIntervals(GeomAbs_C1);
  return std::max(kOfCircle, kFewest * intervals);
}

}  // namespace

ParameterOutline::ParameterOutline(const TopoDS_Face& face) : face_(face) {
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopAbs_Orientation use = it.Current().Orientation();
    if (use == TopAbs_FORWARD || use == TopAbs_REVERSED) add(TopoDS::Edge(it.Current()));
  }
}

void ParameterOutline::add(const TopoDS_Edge& edge) {
  double first, last;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face_, first, last);
  if (curve.IsNull()) area_ = -std::numeric_limits<double>::infinity();  // is not known
  if (curve.IsNull()) return;
  const Geom2dAdaptor_Curve adaptor(curve, first, last);
  const double sign = edge.Orientation() == TopAbs_REVERSED ? -1 : 1;
  const int count = chordsOf(adaptor);
  gp_Pnt2d from = adaptor.Value(first);
  for (int i = 1; i <= count; ++i) {
    const gp_Pnt2d to = adaptor.Value(i < count ? first + (last - first) * i / count : last);
    area_ -= sign * (from.Y() + to.Y()) / 2 * (to.X() - from.X());
    if (from.X() < to.X())
      chords_.push_back({from.X(), from.Y(), to.X(), to.Y()});
    else if (to.X() < from.X())
      chords_.push_back({to.X(), to.Y(), from.X(), from.Y()});
    from = to;
  }
}

const std::vector<double>& ParameterOutline::crossingsAt(double u) {
  const auto [at, isNew] = crossings_.try_emplace(u);
  std::vector<double>& crossings = at->second;
  if (!isNew) return crossings;
  for (const Chord& c : chords_)
    if (c.u1 <= u && u < c.u2)
      crossings.push_back(c.v1 + (u - c.u1) / (c.u2 - c.u1) * (c.v2 - c.v1));
  std::ranges::sort(crossings);
  return crossings;
}

bool ParameterOutline::has(double u, double v) {
  const std::vector<double>& crossings = crossingsAt(u);
  if (area_ > 0 && !crossings.empty() && crossings.size() % 2 == 0)
    return (std::ranges::lower_bound(crossings, v) - crossings.begin()) % 2 == 1;
  if (!otherwise_) otherwise_.emplace(face_, Precision::PConfusion());
  return otherwise_->Perform({u, v}) != TopAbs_OUT;
}

}  // namespace af2::geometry
