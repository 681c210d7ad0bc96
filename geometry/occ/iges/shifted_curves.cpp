#include "geometry/occ/iges/shifted_curves.h"

#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace af2::geometry {

namespace {

struct Extent {
  double least = std::numeric_limits<double>::max(), most = std::numeric_limits<double>::lowest();

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  double length() const { return most - least; }
};

/// Of the curves of a face, by a few points on each.
std::pair<Extent, Extent> extentsOf(const TopoDS_Face& face) {
  constexpr int kPoints = 16;
  std::pair<Extent, Extent> found;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double first = 0, last = 0;
    const Handle(Geom2d_Curve) curve =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face, first, last);
    for (int i = 0; !curve.IsNull() && i <= kPoints; ++i) {
      const gp_Pnt2d at = curve->Value(first + (last - first) * i / kPoints);
      found.first.add(at.X());
      found.second.add(at.Y());
    }
  }
  return found;
}

}  // namespace

bool runsPastPeriod(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull() || !(surface->IsUClosed() || surface->IsVClosed())) return false;
  double u1, u2, v1, v2;
  surface->Bounds(u1, u2, v1, v2);
  constexpr double kMore = 1.001;
  const auto [u, v] = extentsOf(face);
  return (surface->IsUClosed() && u.length() > kMore * (u2 - u1)) ||
         (surface->IsVClosed() && v.length() > kMore * (v2 - v1));
}

int replaceShifted(TopoDS_Shape& shape, const std::function<TopoDS_Shape()>& readAgain) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<int> shifted;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (runsPastPeriod(TopoDS::Face(faces(i)))) shifted.push_back(i);
  if (shifted.empty()) return 0;

  TopTools_IndexedMapOfShape others;
  TopExp::MapShapes(readAgain(), TopAbs_FACE, others);
  if (others.Extent() != faces.Extent()) return 0;
  BRepTools_ReShape replacing;
  int count = 0;
  for (const int i : shifted) {
    if (runsPastPeriod(TopoDS::Face(others(i)))) continue;
    replacing.Replace(faces(i), others(i));
    ++count;
  }
  if (count > 0) shape = replacing.Apply(shape);
  return count;
}

}  // namespace af2::geometry
