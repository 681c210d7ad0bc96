#include "geometry/occ/inspect/defects.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GCPnts_QuasiUniformDeflection.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "geometry/base/constants.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/faces/crossed_edges.h"
#include "geometry/occ/faces/edge_sides.h"
#include "geometry/occ/faces/face_area.h"
#include "geometry/occ/inspect/overlaps.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

namespace {

/// Below this share of the mesh size.
constexpr double kGap = 1e-4;

/// Empty: follows from others, or concerns the mesh that some models bring along.
std::string wordsFor(BRepCheck_Status status) {
  switch (status) {
    case BRepCheck_InvalidPointOnCurve:
    case BRepCheck_InvalidPointOnCurveOnSurface:
    case BRepCheck_InvalidPointOnSurface:
      return "a vertex is not on its edge or face";
    case BRepCheck_InvalidCurveOnSurface:
    case BRepCheck_InvalidCurveOnClosedSurface:
      return "an edge leaves the surface by more than its tolerance";
    case BRepCheck_NoCurveOnSurface:
      return "an edge has no curve in the parameters";
    case BRepCheck_InvalidSameRangeFlag:
    case BRepCheck_InvalidSameParameterFlag:
      return "the curves of an edge have different parameters";
    case BRepCheck_InvalidDegeneratedFlag:
      return "an edge is wrongly marked as a point";
    case BRepCheck_InvalidMultiConnexity:
      return "an edge has too many faces";
    case BRepCheck_InvalidRange:
      return "the range of an edge is invalid";
    case BRepCheck_RedundantEdge:
      return "a loop has an edge twice";
    case BRepCheck_SelfIntersectingWire:
      return "a loop crosses itself";
    case BRepCheck_RedundantWire:
      return "a loop occurs twice";
    case BRepCheck_IntersectingWires:
      return "loops cross";
    case BRepCheck_InvalidImbricationOfWires:
      return "loops are nested incorrectly";
    case BRepCheck_UnorientableShape:
    case BRepCheck_BadOrientation:
    case BRepCheck_BadOrientationOfSubshape:
      return "wrong orientation";
    case BRepCheck_InvalidToleranceValue:
      return "a tolerance is invalid";
    case BRepCheck_CheckFail:
      return "cannot be checked";
    case BRepCheck_Multiple3DCurve:
    case BRepCheck_Invalid3DCurve:
      return "the curve of an edge is invalid";
    default:
      return "";
  }
}

class Finder {
 public:
  Finder(const Model& model, double size) : model_(model), shape_(model.shape()), size_(size) {}

  std::vector<Defect> find() {
    measureEdges();
    for (int face = 1; face <= shape_.faces.Extent(); ++face) {
      tryFor(face, 0, [&] { lookAtFace(face); });
      lookAtCrossings(face);
    }
    lookAtUses();
    tryFor(0, 0,
           [&] { std::ranges::copy(findOverlaps(model_, size_), std::back_inserter(defects_)); });
    tryFor(0, 0, [&] { checkValidity(); });
    std::ranges::stable_sort(defects_, [](const Defect& a, const Defect& b) {
      if (a.kind != b.kind) return a.kind < b.kind;
      return severity(a) > severity(b);
    });
    return std::move(defects_);
  }

 private:
  /// Large gaps are worse, small edges and slivers are.
  static double severity(const Defect& defect) {
    if (defect.kind == DefectKind::Gap || defect.kind == DefectKind::OpenLoop) return defect.extent;
    if (defect.kind == DefectKind::TinyEdge || defect.kind == DefectKind::Sliver)
      return -defect.extent;
    return 0;
  }

  template <class Look>
  void tryFor(int face, int edge, const Look& look) {
    try {
      look();
    } catch (const Standard_Failure& failure) {
      add({DefectKind::Invalid,
           face,
           edge,
           0,
           0,
           {},
           std::string("cannot be checked: ") + failure.DynamicType()->Name()});
    }
  }

  void add(Defect defect) { defects_.push_back(std::move(defect)); }

  void measureEdges() {
    lengths_.assign(static_cast<std::size_t>(shape_.edges.Extent()) + 1, 0);
    for (int id = 1; id <= shape_.edges.Extent(); ++id) tryFor(0, id, [&] { measureEdge(id); });
  }

  void measureEdge(int id) {
    const TopoDS_Edge edge = shape_.edge(id);
    if (BRep_Tool::Degenerated(edge)) return;
    double first, last;
    const bool hadNone = std::ranges::binary_search(shape_.edgesWithoutCurve, id);
    if (hadNone || BRep_Tool::Curve(edge, first, last).IsNull())
      add({DefectKind::NoCurve, 0, id, 0, 0, startOf(edge), hadNone ? "made from its face" : ""});
    if (BRep_Tool::Curve(edge, first, last).IsNull()) return;
    if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return;
    const BRepAdaptor_Curve curve(edge);
    double& length = lengths_[static_cast<std::size_t>(id)];
    length = GCPnts_AbscissaPoint::Length(curve);
    const Point3 middle = toPoint(curve.Value((first + last) / 2));
    if (length < kTinyShare * size_) add({DefectKind::TinyEdge, 0, id, 0, length, middle, ""});
    lookForGap(id, TopExp::FirstVertex(edge), toPoint(curve.Value(first)));
    lookForGap(id, TopExp::LastVertex(edge), toPoint(curve.Value(last)));
  }

  static Point3 startOf(const TopoDS_Edge& edge) {
    const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
    return vertex.IsNull() ? Point3{} : toPoint(BRep_Tool::Pnt(vertex));
  }

  void lookForGap(int id, const TopoDS_Vertex& vertex, const Point3& end) {
    if (vertex.IsNull()) return;
    const double gap = distance(end, toPoint(BRep_Tool::Pnt(vertex)));
    if (gap <= kGap * size_) return;
    const bool isWithin = gap <= BRep_Tool::Tolerance(vertex);
    add({DefectKind::Gap, 0, id, shape_.vertices.FindIndex(vertex), gap, end,
         isWithin ? "within the tolerance" : "beyond the tolerance"});
  }

  void lookAtFace(int id) {
    const TopoDS_Face face = shape_.face(id);
    TopLoc_Location location;
    const bool hasSurface = !BRep_Tool::Surface(face, location).IsNull();
    const bool hasEdge = TopExp_Explorer(face, TopAbs_EDGE).More();
    if (!hasSurface || !hasEdge)
      return add(
          {DefectKind::NoSurface, id, 0, 0, 0, {}, hasSurface ? "no boundary" : "no surface"});
    double around = 0;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const int edge = shape_.edges.FindIndex(it.Current());
      around += lengths_[static_cast<std::size_t>(edge)];
    }
    const Point3 place = startOf(TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current()));
    const double area = areaOf(shape_, id);
    if (area > 0 && around > 0 && 2 * area / around < kTinyShare * size_)
      add({DefectKind::Sliver, id, 0, 0, 2 * area / around, place, ""});
    std::vector<int> open;  // vertices
    for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next())
      lookAtLoop(id, TopoDS::Wire(it.Current()), face, open);
    for (const int vertex : open) addOpenLoop(id, vertex, open);
  }

  /// Above that, the model is damaged, and no gap is closed.
  double toleranceOf(int vertex) const {
    constexpr double kMax = 0.01;  // of the diagonal
    return std::min(BRep_Tool::Tolerance(shape_.vertex(vertex)), kMax * shape_.diagonal);
  }

  /// With the nearest of the places at which other loops of the face, or the same one, are open.
  void addOpenLoop(int face, int vertex, const std::vector<int>& open) {
    const gp_Pnt place = BRep_Tool::Pnt(shape_.vertex(vertex));
    Defect defect{DefectKind::OpenLoop, face, 0, vertex, 0, toPoint(place), ""};
    double least = std::numeric_limits<double>::infinity();
    for (const int other : open) {
      const double gap = place.Distance(BRep_Tool::Pnt(shape_.vertex(other)));
      if (other == vertex || !(gap < least)) continue;
      const double tolerance =
          BRep_Tool::Tolerance(shape_.vertex(vertex)) + BRep_Tool::Tolerance(shape_.vertex(other));
      least = defect.extent = gap;
      defect.detail = "the nearest other open end is at vertex " + std::to_string(other) +
                      (gap <= tolerance ? ", within the tolerance" : "");
    }
    add(std::move(defect));
  }

  /// Each vertex of a loop ends one edge and begins the next.
  void lookAtLoop(int face, const TopoDS_Wire& wire, const TopoDS_Face& surface,
                  std::vector<int>& open) {
    std::map<int, int> ends;  // by vertex
    bool hasSeam = false;
    for (TopExp_Explorer it(wire, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      hasSeam = hasSeam || BRep_Tool::IsClosed(edge, surface);
      for (const TopoDS_Vertex& v : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
        if (!v.IsNull()) ++ends[shape_.vertices.FindIndex(v)];
    }
    for (const auto& [vertex, count] : ends) {
      if (vertex == 0 || count == 2) continue;
      const Point3 place = toPoint(BRep_Tool::Pnt(shape_.vertex(vertex)));
      if (count % 2 == 1)
        open.push_back(vertex);
      else if (!hasSeam)
        add({DefectKind::TouchingLoop, face, 0, vertex, 0, place,
             "visits this vertex " + std::to_string(count / 2) + " times"});
    }
  }

  void lookAtCrossings(int face) {
    if (const auto crossed = crossedEdges(shape_, face))
      add({DefectKind::Invalid, face, crossed->one, 0, 0, crossed->place, wordsFor(*crossed)});
  }

  void lookAtUses() {
    for (const auto& [edge, uses] : sidesOfEdges(shape_)) {
      const Point3 place = startOf(shape_.edge(edge));
      const double length = lengths_[static_cast<std::size_t>(edge)];
      const int face = uses.front().face;
      if (uses.size() == 1) {
        add({DefectKind::FreeEdge, face, edge, 0, length, place, ""});
      } else if (uses.size() > 2) {
        add({DefectKind::NonManifoldEdge, face, edge, 0, length, place,
             std::to_string(uses.size()) + " times in faces"});
      } else if (uses[0].isForward == uses[1].isForward) {
        add({DefectKind::TurnedFaces, face, edge, 0, 0, place,
             "faces " + std::to_string(uses[0].face) + " and " + std::to_string(uses[1].face)});
      }
    }
  }

  void checkValidity() {
    const BRepCheck_Analyzer check(shape_.shape);
    if (check.IsValid()) return;
    for (int id = 1; id <= shape_.faces.Extent(); ++id) {
      const TopoDS_Face face = shape_.face(id);
      std::set<std::string> faults;
      collect(check, face, TopoDS_Shape(), faults);
      for (const TopAbs_ShapeEnum type : {TopAbs_WIRE, TopAbs_EDGE, TopAbs_VERTEX})
        for (TopExp_Explorer it(face, type); it.More(); it.Next()) {
          collect(check, it.Current(), face, faults);
          if (type == TopAbs_EDGE) collect(check, it.Current(), TopoDS_Shape(), faults);
        }
      const TopExp_Explorer edge(face, TopAbs_EDGE);
      const Point3 place = edge.More() ? startOf(TopoDS::Edge(edge.Current())) : Point3{};
      for (const std::string& words : faults) add({DefectKind::Invalid, id, 0, 0, 0, place, words});
    }
  }

  /// What a check found of a part, by itself or, if `around` is given, as a part of that.
  static void collect(const BRepCheck_Analyzer& check, const TopoDS_Shape& part,
                      const TopoDS_Shape& around, std::set<std::string>& faults) {
    const Handle(BRepCheck_Result)& result = check.Result(part);
    if (result.IsNull()) return;
    const auto take = [&](const BRepCheck_ListOfStatus& all) {
      for (const BRepCheck_Status status : all)
        if (const std::string words = wordsFor(status); !words.empty()) faults.insert(words);
    };
    if (around.IsNull()) return take(result->Status());
    for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext())
      if (result->ContextualShape().IsSame(around)) take(result->StatusOnShape());
  }

  const Model& model_;
  const ModelShape& shape_;
  double size_;
  std::vector<double> lengths_;  ///< by edge
  std::vector<Defect> defects_;
};

}  // namespace

std::vector<Defect> findDefects(const Model& model, double size) {
  return Finder(model, size).find();
}

std::vector<Point3> pointsAlong(const Model& model, int edge) {
  std::vector<Point3> points;
  const TopoDS_Edge shape = model.shape().edge(edge);
  double first, last;
  if (BRep_Tool::Degenerated(shape) || BRep_Tool::Curve(shape, first, last).IsNull()) return points;
  if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return points;
  try {
    const BRepAdaptor_Curve curve(shape);
    const GCPnts_QuasiUniformDeflection sampled(curve, 2e-4 * model.diagonal());
    if (!sampled.IsDone()) return points;
    for (int i = 1; i <= sampled.NbPoints(); ++i) points.push_back(toPoint(sampled.Value(i)));
  } catch (const Standard_Failure&) {
    points.clear();  // what cannot be evaluated cannot be drawn
  }
  return points;
}

std::vector<int> edgesAround(const Model& model, int face) {
  std::set<int> edges;
  for (TopExp_Explorer it(model.shape().face(face), TopAbs_EDGE); it.More(); it.Next())
    edges.insert(model.shape().edges.FindIndex(it.Current()));
  return {edges.begin(), edges.end()};
}

}  // namespace af2::geometry
