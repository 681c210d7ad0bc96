#include "geometry/occ/faces/crossed_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/base/plane_axes.h"
#include "geometry/check/boundary_crossings.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

/// A chord of an edge, in the direction of the edge.
struct Chord {
  int edge = 0;
  double from = 0, to = 0;
};

class CrossingSearch {
 public:
  CrossingSearch(const ModelShape& model, int face)
      : model_(model), axes_({}, model.surface(face).at(0, 0).normal) {
    for (TopExp_Explorer wire(model.face(face), TopAbs_WIRE); wire.More(); wire.Next()) {
      input_.loops.emplace_back();
      chords_.emplace_back();
      for (BRepTools_WireExplorer it(TopoDS::Wire(wire.Current())); it.More(); it.Next())
        add(it.Current());
      if (!input_.loops.back().empty()) continue;
      input_.loops.pop_back();
      chords_.pop_back();
    }
  }

  std::optional<CrossedEdges> find() const {
    constexpr std::size_t kTried = 20;
    for (const auto& [one, other] : crossingsOf(input_, axes_, kTried))
      if (const auto found =
              confirmed(chords_[one.loop][one.corner], chords_[other.loop][other.corner]))
        return found;
    return std::nullopt;
  }

 private:
  /// How many chords follow a curve well enough to show where it crosses others.
  static int chordsOf(const BRepAdaptor_Curve& curve) {
    constexpr int kOfSpan = 16, kOfOthers = 64, kMost = 4000;
    if (curve.GetType() == GeomAbs_Line) return 1;
    if (curve.GetType() != GeomAbs_BSplineCurve) return kOfOthers;
    return std::min(kMost, kOfSpan * (curve.NbKnots() - 1));
  }

  void add(const TopoDS_Edge& edge) {
    if (BRep_Tool::Degenerated(edge)) return;
    const BRepAdaptor_Curve curve(edge);
    const int count = chordsOf(curve);
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    const bool isReversed = edge.Orientation() == TopAbs_REVERSED;
    const auto at = [&](int i) {
      return first + (last - first) * (isReversed ? count - i : i) / count;
    };
    const int id = model_.edges.FindIndex(edge);
    for (int i = 0; i < count; ++i) {
      input_.loops.back().push_back(
          {VertexId(input_.vertexCount++), {toPoint(curve.Value(at(i))), {}, 0, 0}});
      chords_.back().push_back({id, at(i), at(i + 1)});
    }
  }

  /// Where a curve is in the plane, and its direction there.
  struct PlaceOnCurve {
    Point2 place, along;
  };
  PlaceOnCurve inPlane(const BRepAdaptor_Curve& curve, double t) const {
    gp_Pnt place;
    gp_Vec along;
    curve.D1(t, place, along);
    return {axes_(toPoint(place)), axes_(toPoint(along))};
  }

  std::optional<CrossedEdges> confirmed(const Chord& one, const Chord& other) const {
    constexpr int kMostSteps = 30;
    constexpr double kExact = 1e-9, kLeastSine = 1e-3;
    const BRepAdaptor_Curve a(model_.edge(one.edge)), b(model_.edge(other.edge));
    double t = (one.from + one.to) / 2, s = (other.from + other.to) / 2;
    const double atStart = std::abs(t - s);
    for (int step = 0; step < kMostSteps; ++step) {
      const PlaceOnCurve at = inPlane(a, t), its = inPlane(b, s);
      const double determinant = cross(at.along, its.along);
      if (std::abs(determinant) <= kLeastSine * length(at.along) * length(its.along))
        return std::nullopt;
      const Point2 gap = its.place - at.place;
      if (length(gap) <= kExact * model_.diagonal) {
        const Point3 place = toPoint(a.Value(t));
        const bool isOnePlace = one.edge == other.edge && std::abs(t - s) < atStart / 2;
        if (isOnePlace || !isInside(a, t, place) || !isInside(b, s, place)) return std::nullopt;
        return CrossedEdges{std::min(one.edge, other.edge), std::max(one.edge, other.edge), place};
      }
      t += cross(gap, its.along) / determinant;
      s += cross(gap, at.along) / determinant;
    }
    return std::nullopt;
  }

  /// Whether a place on an edge is between its ends, and not at one of them.
  static bool isInside(const BRepAdaptor_Curve& curve, double t, const Point3& place) {
    constexpr double kBeside = 2;  // tolerances
    if (!(t > curve.FirstParameter() && t < curve.LastParameter())) return false;
    const TopoDS_Edge& edge = curve.Edge();
    for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
      if (end.IsNull()) continue;
      const double tolerance = std::max(BRep_Tool::Tolerance(end), BRep_Tool::Tolerance(edge));
      if (distance(place, toPoint(BRep_Tool::Pnt(end))) <= kBeside * tolerance) return false;
    }
    return true;
  }

  const ModelShape& model_;
  PlaneAxes axes_;
  FrontInput input_;
  std::vector<std::vector<Chord>> chords_;  ///< by loop and corner
};

}  // namespace

std::optional<CrossedEdges> crossedEdges(const ModelShape& model, int face) {
  try {
    if (BRep_Tool::Surface(model.face(face)).IsNull() || !model.surface(face).isPlane())
      return std::nullopt;
    return CrossingSearch(model, face).find();
  } catch (const GeometryError&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
  return std::nullopt;
}

std::string wordsFor(const CrossedEdges& edges) {
  const bool isSame = edges.one == edges.other;
  return "edge " + std::to_string(edges.one) + " crosses " +
         (isSame ? "itself" : "edge " + std::to_string(edges.other));
}

std::string textOf(const CrossedEdges& edges) {
  return "in the model itself " + wordsFor(edges) + " at " + textOf(edges.place) +
         ": draw its boundary anew";
}

}  // namespace af2::geometry
