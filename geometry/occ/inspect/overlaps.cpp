#include "geometry/occ/inspect/overlaps.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <set>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_division.h"
#include "geometry/occ/faces/face_boundary.h"
#include "geometry/occ/faces/faces_on_faces.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

namespace {

class OverlapFinder {
 public:
  OverlapFinder(const Model& model, double size) : shape_(model.shape()) { sizes_.size = size; }

  std::vector<Defect> find() {
    const SampledEdges sampled = sampleEdges(shape_, sizes_, kAllThreads, {});
    divided_ = divideEdges(shape_, sampled, sizes_, kAllThreads, {});
    lying_ = facesOnFaces(shape_, kAllThreads);
    findTwins();
    findTouching();
    for (const FaceOnFace& lying : lying_) addFace(lying);
    return std::move(defects_);
  }

 private:
  static constexpr int kAllThreads = 0;

  /// Whole edges, which may bound different faces.
  void findTwins() {
    for (std::size_t i = 0; i < divided_.edges.size(); ++i)
      if (const int twin = divided_.edges[i].twin; twin > 0)
        addEdges(0, static_cast<int>(i) + 1, twin, lengthOf(divided_.edges[i]), "");
  }

  double lengthOf(const DividedEdge& edge) const {
    double length = 0;
    for (std::size_t k = 1; k < edge.points.size(); ++k)
      length += distance(divided_.points[edge.points[k - 1]], divided_.points[edge.points[k]]);
    return length;
  }

  /// Parts of the boundary of a face between which it has no width.
  void findTouching() {
    std::vector<std::vector<FaceBoundary::TouchingEdges>> byFace(
        static_cast<std::size_t>(shape_.faces.Extent()));
    forEachInParallel(byFace.size(), kAllThreads, [&](std::size_t i) {
      const int face = static_cast<int>(i) + 1;
      try {
        byFace[i] = findBoundary(shape_, face, divided_, shape_.surface(face), lying_).touching;
      } catch (const GeometryError&) {  // reported as another defect
      } catch (const Standard_Failure&) {
      }
    });
    for (std::size_t i = 0; i < byFace.size(); ++i)
      for (const FaceBoundary::TouchingEdges& edges : byFace[i])
        addEdges(static_cast<int>(i) + 1, edges.one, edges.other, edges.length,
                 ": the face has no width there");
  }

  void addEdges(int face, int one, int other, double length, const std::string& rest) {
    if (!reported_.insert(std::minmax(one, other)).second) return;
    defects_.push_back({DefectKind::EdgeOnEdge, face, one, 0, length, middleOf(one),
                        "on edge " + std::to_string(other) + rest});
  }

  /// The origin if it has no curve.
  Point3 middleOf(int edge) const {
    double first, last;
    if (BRep_Tool::Curve(shape_.edge(edge), first, last).IsNull()) return {};
    const BRepAdaptor_Curve curve(shape_.edge(edge));
    return toPoint(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2));
  }

  void addFace(const FaceOnFace& lying) {
    const std::string under = "face " + std::to_string(lying.under);
    Point3 place;
    if (const TopExp_Explorer edge(shape_.face(lying.face), TopAbs_EDGE); edge.More())
      place = middleOf(shape_.edges.FindIndex(edge.Current()));
    defects_.push_back(
        {DefectKind::FaceOnFace, lying.face, 0, 0, 0, place,
         lying.isDouble() ? "is " + under + " again" : "lies on " + under + ", folded back"});
  }

  const ModelShape& shape_;
  CadSizes sizes_;
  DividedEdges divided_;
  std::vector<FaceOnFace> lying_;
  std::set<std::pair<int, int>> reported_;  // edges, the lower first
  std::vector<Defect> defects_;
};

}  // namespace

std::vector<Defect> findOverlaps(const Model& model, double size) {
  return OverlapFinder(model, size).find();
}

}  // namespace af2::geometry
