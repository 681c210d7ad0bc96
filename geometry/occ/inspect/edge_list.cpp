#include "geometry/occ/inspect/edge_list.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <set>

#include "geometry/occ/base/points.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

namespace {

const char* kindOf(GeomAbs_CurveType type) {
  switch (type) {
    case GeomAbs_Line:
      return "line";
    case GeomAbs_Circle:
      return "circle";
    case GeomAbs_Ellipse:
      return "ellipse";
    case GeomAbs_Hyperbola:
      return "hyperbola";
    case GeomAbs_Parabola:
      return "parabola";
    case GeomAbs_BezierCurve:
      return "bezier";
    case GeomAbs_BSplineCurve:
      return "bspline";
    default:
      return "other";
  }
}

/// False if it has no curve, or that cannot be evaluated.
bool measure(const TopoDS_Edge& edge, EdgeEntry& entry) {
  double first, last;
  if (BRep_Tool::Degenerated(edge) || BRep_Tool::Curve(edge, first, last).IsNull()) return false;
  try {
    const BRepAdaptor_Curve curve(edge);
    entry.curve = kindOf(curve.GetType());
    entry.length = GCPnts_AbscissaPoint::Length(curve);
    entry.from = toPoint(curve.Value(curve.FirstParameter()));
    const bool isClosed = TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge));
    entry.to = isClosed ? entry.from : toPoint(curve.Value(curve.LastParameter()));
  } catch (const Standard_Failure&) {  // `defects` reports it
    return false;
  }
  return true;
}

}  // namespace

std::vector<EdgeEntry> edgesOf(const Model& model) {
  const ModelShape& shape = model.shape();
  std::vector<std::set<int>> faces(static_cast<std::size_t>(shape.edges.Extent()) + 1);
  for (int face = 1; face <= shape.faces.Extent(); ++face)
    for (TopExp_Explorer it(shape.face(face), TopAbs_EDGE); it.More(); it.Next())
      faces[static_cast<std::size_t>(shape.edges.FindIndex(it.Current()))].insert(face);
  std::vector<EdgeEntry> edges;
  for (int id = 1; id <= shape.edges.Extent(); ++id) {
    EdgeEntry entry;
    entry.id = id;
    if (!measure(shape.edge(id), entry)) continue;
    const std::set<int>& around = faces[static_cast<std::size_t>(id)];
    entry.faces.assign(around.begin(), around.end());
    edges.push_back(std::move(entry));
  }
  return edges;
}

}  // namespace af2::geometry
