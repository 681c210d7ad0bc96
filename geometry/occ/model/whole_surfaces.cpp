#include "geometry/occ/model/whole_surfaces.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_XY.hxx>
#include <optional>
#include <utility>
#include <vector>

namespace af2::geometry {

namespace {

struct Bounds {
  double u1, u2, v1, v2;
};

Bounds boundsOf(const Handle(Geom_Surface) & surface) {
  Bounds bounds{};
  surface->Bounds(bounds.u1, bounds.u2, bounds.v1, bounds.v2);
  return bounds;
}

/// The same face with a seam and poles as its boundary; null if its surface is not closed.
TopoDS_Shape withSeams(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull()) return {};
  const Bounds bounds = boundsOf(surface);
  for (const double bound : {bounds.u1, bounds.u2, bounds.v1, bounds.v2})
    if (Precision::IsInfinite(bound)) return {};
  BRepBuilderAPI_MakeFace maker(surface, bounds.u1, bounds.u2, bounds.v1, bounds.v2,
                                Precision::Confusion());
  return maker.IsDone() ? maker.Face().Oriented(face.Orientation()) : TopoDS_Shape();
}

bool hasEdges(const TopoDS_Shape& face) { return TopExp_Explorer(face, TopAbs_EDGE).More(); }

/// Tolerance as a share of the range of a parameter. Files give numbers with ten digits.
constexpr double kOnSeam = 1e-6;

/// Whether a parameter is on the seam, in any period.
bool isAtSeam(double parameter, double first, double last) {
  const double turns = (parameter - first) / (last - first);
  return std::abs(turns - std::round(turns)) <= kOnSeam;
}

/// The vector from the start of a boundary to its end in the parameters, if all of it is on seams:
/// zero for one that runs back and forth, a period for a circle, which bounds something together
/// with the lost edges.
std::optional<gp_XY> advanceOnSeams(const TopoDS_Face& face, const Bounds& bounds) {
  gp_XY advance(0, 0);
  for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
    double first = 0, last = 0;
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull()) return {};
    bool onU = true, onV = true;
    for (const double part : {0.0, 0.3, 0.7, 1.0}) {
      const gp_Pnt2d at = curve->Value(first + part * (last - first));
      onU = onU && isAtSeam(at.X(), bounds.u1, bounds.u2);
      onV = onV && isAtSeam(at.Y(), bounds.v1, bounds.v2);
    }
    if (!onU && !onV) return {};
    const gp_XY along = curve->Value(last).XY() - curve->Value(first).XY();
    advance += edge.Orientation() == TopAbs_REVERSED ? -along : along;
  }
  return advance;
}

/// Whether the boundary of a face on a surface closed both ways runs to and fro along the seams.
bool hasLostItsSeams(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull() || !surface->IsUClosed() || !surface->IsVClosed()) return false;
  const Bounds bounds = boundsOf(surface);
  const std::optional<gp_XY> advance = advanceOnSeams(face, bounds);
  if (!advance || std::abs(advance->X()) > kOnSeam * (bounds.u2 - bounds.u1) ||
      std::abs(advance->Y()) > kOnSeam * (bounds.v2 - bounds.v1))
    return false;
  GProp_GProps area, boundary;
  BRepGProp::SurfaceProperties(face, area);
  BRepGProp::LinearProperties(face, boundary);
  return std::abs(area.Mass()) <= kOnSeam * boundary.Mass() * boundary.Mass();
}

/// Names and groups of the faces that were replaced go on.
void giveNamesTo(ReadShape& read, BRepTools_ReShape& replacing,
                 const std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>>& was) {
  read.shape = replacing.Apply(read.shape);
  for (ShapeGroup& group : read.groups)
    for (TopoDS_Shape& shape : group.shapes) shape = replacing.Apply(shape);
  if (!read.nameOf) return;
  read.nameOf = [was, nameOf = read.nameOf](const TopoDS_Face& face) {
    const auto found =
        std::ranges::find_if(was, [&](const auto& pair) { return pair.first.IsSame(face); });
    return nameOf(found == was.end() ? face : TopoDS::Face(found->second));
  };
}

void note(ReadShape& read, int count, const char* what) {
  if (count > 0) read.notes.push_back(std::to_string(count) + what);
}

}  // namespace

void giveWholeBoundaries(ReadShape& read) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(read.shape, TopAbs_FACE, faces);
  BRepTools_ReShape replacing;
  std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> was;  // by the new face: that of the reader
  int bare = 0, lost = 0;
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i));
    const bool isBare = !hasEdges(face);
    if (!isBare && !hasLostItsSeams(face)) continue;
    const TopoDS_Shape closed = withSeams(face);
    if (closed.IsNull()) continue;
    replacing.Replace(face, closed);
    was.emplace_back(closed, face);
    ++(isBare ? bare : lost);
  }
  if (bare + lost == 0) return;
  giveNamesTo(read, replacing, was);
  note(read, bare, " faces had no boundary; their seams were added");
  note(read, lost,
       " faces had a boundary along their seams that encloses nothing; it was completed");
}

}  // namespace af2::geometry
