#include "geometry/occ/merge/background.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>

#include "geometry/occ/algorithms/triangulation.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {

namespace {

constexpr double kTurn = 0.25;  // radians from one triangle to the next

class Background {
 public:
  explicit Background(const ModelShape& model) : model_(model) {}

  BackgroundFacets make(const std::vector<int>& faces) {
    for (const int face : faces) {
      try {
        addFace(face);
      } catch (const Standard_Failure&) {
        facets_.failed.insert(face);
      }
    }
    return std::move(facets_);
  }

  /// Triangulates a copy of the faces, because that changes shapes, which threads share.
  void triangulate(const std::vector<int>& faces, double deflection) {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    for (const int face : faces) builder.Add(compound, model_.face(face));
    constexpr bool kCopiesGeometry = false, kCopiesMesh = false;
    copy_ = BRepBuilderAPI_Copy(compound, kCopiesGeometry, kCopiesMesh);
    geometry::triangulate(copy_.Shape(), deflection, kTurn);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  struct EdgeNodes {
    const EdgeUse* use;
    Handle(Poly_PolygonOnTriangulation) nodes;
  };

  void addFace(int id) {
    const TopoDS_Face face = TopoDS::Face(model_.face(id));
    const TopoDS_Face copied = TopoDS::Face(copy_.ModifiedShape(face));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(copied, location);
    if (mesh.IsNull() || mesh->NbTriangles() == 0 || !mesh->HasUVNodes()) {
      facets_.failed.insert(id);
      return;
    }
    std::vector<std::uint32_t> ids(static_cast<std::size_t>(mesh->NbNodes()) + 1, kNone);
    const auto placeOf = [&](int node) {
      return toPoint(mesh->Node(node).Transformed(location.Transformation()));
    };
    for (const EdgeUse& use : model_.edgesOfFaces[static_cast<std::size_t>(id) - 1])
      if (!addEdge(id, use, mesh, location, placeOf, ids)) {
        facets_.failed.insert(id);
        return;
      }
    for (int node = 1; node <= mesh->NbNodes(); ++node)
      if (ids[static_cast<std::size_t>(node)] == kNone)
        ids[static_cast<std::size_t>(node)] = addVertex(placeOf(node));
    addTriangles(id, *mesh, face.Orientation() == TopAbs_REVERSED, ids);
  }

  std::uint32_t addVertex(const Point3& place) {
    facets_.vertices.push_back(place);
    return static_cast<std::uint32_t>(facets_.vertices.size() - 1);
  }

  std::uint32_t vertexOf(int vertex) {
    const auto [at, isNew] = vertices_.try_emplace(vertex, 0u);
    if (isNew) at->second = addVertex(toPoint(BRep_Tool::Pnt(model_.vertex(vertex))));
    return at->second;
  }

  /// Numbers the nodes of a face along an edge as they are numbered on the other faces there.
  template <class PlaceOf>
  bool addEdge(int id, const EdgeUse& use, const Handle(Poly_Triangulation) & mesh,
               const TopLoc_Location& location, const PlaceOf& placeOf,
               std::vector<std::uint32_t>& ids) {
    const TopAbs_Orientation way = use.edge.Orientation();
    if (way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL) return true;
    const TopoDS_Edge copied =
        TopoDS::Edge(copy_.ModifiedShape(use.edge.Oriented(TopAbs_FORWARD)).Oriented(way));
    const Handle(Poly_PolygonOnTriangulation) polygon =
        BRep_Tool::PolygonOnTriangulation(copied, mesh, location);
    if (polygon.IsNull()) return BRep_Tool::Degenerated(use.edge);
    const auto at = [&](int i) -> std::uint32_t& {
      return ids[static_cast<std::size_t>(polygon->Node(i))];
    };
    const int count = polygon->NbNodes();
    const TopoDS_Edge forward = TopoDS::Edge(use.edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
    if (first.IsNull() || last.IsNull() || count < 2) return false;
    const auto number = [&](const TopoDS_Vertex& vertex) {
      return vertexOf(model_.vertices.FindIndex(vertex));
    };
    const std::uint32_t from = number(first), to = number(last);
    if (BRep_Tool::Degenerated(use.edge)) {
      for (int i = 1; i <= count; ++i) at(i) = from;
      return true;
    }
    std::vector<std::uint32_t>& inner = inner_[use.id];
    if (inner.empty())
      for (int i = 2; i < count; ++i) inner.push_back(addVertex(placeOf(polygon->Node(i))));
    if (inner.size() + 2 != static_cast<std::size_t>(count)) return false;
    at(1) = from;
    at(count) = to;
    for (int i = 2; i < count; ++i) at(i) = inner[static_cast<std::size_t>(i) - 2];
    for (int i = 1; i < count; ++i) {
      const std::uint32_t a = at(i), b = at(i + 1);
      facets_.edges[{id, std::min(a, b), std::max(a, b)}] = {
          use.id, static_cast<std::uint32_t>(i - 1), a < b};
    }
    facets_.pieces[use.id] = static_cast<std::uint32_t>(count - 1);
    return true;
  }

  void addTriangles(int face, const Poly_Triangulation& mesh, bool isReversed,
                    const std::vector<std::uint32_t>& ids) {
    for (int t = 1; t <= mesh.NbTriangles(); ++t) {
      std::array<int, 3> nodes{};
      mesh.Triangle(t).Get(nodes[0], nodes[1], nodes[2]);
      if (isReversed) std::swap(nodes[1], nodes[2]);
      std::array<std::uint32_t, 3> corners{};
      std::array<Point2, 3> places{};
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = ids[static_cast<std::size_t>(nodes[i])];
        const gp_Pnt2d uv = mesh.UVNode(nodes[i]);
        places[i] = {uv.X(), uv.Y()};
      }
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        continue;  // at a pole
      facets_.triangles.push_back(corners);
      facets_.face.push_back(face);
      facets_.parameters.push_back(places);
    }
  }

  const ModelShape& model_;
  BRepBuilderAPI_Copy copy_;
  BackgroundFacets facets_;
  std::map<int, std::uint32_t> vertices_;            // by vertex of the model
  std::map<int, std::vector<std::uint32_t>> inner_;  // by edge: vertices between its ends
};

}  // namespace

BackgroundFacets backgroundOf(const ModelShape& model, const std::vector<int>& faces,
                              double deflection) {
  Background background(model);
  try {
    background.triangulate(faces, deflection);
  } catch (const Standard_Failure&) {
    BackgroundFacets none;
    none.failed.insert(faces.begin(), faces.end());
    return none;
  }
  return background.make(faces);
}

}  // namespace af2::geometry
