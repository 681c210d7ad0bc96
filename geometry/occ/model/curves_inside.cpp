#include "geometry/occ/model/curves_inside.h"

#include <BRepClass_FaceClassifier.hxx>
#include <BRepLib.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/model/face_surfaces.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {
namespace {

constexpr double kNearFace = 1e-5;  // of the diagonal

/// A face with its surface, to find the parameters of points.
class FaceOfCurve {
 public:
  FaceOfCurve(const TopoDS_Face& face, double tolerance)
      : face_(face),
        surface_(new ShapeAnalysis_Surface(BRep_Tool::Surface(face))),
        tolerance_(tolerance) {}

  /// None if the point is not on the surface.
  std::optional<gp_Pnt2d> placeOf(const Point3& p) const {
    const gp_Pnt2d uv = surface_->ValueOfUV(toOcc(p), tolerance_);
    if (surface_->Value(uv).Distance(toOcc(p)) > tolerance_) return std::nullopt;
    return uv;
  }
  TopAbs_State stateOf(const gp_Pnt2d& uv) const {
    return BRepClass_FaceClassifier(face_, uv, tolerance_).State();
  }
  /// The place that differs from `uv` by whole periods and is nearest to `other`.
  gp_Pnt2d near(gp_Pnt2d uv, const gp_Pnt2d& other) const {
    const Handle(Geom_Surface) surface = surface_->Surface();
    const auto shifted = [](double value, double to, double period) {
      return value - std::round((value - to) / period) * period;
    };
    if (surface->IsUPeriodic()) uv.SetX(shifted(uv.X(), other.X(), surface->UPeriod()));
    if (surface->IsVPeriodic()) uv.SetY(shifted(uv.Y(), other.Y(), surface->VPeriod()));
    return uv;
  }

 private:
  TopoDS_Face face_;
  Handle(ShapeAnalysis_Surface) surface_;
  double tolerance_;
};

class CurveAdder {
 public:
  explicit CurveAdder(const ModelShape& before)
      : before_(before), tolerance_(kNearFace * before.diagonal) {
    for (int id = 1; id <= before.faces.Extent(); ++id)
      faces_.emplace_back(TopoDS::Face(before.faces(id).Oriented(TopAbs_FORWARD)), tolerance_);
  }

  void add(std::size_t number, const std::vector<Point3>& curve) {
    number_ = number;
    if (curve.size() < 2) refuse("needs at least two points");
    for (std::size_t i = 1; i < curve.size(); ++i) addPart(curve[i - 1], curve[i]);
  }

  std::shared_ptr<const ModelShape> result() {
    Handle(BRepTools_ReShape) change = new BRepTools_ReShape;
    change->ModeConsiderLocation() = true;
    for (const auto& [face, edges] : edges_)
      change->Replace(before_.faces(face), withEdges(before_.faces(face), edges));
    auto after = std::make_shared<ModelShape>(before_);
    after->shape = change->Apply(before_.shape);
    after->faces.Clear();
    after->vertices.Clear();
    TopExp::MapShapes(after->shape, TopAbs_FACE, after->faces);
    TopExp::MapShapes(after->shape, TopAbs_VERTEX, after->vertices);
    const int all = before_.edges.Extent() + static_cast<int>(count_);
    if (after->faces.Extent() == before_.faces.Extent()) numberEdges(*after);
    if (after->edges.Extent() != all)
      throw InputError(
          "the curves inside faces could not be added to this model without changing its faces and "
          "edges");
    after->edgesOfFile = all;
    after->surfaces = std::make_shared<const FaceSurfaces>(after->faces.Extent());
    return after;
  }

 private:
  [[noreturn]] void refuse(const std::string& fault) const {
    throw InputError("curve " + std::to_string(number_) + " inside faces " + fault);
  }

  void addPart(const Point3& from, const Point3& to) {
    if (distance(from, to) <= tolerance_)
      refuse("has two points at " + af2::textOf(from, 6) + ", one after the other");
    for (int face = 1; face <= before_.faces.Extent(); ++face) {
      try {
        if (addOnFace(face, from, to)) return;
      } catch (const Standard_Failure&) {  // as if the points were not on the face
      }
    }
    refuse("is not inside one face between " + af2::textOf(from, 6) + " and " + af2::textOf(to, 6) +
           "; give it a point where it passes an edge, and points on the model");
  }

  bool addOnFace(int id, const Point3& from, const Point3& to) {
    const FaceOfCurve& face = faces_[static_cast<std::size_t>(id) - 1];
    const auto start = face.placeOf(from), end = face.placeOf(to);
    if (!start || !end) return false;
    if (face.stateOf(*start) == TopAbs_OUT || face.stateOf(*end) == TopAbs_OUT) return false;
    const gp_Pnt2d last = face.near(*end, *start);
    for (const double share : {0.25, 0.5, 0.75}) {
      const gp_Pnt2d between(start->X() + share * (last.X() - start->X()),
                             start->Y() + share * (last.Y() - start->Y()));
      if (face.stateOf(face.near(between, *start)) != TopAbs_IN) return false;
    }
    edges_[id].push_back(edgeBetween(id, from, to, *start, last));
    ++count_;
    return true;
  }

  /// Straight in the parameters.
  TopoDS_Edge edgeBetween(int id, const Point3& from, const Point3& to, const gp_Pnt2d& start,
                          const gp_Pnt2d& end) {
    const TopoDS_Face face = TopoDS::Face(before_.faces(id).Oriented(TopAbs_FORWARD));
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, new Geom2d_Line(start, gp_Dir2d(gp_Vec2d(start, end))), face,
                       Precision::Confusion());
    builder.Add(edge, vertexAt(from).Oriented(TopAbs_FORWARD));
    builder.Add(edge, vertexAt(to).Oriented(TopAbs_REVERSED));
    builder.Range(edge, 0, start.Distance(end));
    BRepLib::BuildCurve3d(edge, Precision::Confusion());
    return edge;
  }

  /// One of the model, one that another part has there, or a new one.
  TopoDS_Vertex vertexAt(const Point3& p) {
    for (int id = 1; id <= before_.vertices.Extent(); ++id)
      if (distance(toPoint(BRep_Tool::Pnt(before_.vertex(id))), p) <= tolerance_)
        return before_.vertex(id);
    for (const TopoDS_Vertex& vertex : vertices_)
      if (distance(toPoint(BRep_Tool::Pnt(vertex)), p) <= tolerance_) return vertex;
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, toOcc(p), tolerance_);
    vertices_.push_back(vertex);
    return vertex;
  }

  /// In a wire of their own. Parts are added to a face that looks forward: the builder reverses
  /// them otherwise.
  static TopoDS_Shape withEdges(const TopoDS_Shape& face, const std::vector<TopoDS_Edge>& edges) {
    const BRep_Builder builder;
    TopoDS_Shape copy = face.EmptyCopied().Oriented(TopAbs_FORWARD);
    for (TopoDS_Iterator it(face.Oriented(TopAbs_FORWARD)); it.More(); it.Next())
      builder.Add(copy, it.Value());
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Edge& edge : edges) builder.Add(wire, edge.Oriented(TopAbs_INTERNAL));
    builder.Add(copy, wire);
    return copy.Oriented(face.Orientation());
  }

  /// Those of the model keep their ids.
  void numberEdges(ModelShape& after) const {
    for (const auto& [face, edges] : edges_)
      for (TopExp_Explorer it(after.faces(face).Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More();
           it.Next()) {
        if (before_.edges.Contains(it.Current())) continue;
        const int id = after.edges.Add(it.Current());
        after.edgesOfFaces[static_cast<std::size_t>(face) - 1].push_back(
            {id, TopoDS::Edge(it.Current())});
        after.facesOfEdges.push_back({face});
      }
  }

  const ModelShape& before_;
  double tolerance_;
  std::size_t number_ = 0, count_ = 0;
  std::vector<FaceOfCurve> faces_;
  std::vector<TopoDS_Vertex> vertices_;
  std::map<int, std::vector<TopoDS_Edge>> edges_;  // by face
};

}  // namespace

Model withCurvesInside(const Model& model, std::span<const std::vector<Point3>> curves) {
  if (curves.empty()) return model;
  CurveAdder adder(model.shape());
  for (std::size_t i = 0; i < curves.size(); ++i) adder.add(i + 1, curves[i]);
  return Model(adder.result());
}

}  // namespace af2::geometry
