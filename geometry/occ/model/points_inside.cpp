#include "geometry/occ/model/points_inside.h"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <map>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/occ/model/face_surfaces.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {
namespace {

constexpr double kOnFace = 1e-5;  // of the diagonal

[[noreturn]] void refusePoint(std::size_t index, const Point3& p, const std::string& fault) {
  throw InputError("point " + std::to_string(index + 1) + " inside faces, " + af2::textOf(p, 6) +
                   ": " + fault);
}

/// The first face on which a point lies.
int faceAt(const ModelShape& model, std::size_t index, const Point3& p) {
  const double tolerance = kOnFace * model.diagonal;
  for (int id = 1; id <= model.faces.Extent(); ++id) {
    try {
      const TopoDS_Face face = TopoDS::Face(model.faces(id));
      ShapeAnalysis_Surface surface(BRep_Tool::Surface(face));
      const gp_Pnt2d uv = surface.ValueOfUV(gp_Pnt(p.x, p.y, p.z), tolerance);
      if (surface.Value(uv).Distance(gp_Pnt(p.x, p.y, p.z)) > tolerance) continue;
      const BRepClass_FaceClassifier where(face, uv, tolerance);
      if (where.State() == TopAbs_ON)
        refusePoint(index, p,
                    "it is on an edge of face " + std::to_string(id) +
                        "; --boundary divides edges at given points");
      if (where.State() == TopAbs_IN) return id;
    } catch (const Standard_Failure&) {
    }
  }
  refusePoint(index, p, "it is on no face of the model");
}

/// Parts are added to a face that looks forward: the builder reverses them otherwise.
TopoDS_Shape withVertices(const TopoDS_Shape& face, const std::vector<Point3>& points) {
  BRep_Builder builder;
  TopoDS_Shape copy = face.EmptyCopied().Oriented(TopAbs_FORWARD);
  for (TopoDS_Iterator it(face.Oriented(TopAbs_FORWARD)); it.More(); it.Next())
    builder.Add(copy, it.Value());
  for (const Point3& p : points)
    builder.Add(
        copy, BRepBuilderAPI_MakeVertex(gp_Pnt(p.x, p.y, p.z)).Vertex().Oriented(TopAbs_INTERNAL));
  return copy.Oriented(face.Orientation());
}

}  // namespace

Model withPointsInside(const Model& model, std::span<const Point3> points) {
  if (points.empty()) return model;
  const ModelShape& before = model.shape();
  std::map<int, std::vector<Point3>> byFace;
  for (std::size_t i = 0; i < points.size(); ++i)
    byFace[faceAt(before, i, points[i])].push_back(points[i]);
  Handle(BRepTools_ReShape) change = new BRepTools_ReShape;
  change->ModeConsiderLocation() = true;
  for (const auto& [face, own] : byFace)
    change->Replace(before.faces(face), withVertices(before.faces(face), own));
  auto after = std::make_shared<ModelShape>(before);
  after->shape = change->Apply(before.shape);
  after->faces.Clear();
  after->vertices.Clear();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(after->shape, TopAbs_FACE, after->faces);
  TopExp::MapShapes(after->shape, TopAbs_EDGE, edges);
  TopExp::MapShapes(after->shape, TopAbs_VERTEX, after->vertices);
  bool isAlike =
      after->faces.Extent() == before.faces.Extent() && edges.Extent() == before.edges.Extent() &&
      after->vertices.Extent() == before.vertices.Extent() + static_cast<int>(points.size());
  for (int id = 1; isAlike && id <= edges.Extent(); ++id)
    isAlike = edges(id).IsSame(before.edges(id));
  if (!isAlike)
    throw InputError(
        "the points inside faces could not be added to this model without changing "
        "its faces and edges");
  after->surfaces = std::make_shared<const FaceSurfaces>(after->faces.Extent());
  return Model(std::move(after));
}

}  // namespace af2::geometry
