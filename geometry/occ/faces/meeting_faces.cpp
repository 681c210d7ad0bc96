#include "geometry/occ/faces/meeting_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include "engine/base/place_text.h"
#include "geometry/mesh/blame_model.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {
namespace {

/// One of two faces, and the point of its surface that is nearest to the other one.
class MeetingFace {
 public:
  explicit MeetingFace(const TopoDS_Face& face)
      : face_(face), surface_(new ShapeAnalysis_Surface(BRep_Tool::Surface(face))) {}

  gp_Pnt drop(const gp_Pnt& point) {
    const double precision = BRep_Tool::Tolerance(face_);
    uv_ = isBegun_ ? surface_->NextValueOfUV(uv_, point, precision)
                   : surface_->ValueOfUV(point, precision);
    isBegun_ = true;
    return surface_->Value(uv_);
  }

  bool isOnFace() const {
    return BRepTopAdaptor_FClass2d(face_, BRep_Tool::Tolerance(face_)).Perform(uv_) != TopAbs_OUT;
  }

  bool isAway(const gp_Pnt& point, double away) const {
    const TopoDS_Vertex vertex = BRepBuilderAPI_MakeVertex(point);
    for (TopExp_Explorer it(face_, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      const BRepExtrema_DistShapeShape distance(vertex, edge);
      const double most = std::max(away, 2 * BRep_Tool::Tolerance(edge));
      if (!distance.IsDone() || distance.Value() <= most) return false;
    }
    return true;
  }

  std::optional<gp_Dir> normal() const {
    GeomLProp_SLProps properties(surface_->Surface(), uv_.X(), uv_.Y(), 1, 1e-9);
    if (!properties.IsNormalDefined()) return std::nullopt;
    return properties.Normal();
  }

 private:
  TopoDS_Face face_;
  Handle(ShapeAnalysis_Surface) surface_;
  gp_Pnt2d uv_;
  bool isBegun_ = false;
};

/// Projects alternately to one surface and the other, which converges to a common point, if there
/// is one.
std::optional<gp_Pnt> meet(MeetingFace& one, MeetingFace& other, gp_Pnt point, double tolerance) {
  constexpr int kMaxSteps = 60;
  for (int step = 0; step < kMaxSteps; ++step) {
    const gp_Pnt above = one.drop(point);
    point = other.drop(above);
    if (above.Distance(point) <= tolerance) return point;
  }
  return std::nullopt;
}

bool isParallel(const MeetingFace& one, const MeetingFace& other) {
  constexpr double kSame = 1e-3;  // radians
  const std::optional<gp_Dir> a = one.normal(), b = other.normal();
  return a && b && a->IsParallel(*b, kSame);
}

/// The direction from the middle of an edge into a face, at right angles to the edge.
std::optional<gp_Dir> wayInto(MeetingFace& face, const EdgeUse& use) {
  const BRepAdaptor_Curve curve(use.edge);
  gp_Pnt place;
  gp_Vec along;
  curve.D1((curve.FirstParameter() + curve.LastParameter()) / 2, place, along);
  if (use.edge.Orientation() == TopAbs_REVERSED) along.Reverse();
  face.drop(place);
  const std::optional<gp_Dir> normal = face.normal();
  if (!normal) return std::nullopt;
  const gp_Vec way = gp_Vec(*normal).Crossed(along);
  return way.Magnitude() > 0 ? std::optional(gp_Dir(way)) : std::nullopt;
}

/// Words for an edge at which a face is so near to another one that their elements cannot be told
/// from such that overlap; empty if there is none.
std::string narrowAngleOf(const ModelShape& model, int face) {
  constexpr double kNarrow = 0.005;  // radians
  const auto hasSurface = [&](int id) { return !BRep_Tool::Surface(model.face(id)).IsNull(); };
  if (!hasSurface(face)) return "";
  try {
    for (const EdgeUse& use : model.edgesOfFaces[static_cast<std::size_t>(face) - 1]) {
      if (BRep_Tool::Degenerated(use.edge)) continue;
      MeetingFace own(model.face(face));
      const std::optional<gp_Dir> way = wayInto(own, use);
      for (const int other : model.facesOfEdges[static_cast<std::size_t>(use.id) - 1]) {
        if (!way || other == face || !hasSurface(other)) continue;
        MeetingFace another(model.face(other));
        for (const EdgeUse& its : model.edgesOfFaces[static_cast<std::size_t>(other) - 1]) {
          if (its.id != use.id) continue;
          const std::optional<gp_Dir> itsWay = wayInto(another, its);
          if (!itsWay || way->Angle(*itsWay) >= kNarrow) continue;
          return "in the model itself it encloses an angle of " +
                 af2::textOf(way->Angle(*itsWay) * 180 / std::numbers::pi, 2) +
                 " degrees with face " + std::to_string(other) + " at edge " +
                 std::to_string(use.id) + ": fill this gap, or make it wider";
        }
      }
    }
  } catch (const Standard_Failure&) {
  }
  return "";
}

using PlacesAtFace = std::pair<int, std::vector<Point3>>;

/// The places at which the elements of a face cross those of each other face, most first.
std::vector<PlacesAtFace> placesByFace(const std::vector<Crossing>& crossings, int face) {
  std::map<int, std::vector<Point3>> places;
  for (const Crossing& crossing : crossings) {
    if (crossing.faces[0] == crossing.faces[1]) continue;
    if (crossing.faces[0] == face) places[crossing.faces[1]].push_back(crossing.place);
    if (crossing.faces[1] == face) places[crossing.faces[0]].push_back(crossing.place);
  }
  std::vector<PlacesAtFace> sorted(places.begin(), places.end());
  std::ranges::stable_sort(sorted, std::greater<>(),
                           [](const PlacesAtFace& at) { return at.second.size(); });
  return sorted;
}

/// Words for a common point of a face and another one; empty if there is none.
std::string commonPointOf(const ModelShape& model, int face, const std::vector<Crossing>& crossings,
                          double away) {
  constexpr std::size_t kMaxFaces = 20, kPlaces = 4;
  std::size_t faces = 0;
  for (const auto& [other, places] : placesByFace(crossings, face)) {
    if (++faces > kMaxFaces) break;
    for (std::size_t k = 0; k < kPlaces; ++k) {
      const Point3& nearby = places[(2 * k + 1) * places.size() / (2 * kPlaces)];
      const auto found = commonPoint(model, face, other, nearby, away);
      if (!found) continue;
      return std::string("in the model itself it ") + (found->isTouching ? "lies on" : "meets") +
             " face " + std::to_string(other) + " at " + textOf(found->place) +
             ", where they have no edge in common: " +
             (found->isTouching ? "subtract one of them from the other"
                                : "cut both along the line where they meet");
    }
  }
  return "";
}

}  // namespace

std::optional<CommonPoint> commonPoint(const ModelShape& model, int one, int other,
                                       const Point3& nearby, double away) {
  constexpr double kShare = 1e-2;  // of the distance from the edges
  try {
    MeetingFace first(model.face(one)), second(model.face(other));
    const std::optional<gp_Pnt> point = meet(first, second, toOcc(nearby), kShare * away);
    if (!point || !first.isOnFace() || !second.isOnFace()) return std::nullopt;
    if (!first.isAway(*point, away) && !second.isAway(*point, away)) return std::nullopt;
    return CommonPoint{toPoint(*point), isParallel(first, second)};
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

std::string meetingOf(const ModelShape& model, int face, const std::vector<Crossing>& crossings,
                      double size) {
  constexpr double kAway = 0.02;  // of the size
  const std::string meeting = narrowAngleOf(model, face);
  return meeting.empty() ? commonPointOf(model, face, crossings, kAway * size) : meeting;
}

void tellOfMeetingFaces(const ModelShape& model, const std::vector<Crossing>& crossings,
                        double size, std::vector<FaceReport>& faces) {
  constexpr int kMaxReported = 20;  // where many cross, the first ones are enough
  int reported = 0;
  for (FaceReport& face : faces) {
    if (face.status != FaceStatus::Failed || reported == kMaxReported) continue;
    const std::string meeting = meetingOf(model, face.id, crossings, size);
    if (meeting.empty()) continue;
    blameModel(meeting, face);
    ++reported;
  }
}

}  // namespace af2::geometry
