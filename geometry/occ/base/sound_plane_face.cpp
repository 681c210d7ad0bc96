#include "geometry/occ/base/sound_plane_face.h"

#include <BRep_CurveRepresentation.hxx>
#include <BRep_GCurve.hxx>
#include <BRep_ListIteratorOfListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <numbers>
#include <unordered_set>
#include <vector>

#include "engine/base/elementary.h"
#include "engine/base/point.h"

namespace af2::geometry {
namespace {

// All limits are on the safe side of those of the repair: a face beyond them is repaired as usual.
constexpr double kLeastLength = 1e-5;  // of an edge, mm
constexpr double kLeastGap = 1e-5;     // between edges that do not meet, mm
constexpr double kMaxCosine = 0.95;    // of the angle between edges that meet: 18 degrees
constexpr double kPieceAngle = std::numbers::pi / 12;

/// A line, or the chord of a part of a circle.
struct Piece {
  Point2 from, to;
  double bulge;  ///< greatest distance from the chord
  int edge;
};

double distanceToSegment(Point2 p, Point2 a, Point2 b) {
  const Point2 d = b - a;
  return distance(p, a + std::clamp(dot(p - a, d) / dot(d, d), 0., 1.) * d);
}

bool doCross(const Piece& a, const Piece& b) {
  const auto isLeft = [](const Piece& of, Point2 p) {
    return cross(of.to - of.from, p - of.from) > 0;
  };
  return isLeft(a, b.from) != isLeft(a, b.to) && isLeft(b, a.from) != isLeft(b, a.to);
}

bool areApart(const Piece& a, const Piece& b) {
  const double gap =
      std::min({distanceToSegment(a.from, b.from, b.to), distanceToSegment(a.to, b.from, b.to),
                distanceToSegment(b.from, a.from, a.to), distanceToSegment(b.to, a.from, a.to)});
  return gap > a.bulge + b.bulge + kLeastGap && !doCross(a, b);
}

/// Whether two pieces that follow each other meet nowhere else.
bool doOpen(const Piece& a, const Piece& b) {
  const Point2 back = a.from - a.to, on = b.to - b.from;
  return dot(back, on) < kMaxCosine * length(back) * length(on);
}

/// The curve in space of an edge without a curve in the parameters of the surface.
Handle(Geom_Curve) spaceCurve(const BRep_TEdge& edge, const Handle(Geom_Surface) & surface,
                              double& first, double& last) {
  Handle(Geom_Curve) curve;
  for (BRep_ListIteratorOfListOfCurveRepresentation it(edge.Curves()); it.More(); it.Next()) {
    const Handle(BRep_CurveRepresentation)& part = it.Value();
    if (part->IsCurveOnSurface(surface, TopLoc_Location())) return {};
    if (!part->IsCurve3D()) continue;
    if (!curve.IsNull() || !part->Location().IsIdentity()) return {};
    curve = part->Curve3D();
    Handle(BRep_GCurve)::DownCast(part)->Range(first, last);
  }
  return curve;
}

class PlaneFace {
 public:
  explicit PlaneFace(const Handle(Geom_Plane) & plane)
      : plane_(plane), axes_(plane->Pln().Position()) {}

  /// Returns whether the wire is one of edges that can be understood, and closed.
  bool add(const TopoDS_Wire& wire);
  bool isSound() const { return areEdgesApart() && areWiresOriented(); }

 private:
  struct Wire {
    std::size_t first, end;  ///< pieces
    Point2 min, max;
  };

  Point2 inPlane(const gp_Pnt& p) const {
    const gp_Vec v(axes_.Location(), p);
    return {v.Dot(axes_.XDirection()), v.Dot(axes_.YDirection())};
  }
  double offPlane(const gp_Pnt& p) const {
    return std::abs(gp_Vec(axes_.Location(), p).Dot(axes_.Direction()));
  }
  bool add(const TopoDS_Edge& edge, TopoDS_Vertex& from, TopoDS_Vertex& to);
  bool isNear(const gp_Pnt& end, const TopoDS_Vertex& vertex) const;
  void addPieces(const Geom_Curve& curve, double first, double last, int count, double bulge);
  /// The pieces from the first one on run the other way.
  void turnAround(std::size_t first);
  bool areEdgesApart() const;
  bool areWiresOriented() const;
  double areaOf(const Wire& wire) const;
  bool isInside(Point2 p, const Wire& wire) const;
  /// The piece after one of the wire.
  std::size_t after(std::size_t piece, const Wire& wire) const {
    return piece + 1 == wire.end ? wire.first : piece + 1;
  }

  const Handle(Geom_Plane) plane_;
  const gp_Ax3 axes_;
  std::vector<Piece> pieces_;
  std::vector<Wire> wires_;
  std::unordered_set<const TopoDS_TShape*> starts_;
  int edges_ = 0;
};

bool PlaneFace::add(const TopoDS_Wire& wire) {
  const bool isForward = wire.Orientation() == TopAbs_FORWARD;
  if (!isForward && wire.Orientation() != TopAbs_REVERSED) return false;
  if (!wire.Location().IsIdentity()) return false;
  Wire added{pieces_.size(), 0, {}, {}};
  TopoDS_Vertex first, last;
  for (TopoDS_Iterator it(wire, false); it.More(); it.Next()) {
    TopoDS_Vertex from, to;
    if (!add(TopoDS::Edge(it.Value()), from, to)) return false;
    if (!starts_.insert(from.TShape().get()).second) return false;  // it touches itself or another
    if (first.IsNull()) first = from;
    if (!last.IsNull() && !from.IsSame(last)) return false;
    last = to;
  }
  if (first.IsNull() || !first.IsSame(last)) return false;
  added.end = pieces_.size();
  const auto begin = pieces_.begin() + static_cast<std::ptrdiff_t>(added.first);
  added.min = added.max = begin->from;
  for (auto piece = begin; piece != pieces_.end(); ++piece) {
    added.min = {std::min(added.min.x, piece->from.x), std::min(added.min.y, piece->from.y)};
    added.max = {std::max(added.max.x, piece->from.x), std::max(added.max.y, piece->from.y)};
  }
  if (!isForward) turnAround(added.first);
  wires_.push_back(added);
  return true;
}

bool PlaneFace::add(const TopoDS_Edge& edge, TopoDS_Vertex& from, TopoDS_Vertex& to) {
  const bool isForward = edge.Orientation() == TopAbs_FORWARD;
  if (!isForward && edge.Orientation() != TopAbs_REVERSED) return false;
  const Handle(BRep_TEdge) data = Handle(BRep_TEdge)::DownCast(edge.TShape());
  if (!edge.Location().IsIdentity() || data->Degenerated()) return false;
  if (!data->SameParameter() || !data->SameRange()) return false;
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = spaceCurve(*data, plane_, first, last);
  if (curve.IsNull()) return false;
  for (TopoDS_Iterator it(edge, false); it.More(); it.Next()) {
    const auto& vertex = TopoDS::Vertex(it.Value());
    const bool isFirst = vertex.Orientation() == TopAbs_FORWARD;
    if (!isFirst && vertex.Orientation() != TopAbs_REVERSED) return false;
    TopoDS_Vertex& end = isFirst == isForward ? from : to;
    if (!end.IsNull() || !isNear(curve->Value(isFirst ? first : last), vertex)) return false;
    end = vertex;
  }
  if (from.IsNull() || to.IsNull()) return false;
  const double tolerance = data->Tolerance() / 2;
  if (offPlane(curve->Value(first)) > tolerance || offPlane(curve->Value(last)) > tolerance)
    return false;
  const std::size_t begin = pieces_.size();
  if (curve->DynamicType() == STANDARD_TYPE(Geom_Line)) {
    if (!(last - first > kLeastLength)) return false;
    addPieces(*curve, first, last, 1, 0);
  } else if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull()) {
    const gp_Circ& round = circle->Circ();
    const double angle = last - first, radius = round.Radius();
    // A circle that leans leaves the plane by its radius times no more than the double of this.
    const gp_Vec x(round.XAxis().Direction()), y(round.YAxis().Direction());
    const double lean =
        std::max(std::abs(x.Dot(axes_.Direction())), std::abs(y.Dot(axes_.Direction())));
    if (offPlane(round.Location()) + 2 * radius * lean > tolerance) return false;
    if (!(angle * radius > kLeastLength && angle < 2 * std::numbers::pi + 1e-9)) return false;
    const int count = std::max(static_cast<int>(std::ceil(angle / kPieceAngle)), 1);
    addPieces(*curve, first, last, count, radius * (1 - cosine(angle / count / 2)));
  } else {
    return false;
  }
  ++edges_;
  if (!isForward) turnAround(begin);
  return true;
}

void PlaneFace::turnAround(std::size_t first) {
  const auto begin = pieces_.begin() + static_cast<std::ptrdiff_t>(first);
  std::reverse(begin, pieces_.end());
  for (auto piece = begin; piece != pieces_.end(); ++piece) std::swap(piece->from, piece->to);
}

bool PlaneFace::isNear(const gp_Pnt& end, const TopoDS_Vertex& vertex) const {
  if (!vertex.Location().IsIdentity()) return false;
  const double distance = end.Distance(BRep_Tool::Pnt(vertex)) + offPlane(end);
  return distance <= BRep_Tool::Tolerance(vertex);
}

void PlaneFace::addPieces(const Geom_Curve& curve, double first, double last, int count,
                          double bulge) {
  Point2 from = inPlane(curve.Value(first));
  for (int i = 1; i <= count; ++i) {
    const Point2 to = inPlane(curve.Value(first + (last - first) * i / count));
    pieces_.push_back({from, to, bulge, edges_});
    from = to;
  }
}

bool PlaneFace::areEdgesApart() const {
  struct Range {
    double min, max;
    std::size_t piece, next;
  };
  std::vector<Range> ranges;
  ranges.reserve(pieces_.size());
  for (const Wire& wire : wires_) {
    for (std::size_t i = wire.first; i < wire.end; ++i) {
      const Piece& piece = pieces_[i];
      const double width = piece.bulge + kLeastGap;
      ranges.push_back({std::min(piece.from.x, piece.to.x) - width,
                        std::max(piece.from.x, piece.to.x) + width, i, after(i, wire)});
    }
  }
  std::ranges::sort(ranges, {}, &Range::min);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Piece& a = pieces_[ranges[i].piece];
    for (std::size_t j = i + 1; j < ranges.size() && ranges[j].min <= ranges[i].max; ++j) {
      const Piece& b = pieces_[ranges[j].piece];
      if (a.edge == b.edge) continue;
      const bool isNext = ranges[i].next == ranges[j].piece;
      const bool isPrevious = ranges[j].next == ranges[i].piece;
      if (isNext && !doOpen(a, b)) return false;
      if (isPrevious && !doOpen(b, a)) return false;
      if (!isNext && !isPrevious && !areApart(a, b)) return false;
    }
  }
  return true;
}

double PlaneFace::areaOf(const Wire& wire) const {
  double twice = 0;
  for (std::size_t i = wire.first; i < wire.end; ++i)
    twice += cross(pieces_[i].from - wire.min, pieces_[i].to - wire.min);
  return twice / 2;
}

bool PlaneFace::isInside(Point2 p, const Wire& wire) const {
  if (p.x < wire.min.x || p.x > wire.max.x || p.y < wire.min.y || p.y > wire.max.y) return false;
  bool isIn = false;
  for (std::size_t i = wire.first; i < wire.end; ++i) {
    const Point2 a = pieces_[i].from, b = pieces_[i].to;
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if ((cross(b - a, p - a) > 0) == (b.y > a.y)) isIn = !isIn;
  }
  return isIn;
}

bool PlaneFace::areWiresOriented() const {
  const Wire* outer = nullptr;
  for (const Wire& wire : wires_) {
    if (areaOf(wire) < 0) continue;
    if (outer) return false;
    outer = &wire;
  }
  if (!outer) return false;
  for (const Wire& hole : wires_)
    for (const Wire& other : wires_)
      if (&hole != outer && &hole != &other)
        if (isInside(pieces_[hole.first].from, other) != (&other == outer)) return false;
  return true;
}

}  // namespace

bool isSoundPlaneFace(const TopoDS_Face& face) {
  TopLoc_Location place;
  const auto plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face, place));
  if (plane.IsNull() || !place.IsIdentity() || !face.Location().IsIdentity()) return false;
  if (!plane->Pln().Direct()) return false;
  PlaneFace found(plane);
  for (TopoDS_Iterator it(face, false); it.More(); it.Next())
    if (it.Value().ShapeType() != TopAbs_WIRE || !found.add(TopoDS::Wire(it.Value()))) return false;
  return found.isSound();
}

}  // namespace af2::geometry
