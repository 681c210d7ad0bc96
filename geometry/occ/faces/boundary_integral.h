// Integrals along curves.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <GeomAbs_Shape.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopAbs.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <array>
#include <cmath>

namespace af2::geometry {

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

/// What the rules of Gauss and Kronrod may differ by, as a share. Kronrod's alone is better by some
/// digits.
inline constexpr double kShare = 1e-5;

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

/// 1, or -1 where the face uses the edge backwards.
inline double signOf(const TopoDS_Edge& edge) {
  return edge.Orientation() == TopAbs_REVERSED ? -1 : 1;
}

/// Adds the edges on the boundary of a face to an integral, and tells it where wires end.
template <class Sum>
void addBoundary(const TopoDS_Face& face, Sum& sum) {
  for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
    for (TopExp_Explorer it(wire.Value(), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED)
        sum.add(edge);
    }
    sum.endWire();
  }
}

}  // namespace af2::geometry
