#include "geometry/occ/merge/edge_joints.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "engine/base/elementary.h"
#include "engine/base/parallel.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

namespace {

/// An edge as a face uses it.
struct FaceSide {
  int face = 0;
  TopoDS_Edge edge;         // oriented as in the face taken forward
  bool isTurned = false;    // the face is reversed
  bool isForward() const {  // seen from outside
    return (edge.Orientation() == TopAbs_FORWARD) != isTurned;
  }
};

std::vector<std::vector<FaceSide>> sidesByEdge(const ModelShape& model) {
  std::vector<std::vector<FaceSide>> sides(static_cast<std::size_t>(model.edges.Extent()));
  for (int face = 1; face <= model.faces.Extent(); ++face) {
    const bool isTurned = model.face(face).Orientation() == TopAbs_REVERSED;
    for (const EdgeUse& use : model.edgesOfFaces[static_cast<std::size_t>(face) - 1])
      sides[static_cast<std::size_t>(use.id) - 1].push_back({face, use.edge, isTurned});
  }
  return sides;
}

/// A face beside one of its edges.
struct Beside {
  Point3 normal;      ///< outward; 0 if it is not known
  double across = 0;  ///< curvature across the edge, > 0 where the face bends away from the normal
  double along = 0;   ///< the same along the edge
};

class FaceAlongEdge {
 public:
  FaceAlongEdge(const ModelShape& model, const FaceSide& side)
      : side_(side), surface_(model.surface(side.face)) {
    double first, last;
    if (!surface_.isPlane())
      curve_ = BRep_Tool::CurveOnSurface(
          side.edge, TopoDS::Face(model.face(side.face).Oriented(TopAbs_FORWARD)), first, last);
  }

  /// along  direction of the edge
  Beside at(double parameter, const Point3& along) const {
    if (!surface_.isPlane() && curve_.IsNull()) return {};
    const gp_Pnt2d uv = curve_.IsNull() ? gp_Pnt2d(0, 0) : curve_->Value(parameter);
    const SurfaceJet s = surface_.inOccParameters().jetAt(uv.X(), uv.Y());
    const Point3 normal = unit(cross(s.du, s.dv));
    const double sign = side_.isTurned ? -1 : 1;
    if (surface_.isPlane()) return {sign * normal};
    return {sign * normal, sign * curvatureIn(s, normal, unit(cross(normal, along))),
            sign * curvatureIn(s, normal, unit(along))};
  }

 private:
  static double curvatureIn(const SurfaceJet& s, const Point3& normal, const Point3& way) {
    const double e = dot(s.du, s.du), f = dot(s.du, s.dv), g = dot(s.dv, s.dv);
    const double det = e * g - f * f;
    if (!(det > 1e-12 * e * g)) return 0;
    const double x = dot(way, s.du), y = dot(way, s.dv);
    const double a = (g * x - f * y) / det, b = (e * y - f * x) / det;
    return -(a * a * dot(s.duu, normal) + 2 * a * b * dot(s.duv, normal) +
             b * b * dot(s.dvv, normal));
  }

  const FaceSide& side_;
  FaceSurface surface_;
  Handle(Geom2d_Curve) curve_;
};

void compare(const ModelShape& model, const TopoDS_Edge& edge, const FaceSide& one,
             const FaceSide& other, EdgeJoint& joint) {
  constexpr int kSamples = 24;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  const FaceAlongEdge here(model, one), there(model, other);
  double largest = -1;
  for (int i = 0; i <= kSamples; ++i) {
    // Ends may be poles, where normals are noise.
    const double share = std::clamp(i / (kSamples + 0.0), 1e-3, 1 - 1e-3);
    const double parameter = first + share * (last - first);
    gp_Pnt place;
    gp_Vec along;
    curve.D1(parameter, place, along);
    const Beside a = here.at(parameter, toPoint(along)), b = there.at(parameter, toPoint(along));
    if (a.normal == Point3{} || b.normal == Point3{}) continue;
    if (i == kSamples / 2) {
      joint.normalOfOne = a.normal;
      joint.normalOfOther = b.normal;
    }
    largest = std::max(largest, angleBetween(a.normal, b.normal));
    const double bend = std::abs(a.across - b.across);
    // A tube is as tight along the edges around it.
    if (2 * std::min(std::abs(a.along), std::abs(b.along)) < bend)
      joint.bend = std::max(joint.bend, bend);
  }
  if (largest >= 0) joint.angle = largest;
}

EdgeJoint jointOf(const ModelShape& model, int id, const std::vector<FaceSide>& sides) {
  const TopoDS_Edge edge = model.edge(id);
  if (sides.size() != 2 || BRep_Tool::Degenerated(edge)) return {};
  if (sides[0].isForward() == sides[1].isForward()) return {};
  EdgeJoint joint{sides[0].face, sides[1].face};
  try {
    compare(model, edge, sides[0], sides[1], joint);
  } catch (const std::exception&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
  return joint;
}

}  // namespace

std::vector<EdgeJoint> jointsOf(const ModelShape& model, int threads) {
  const std::vector<std::vector<FaceSide>> sides = sidesByEdge(model);
  std::vector<EdgeJoint> joints(sides.size());
  forEachInParallel(sides.size(), threads, [&](std::size_t i) {
    joints[i] = jointOf(model, static_cast<int>(i) + 1, sides[i]);
  });
  return joints;
}

}  // namespace af2::geometry
