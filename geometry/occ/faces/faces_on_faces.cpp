#include "geometry/occ/faces/faces_on_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "engine/base/parallel.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {

namespace {

/// An edge as a face runs along it.
struct Use {
  int face = 0;
  TopoDS_Edge edge;
};

/// Whether points are on a face.
class OnFace {
 public:
  OnFace(const TopoDS_Face& face, double tolerance)
      : surface_(new ShapeAnalysis_Surface(BRep_Tool::Surface(face))),
        within_(face, Precision::PConfusion()),
        tolerance_(tolerance) {}

  bool has(const gp_Pnt& point) {
    const gp_Pnt2d uv = surface_->ValueOfUV(point, Precision::Confusion());
    return surface_->Gap() <= tolerance_ && within_.Perform(uv) != TopAbs_OUT;
  }

 private:
  Handle(ShapeAnalysis_Surface) surface_;
  BRepTopAdaptor_FClass2d within_;
  double tolerance_;
};

/// The direction into the face across the middle of an edge that it runs along.
std::optional<Point3> inwards(const TopoDS_Face& face, const TopoDS_Edge& edge) {
  constexpr double kMiddle = 0.5;
  if (BRep_Tool::Degenerated(edge)) return std::nullopt;
  const BRepAdaptor_Curve curve(edge);
  gp_Pnt at;
  gp_Vec along, du, dv;
  curve.D1(curve.FirstParameter() + kMiddle * (curve.LastParameter() - curve.FirstParameter()), at,
           along);
  const BRepAdaptor_Surface surface(face, Standard_False);
  gp_Pnt2d uv;
  if (surface.GetType() != GeomAbs_Plane) {
    double first, last;
    const Handle(Geom2d_Curve) flat = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (flat.IsNull()) return std::nullopt;
    uv = flat->Value(first + kMiddle * (last - first));
  }
  surface.D1(uv.X(), uv.Y(), at, du, dv);
  gp_Vec into = du.Crossed(dv).Crossed(along);
  if (face.Orientation() == TopAbs_REVERSED) into.Reverse();
  if (edge.Orientation() == TopAbs_REVERSED) into.Reverse();
  if (!(into.Magnitude() > 0)) return std::nullopt;
  return toPoint(into.Normalized());
}

class Finder {
 public:
  Finder(const ModelShape& model, int threads) : model_(model), threads_(threads) {
    uses_.resize(static_cast<std::size_t>(model.edges.Extent()));
    for (int face = 1; face <= model.faces.Extent(); ++face)
      for (TopExp_Explorer it(model.face(face), TopAbs_EDGE); it.More(); it.Next())
        usesOf(model.edges.FindIndex(it.Current())).push_back({face, TopoDS::Edge(it.Current())});
  }

  std::vector<FaceOnFace> find() {
    std::vector<FaceOnFace> found;
    std::set<int> lying, carrying;
    for (const auto& [first, second] : candidates())
      for (const auto& [face, under] : {std::pair{second, first}, {first, second}}) {
        if (lying.contains(face) || lying.contains(under) || carrying.contains(face)) continue;
        std::optional<FaceOnFace> one = lieOn(face, under);
        if (!one) continue;
        found.push_back(*std::move(one));
        lying.insert(face);
        carrying.insert(under);
      }
    std::ranges::sort(found, {}, &FaceOnFace::face);
    return found;
  }

 private:
  std::vector<Use>& usesOf(int edge) { return uses_[static_cast<std::size_t>(edge) - 1]; }
  const std::vector<Use>& usesOf(int edge) const {
    return uses_[static_cast<std::size_t>(edge) - 1];
  }

  /// Pairs of faces that begin in the same direction at an edge of both.
  std::set<std::pair<int, int>> candidates() const {
    std::vector<std::vector<std::pair<int, int>>> byEdge(uses_.size());
    forEachInParallel(uses_.size(), threads_, [&](std::size_t i) {
      try {
        byEdge[i] = candidatesAt(uses_[i]);
      } catch (const Standard_Failure&) {  // reported when the face is meshed
      }
    });
    std::set<std::pair<int, int>> all;
    for (const auto& pairs : byEdge) all.insert(pairs.begin(), pairs.end());
    return all;
  }

  std::vector<std::pair<int, int>> candidatesAt(const std::vector<Use>& uses) const {
    constexpr double kSame = 0.9999;  // cosine
    constexpr std::size_t kMaxUses = 6;
    std::vector<std::pair<int, int>> pairs;
    if (uses.size() < 2 || uses.size() > kMaxUses) return pairs;
    std::vector<std::optional<Point3>> into;
    for (const Use& use : uses) into.push_back(inwards(model_.face(use.face), use.edge));
    for (std::size_t i = 0; i < uses.size(); ++i)
      for (std::size_t k = i + 1; k < uses.size(); ++k)
        if (uses[i].face != uses[k].face && into[i] && into[k] && dot(*into[i], *into[k]) > kSame)
          pairs.emplace_back(std::minmax(uses[i].face, uses[k].face));
    return pairs;
  }

  std::optional<FaceOnFace> lieOn(int face, int under) const {
    auto [own, shared] = edgesBeside(face, under);
    FaceOnFace result{face, under, std::move(shared)};
    if (own.empty())
      result.folds.clear();
    else if (!std::ranges::all_of(result.folds, [&](int edge) { return isFold(edge); }))
      return std::nullopt;
    try {
      if (!liesOn(face, under, own) || isSlit(result)) return std::nullopt;
    } catch (const Standard_Failure&) {
      return std::nullopt;
    }
    return result;
  }

  struct Edges {
    std::vector<TopoDS_Edge> own;
    std::vector<int> shared;
  };
  /// Those of a face that another one does not have, and those that it has.
  Edges edgesBeside(int face, int other) const {
    Edges edges;
    for (TopExp_Explorer it(model_.face(face), TopAbs_EDGE); it.More(); it.Next()) {
      const int edge = model_.edges.FindIndex(it.Current());
      if (std::ranges::count(usesOf(edge), other, &Use::face) == 0)
        edges.own.push_back(TopoDS::Edge(it.Current()));
      else
        edges.shared.push_back(edge);
    }
    return edges;
  }

  /// Whether each of the two lies on the other one, and both end at vertices of their own. Nothing
  /// would be left of them, and what is beyond would not meet.
  bool isSlit(const FaceOnFace& one) const {
    return !one.isDouble() && !std::ranges::includes(verticesOf(one.under), verticesOf(one.face)) &&
           liesOn(one.under, one.face, edgesBeside(one.under, one.face).own);
  }

  std::set<int> verticesOf(int face) const {
    std::set<int> vertices;
    for (TopExp_Explorer it(model_.face(face), TopAbs_VERTEX); it.More(); it.Next())
      vertices.insert(model_.vertices.FindIndex(it.Current()));
    return vertices;
  }

  /// Whether two faces have an edge, and run along it to and fro.
  bool isFold(int edge) const {
    const std::vector<Use>& uses = usesOf(edge);
    return uses.size() == 2 && uses[0].edge.Orientation() != uses[1].edge.Orientation();
  }

  bool liesOn(int face, int under, const std::vector<TopoDS_Edge>& own) const {
    constexpr double kTolerance = 1e-6;  // of the diagonal
    OnFace below(model_.face(under), kTolerance * model_.diagonal);
    for (const TopoDS_Edge& edge : own) {
      if (BRep_Tool::Degenerated(edge)) continue;
      const BRepAdaptor_Curve curve(edge);
      for (const double t : {0.21, 0.5, 0.83})
        if (!below.has(curve.Value(curve.FirstParameter() +
                                   t * (curve.LastParameter() - curve.FirstParameter()))))
          return false;
    }
    const std::vector<gp_Pnt> inside = pointsInside(model_.face(face));
    return !inside.empty() &&
           std::ranges::all_of(inside, [&](const gp_Pnt& point) { return below.has(point); });
  }

  static std::vector<gp_Pnt> pointsInside(const TopoDS_Face& face) {
    constexpr int kPoints = 6;  // along each parameter
    double u1, u2, v1, v2;
    BRepTools::UVBounds(face, u1, u2, v1, v2);
    const BRepTopAdaptor_FClass2d within(face, Precision::PConfusion());
    const BRepAdaptor_Surface surface(face, Standard_False);
    std::vector<gp_Pnt> points;
    for (int i = 0; i < kPoints; ++i)
      for (int k = 0; k < kPoints; ++k) {
        const gp_Pnt2d uv(u1 + (i + 0.5) / kPoints * (u2 - u1),
                          v1 + (k + 0.5) / kPoints * (v2 - v1));
        if (within.Perform(uv) == TopAbs_IN) points.push_back(surface.Value(uv.X(), uv.Y()));
      }
    return points;
  }

  const ModelShape& model_;
  int threads_;
  std::vector<std::vector<Use>> uses_;  // by edge
};

}  // namespace

std::vector<FaceOnFace> facesOnFaces(const ModelShape& model, int threads) {
  return Finder(model, threads).find();
}

}  // namespace af2::geometry
