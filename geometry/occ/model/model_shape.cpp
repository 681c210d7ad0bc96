#include "geometry/occ/model/model_shape.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <set>

#include "geometry/occ/model/face_surfaces.h"
#include "geometry/occ/model/model.h"
#include "geometry/occ/model/whole_surfaces.h"

namespace af2::geometry {

namespace {

std::string surfaceTypeOf(const TopoDS_Face& face) {
  TopLoc_Location location;
  if (BRep_Tool::Surface(face, location).IsNull()) return "none";
  switch (BRepAdaptor_Surface(face, false).GetType()) {
    case GeomAbs_Plane:
      return "plane";
    case GeomAbs_Cylinder:
      return "cylinder";
    case GeomAbs_Cone:
      return "cone";
    case GeomAbs_Sphere:
      return "sphere";
    case GeomAbs_Torus:
      return "torus";
    case GeomAbs_BezierSurface:
      return "bezier";
    case GeomAbs_BSplineSurface:
      return "bspline";
    case GeomAbs_SurfaceOfRevolution:
      return "revolution";
    case GeomAbs_SurfaceOfExtrusion:
      return "extrusion";
    case GeomAbs_OffsetSurface:
      return "offset";
    default:
      return "other";
  }
}

void findUses(ModelShape& model) {
  model.facesOfEdges.resize(static_cast<std::size_t>(model.edges.Extent()));
  for (int id = 1; id <= model.faces.Extent(); ++id) {
    std::vector<EdgeUse>& uses = model.edgesOfFaces.emplace_back();
    for (TopExp_Explorer it(model.faces(id).Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More();
         it.Next()) {
      uses.push_back({model.edges.FindIndex(it.Current()), TopoDS::Edge(it.Current())});
      std::vector<int>& faces = model.facesOfEdges[static_cast<std::size_t>(uses.back().id) - 1];
      if (faces.empty() || faces.back() != id) faces.push_back(id);
    }
  }
}

/// Diagonal of a box around all vertices and edges; faces would cost a search for their extremes.
double diagonalOf(const ModelShape& model) {
  Bnd_Box box;
  for (int id = 1; id <= model.edges.Extent(); ++id) {
    try {
      Bnd_Box edgeBox;
      BRepBndLib::Add(model.edges(id), edgeBox, false);
      if (!edgeBox.IsOpen()) box.Add(edgeBox);
    } catch (const Standard_Failure&) {  // reported when the edge is divided
    }
  }
  if (box.IsVoid()) return 0;
  return std::sqrt(box.SquareExtent());
}

/// Some files give edges as curves in the parameters of a face only.
void buildMissingCurves(ModelShape& model) {
  for (int id = 1; id <= model.edges.Extent(); ++id) {
    const TopoDS_Edge edge = model.edge(id);
    double first, last;
    if (BRep_Tool::Degenerated(edge) || !BRep_Tool::Curve(edge, first, last).IsNull()) continue;
    try {
      if (BRepLib::BuildCurve3d(edge)) model.edgesWithoutCurve.push_back(id);
    } catch (const Standard_Failure&) {  // reported when the edge is divided
    }
  }
  if (!model.edgesWithoutCurve.empty())
    model.notes.push_back(std::to_string(model.edgesWithoutCurve.size()) +
                          " edges had no curve in space; their curves were built from their faces");
}

/// Finds faces of the model by the shapes of groups, which may have been placed anew: the same
/// geometry at the same place is the same face.
class FaceFinder {
 public:
  explicit FaceFinder(const ModelShape& model) : model_(model) {
    for (int id = 1; id <= model.faces.Extent(); ++id) {
      const int index = shapes_.Add(model.faces(id).Located(TopLoc_Location()));
      ids_.resize(static_cast<std::size_t>(shapes_.Extent()));
      ids_[static_cast<std::size_t>(index) - 1].push_back(id);
    }
  }

  void addFaces(const TopoDS_Shape& shape, std::set<int>& faces) const {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      if (const int id = find(it.Current()); id > 0) faces.insert(id);
  }

 private:
  int find(const TopoDS_Shape& face) const {
    const int index = shapes_.FindIndex(face.Located(TopLoc_Location()));
    if (index == 0) return 0;
    for (const int id : ids_[static_cast<std::size_t>(index) - 1])
      if (isSamePlace(model_.faces(id).Location(), face.Location())) return id;
    return 0;
  }
  static bool isSamePlace(const TopLoc_Location& a, const TopLoc_Location& b) {
    if (a == b) return true;
    constexpr double kSame = 1e-9;
    const gp_Trsf from = a.Transformation(), to = b.Transformation();
    for (int row = 1; row <= 3; ++row)
      for (int column = 1; column <= 4; ++column) {
        const double p = from.Value(row, column), q = to.Value(row, column);
        if (std::abs(p - q) > kSame * (1 + std::abs(p))) return false;
      }
    return true;
  }

  const ModelShape& model_;
  TopTools_IndexedMapOfShape shapes_;  // faces without their places
  std::vector<std::vector<int>> ids_;  // by these: ids of the model
};

/// The faces of a solid that the model has in the orientation of another solid.
std::vector<int> inwardFaces(const ModelShape& model, const TopoDS_Shape& solid) {
  std::set<int> inward, outward;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    if (const int id = model.faces.FindIndex(it.Current()); id > 0)
      (model.faces(id).Orientation() == it.Current().Orientation() ? outward : inward).insert(id);
  for (const int id : outward) inward.erase(id);
  return {inward.begin(), inward.end()};
}

/// The groups of the file, then the solids of the model.
std::vector<FaceGroup> faceGroups(const ModelShape& model, const std::vector<ShapeGroup>& read) {
  const FaceFinder finder(model);
  std::vector<FaceGroup> groups;
  const auto add = [&](const ShapeGroup& group) {
    std::set<int> faces;
    for (const TopoDS_Shape& shape : group.shapes) finder.addFaces(shape, faces);
    if (!faces.empty()) groups.push_back({group.name, group.kind, {faces.begin(), faces.end()}});
  };
  for (const ShapeGroup& group : read) add(group);
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(model.shape, TopAbs_SOLID, solids);
  for (int i = 1; i <= solids.Extent(); ++i) {
    const std::size_t before = groups.size();
    add({std::to_string(i), GroupKind::Solid, {solids(i)}});
    if (groups.size() > before) groups.back().inward = inwardFaces(model, solids(i));
  }
  return groups;
}

}  // namespace

TopoDS_Face ModelShape::face(int id) const {
  const TopoDS_Face face = TopoDS::Face(faces(id));
  // A mirrored place turns du x dv of the surface against the image of the normal.
  const bool isMirrored = face.Location().Transformation().IsNegative();
  return isMirrored ? TopoDS::Face(face.Reversed()) : face;
}
TopoDS_Edge ModelShape::edge(int id) const { return TopoDS::Edge(edges(id)); }
TopoDS_Vertex ModelShape::vertex(int id) const { return TopoDS::Vertex(vertices(id)); }
FaceSurface ModelShape::surface(int face) const { return surfaces->of(this->face(face), face); }

std::shared_ptr<const ModelShape> makeModelShape(ReadShape read) {
  auto model = std::make_shared<ModelShape>();
  giveWholeBoundaries(read);
  model->shape = read.shape;
  model->unit = std::move(read.unit);
  model->fileUnit = std::move(read.fileUnit);
  model->notes = std::move(read.notes);
  model->lostFaces = std::move(read.lostFaces);
  model->healing = std::move(read.healing);
  model->imprinting = std::move(read.imprinting);
  TopExp::MapShapes(model->shape, TopAbs_FACE, model->faces);
  TopExp::MapShapes(model->shape, TopAbs_EDGE, model->edges);
  TopExp::MapShapes(model->shape, TopAbs_VERTEX, model->vertices);
  model->edgesOfFile = model->edges.Extent();
  findUses(*model);
  for (int id = 1; id <= model->faces.Extent(); ++id) {
    model->faceNames.push_back(read.nameOf ? read.nameOf(model->face(id)) : "");
    model->surfaceTypes.push_back(surfaceTypeOf(model->face(id)));
  }
  model->groups = faceGroups(*model, read.groups);
  model->surfaces = std::make_shared<const FaceSurfaces>(model->faces.Extent());
  buildMissingCurves(*model);
  model->diagonal = diagonalOf(*model);
  return model;
}

}  // namespace af2::geometry
