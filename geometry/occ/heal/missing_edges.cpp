#include "geometry/occ/heal/missing_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace af2::geometry {

namespace {

/// Where a wire ends, and where it begins.
struct Opening {
  TopoDS_Vertex end, start;
};

class Closer {
 public:
  Closer(const TopoDS_Shape& shape, double tolerance) : tolerance_(tolerance) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, facesOf_);
  }

  std::vector<ClosedFace> close() {
    for (int i = 1; i <= faces_.Extent(); ++i) closeFace(TopoDS::Face(faces_(i)));
    return std::move(closed_);
  }

 private:
  void closeFace(const TopoDS_Face& given) {
    const TopoDS_Face face = TopoDS::Face(given.Oriented(TopAbs_FORWARD));
    BRep_Builder builder;
    TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
    ClosedFace closed{given, {}, {}};
    for (TopoDS_Iterator it(face); it.More(); it.Next()) {
      const auto opening = it.Value().ShapeType() == TopAbs_WIRE
                               ? openingOf(TopoDS::Wire(it.Value()))
                               : std::nullopt;
      if (!opening) {
        builder.Add(made, it.Value());
        continue;
      }
      const auto addition = edgeFor(*opening, face, TopoDS::Wire(it.Value()));
      if (!addition) return;
      builder.Add(made, withEdge(it.Value(), addition->edge));
      closed.added.push_back(*addition);
    }
    if (closed.added.empty() || !hasArea(made)) return;
    for (const ClosedFace::Addition& addition : closed.added)
      if (addition.isNew) added_.push_back(addition.edge);
    closed.after = made.Oriented(given.Orientation());
    closed_.push_back(std::move(closed));
  }

  /// Nothing if the wire is closed, or open at several places.
  std::optional<Opening> openingOf(const TopoDS_Wire& wire) const {
    std::map<int, int> balance;  // by vertex: edges that begin there, less those that end
    for (TopExp_Explorer it(wire.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      const TopoDS_Vertex from = TopExp::FirstVertex(edge, true),
                          to = TopExp::LastVertex(edge, true);
      if (from.IsNull() || to.IsNull()) return std::nullopt;
      ++balance[vertices_.FindIndex(from)];
      --balance[vertices_.FindIndex(to)];
    }
    Opening opening;
    for (const auto& [vertex, count] : balance) {
      if (count == 0) continue;
      TopoDS_Vertex& place = count > 0 ? opening.start : opening.end;
      if (std::abs(count) > 1 || !place.IsNull()) return std::nullopt;
      place = TopoDS::Vertex(vertices_(vertex).Oriented(TopAbs_FORWARD));
    }
    if (opening.start.IsNull() || opening.end.IsNull() || isGap(opening)) return std::nullopt;
    return opening;
  }

  /// So near that the two are to be one vertex.
  bool isGap(const Opening& opening) const {
    const double most = BRep_Tool::Tolerance(opening.end) + BRep_Tool::Tolerance(opening.start);
    return BRep_Tool::Pnt(opening.end).Distance(BRep_Tool::Pnt(opening.start)) <=
           std::max(tolerance_, most);
  }

  /// In the direction from the end of the wire to its start.
  std::optional<ClosedFace::Addition> edgeFor(const Opening& opening, const TopoDS_Face& face,
                                              const TopoDS_Wire& wire) const {
    for (int i = 1; i <= facesOf_.Extent(); ++i)
      if (facesOf_(i).Extent() == 1 && !facesOf_(i).First().IsSame(face))
        if (const auto edge = directed(TopoDS::Edge(facesOf_.FindKey(i)), opening, face))
          return ClosedFace::Addition{*edge, false};
    for (const TopoDS_Edge& added : added_)
      if (const auto edge = directed(added, opening, face))
        return ClosedFace::Addition{*edge, false};
    const TopoDS_Edge made = newEdge(opening, face, wire);
    if (made.IsNull()) return std::nullopt;
    return ClosedFace::Addition{made, true};
  }

  /// An edge as the wire needs it, if it joins these vertices and lies on the face.
  std::optional<TopoDS_Edge> directed(const TopoDS_Edge& given, const Opening& opening,
                                      const TopoDS_Face& face) const {
    const TopoDS_Edge edge = TopoDS::Edge(given.Oriented(TopAbs_FORWARD));
    if (BRep_Tool::Degenerated(edge)) return std::nullopt;
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    const bool isForward = first.IsSame(opening.end) && last.IsSame(opening.start);
    const bool isReversed = last.IsSame(opening.end) && first.IsSame(opening.start);
    if (!(isForward || isReversed) || !liesOn(edge, face)) return std::nullopt;
    return TopoDS::Edge(edge.Oriented(isForward ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  bool liesOn(const TopoDS_Edge& edge, const TopoDS_Face& face) const {
    constexpr int kPoints = 4;
    const BRepAdaptor_Curve curve(edge);
    ShapeAnalysis_Surface surface(BRep_Tool::Surface(face));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    for (int i = 1; i <= kPoints; ++i) {
      const gp_Pnt place = curve.Value(first + (last - first) * i / (kPoints + 1));
      const gp_Pnt2d uv = surface.ValueOfUV(place, Precision::Confusion());
      if (!(surface.Value(uv).Distance(place) <= tolerance_ + BRep_Tool::Tolerance(edge)))
        return false;
    }
    return true;
  }

  static TopoDS_Edge newEdge(const Opening& opening, const TopoDS_Face& face,
                             const TopoDS_Wire& wire) {
    if (BRepAdaptor_Surface(face, false).GetType() == GeomAbs_Plane) {
      BRepBuilderAPI_MakeEdge maker(opening.end, opening.start);
      return maker.IsDone() ? maker.Edge() : TopoDS_Edge();
    }
    const auto from = parametersAt(opening.end, face, wire);
    const auto to = parametersAt(opening.start, face, wire);
    if (!from || !to || from->Distance(*to) < Precision::PConfusion()) return {};
    const gp_Vec2d way(*from, *to);
    BRepBuilderAPI_MakeEdge maker(new Geom2d_Line(*from, gp_Dir2d(way)), BRep_Tool::Surface(face),
                                  opening.end, opening.start, 0, way.Magnitude());
    if (!maker.IsDone() || !BRepLib::BuildCurve3d(maker.Edge())) return {};
    return maker.Edge();
  }

  /// Where the edge of the wire that ends at a vertex does so.
  static std::optional<gp_Pnt2d> parametersAt(const TopoDS_Vertex& vertex, const TopoDS_Face& face,
                                              const TopoDS_Wire& wire) {
    for (TopExp_Explorer it(wire, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      double first, last;
      if (BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull()) continue;
      gp_Pnt2d start, end;
      BRep_Tool::UVPoints(edge, face, start, end);
      if (TopExp::FirstVertex(edge, true).IsSame(vertex)) return start;
      if (TopExp::LastVertex(edge, true).IsSame(vertex)) return end;
    }
    return std::nullopt;
  }

  static TopoDS_Wire withEdge(const TopoDS_Shape& wire, const TopoDS_Edge& edge) {
    BRep_Builder builder;
    TopoDS_Wire made;
    builder.MakeWire(made);
    for (TopoDS_Iterator it(wire.Oriented(TopAbs_FORWARD)); it.More(); it.Next())
      builder.Add(made, it.Value());
    builder.Add(made, edge);
    made.Closed(true);
    return TopoDS::Wire(made.Oriented(wire.Orientation()));
  }

  /// Edges that only run to and fro bound nothing.
  static bool hasArea(const TopoDS_Face& face) {
    constexpr double kMin = 1e-6;  // of the square of the boundary's length
    GProp_GProps surface, boundary;
    BRepGProp::SurfaceProperties(face, surface);
    BRepGProp::LinearProperties(face, boundary);
    return std::abs(surface.Mass()) > kMin * boundary.Mass() * boundary.Mass();
  }

  double tolerance_;
  TopTools_IndexedMapOfShape faces_, vertices_;
  TopTools_IndexedDataMapOfShapeListOfShape facesOf_;  // by edge
  std::vector<TopoDS_Edge> added_;
  std::vector<ClosedFace> closed_;
};

}  // namespace

std::vector<ClosedFace> closeOpenLoops(const TopoDS_Shape& shape, double tolerance) {
  return Closer(shape, tolerance).close();
}

}  // namespace af2::geometry
