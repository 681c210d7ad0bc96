#include "geometry/occ/merge/edge_joints.h"

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/base/parallel.h"
#include "geometry/occ/edges/edge_on_face.h"
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

/// The outward normals of a face along one of its edges.
class NormalsAlong {
 public:
  NormalsAlong(const ModelShape& model, const FaceSide& side)
      : side_(side),
        forward_(TopoDS::Face(model.face(side.face).Oriented(TopAbs_FORWARD))),
        surface_(model.surface(side.face)) {}

  /// 0 if it is not known.
  Point3 at(double parameter) const {
    const Point3 normal = unit(normalOnEdge(surface_, forward_, side_.edge, parameter));
    return side_.isTurned ? -1 * normal : normal;
  }

 private:
  const FaceSide& side_;
  TopoDS_Face forward_;
  FaceSurface surface_;
};

double largestAngle(const ModelShape& model, const TopoDS_Edge& edge, const FaceSide& one,
                    const FaceSide& other) {
  constexpr int kSamples = 24;
  double first, last;
  BRep_Tool::Range(edge, first, last);
  const NormalsAlong here(model, one), there(model, other);
  double largest = -1;
  for (int i = 0; i <= kSamples; ++i) {
    // Ends may be poles, where normals are noise.
    const double share = std::clamp(i / (kSamples + 0.0), 1e-3, 1 - 1e-3);
    const double parameter = first + share * (last - first);
    const Point3 a = here.at(parameter), b = there.at(parameter);
    if (a == Point3{} || b == Point3{}) continue;
    largest = std::max(largest, std::atan2(length(cross(a, b)), dot(a, b)));
  }
  return largest < 0 ? std::numeric_limits<double>::infinity() : largest;
}

EdgeJoint jointOf(const ModelShape& model, int id, const std::vector<FaceSide>& sides) {
  const TopoDS_Edge edge = model.edge(id);
  if (sides.size() != 2 || BRep_Tool::Degenerated(edge)) return {};
  if (sides[0].isForward() == sides[1].isForward()) return {};
  EdgeJoint joint{sides[0].face, sides[1].face};
  try {
    joint.angle = largestAngle(model, edge, sides[0], sides[1]);
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
