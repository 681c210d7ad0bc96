#include "geometry/occ/model/points_on_model.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/place_text.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {
namespace {

void requireFace(const Model& model, int face) {
  if (face < 1 || face > model.faceCount())
    throw InputError("there is no face " + std::to_string(face) + "; the model has faces 1 to " +
                     std::to_string(model.faceCount()));
}

/// Searches on one face, for one thread.
class FaceFeet {
 public:
  FaceFeet(const ModelShape& model, int id)
      : id_(id),
        face_(model.face(id)),
        surface_(model.surface(id)),
        finder_(BRep_Tool::Surface(face_)),
        inside_(face_, Precision::PConfusion()) {}

  PointOnModel nearest(const Point3& p) {
    const gp_Pnt place = toOcc(p);
    const gp_Pnt2d uv = finder_.ValueOfUV(place, Precision::Confusion());
    if (inside_.Perform(uv) != TopAbs_OUT) return found(p, uv);
    // The foot is beyond the edges: the nearest point is on an edge, or another foot.
    const BRepExtrema_DistShapeShape search(BRepBuilderAPI_MakeVertex(place).Vertex(), face_);
    if (!search.IsDone() || search.NbSolution() == 0) return {};
    const gp_Pnt nearest = search.PointOnShape2(1);
    PointOnModel result = found(p, finder_.ValueOfUV(nearest, Precision::Confusion()));
    result.point.position = toPoint(nearest);  // edges may be off the surface, within tolerances
    result.distance = distance(p, result.point.position);
    return result;
  }

 private:
  PointOnModel found(const Point3& p, const gp_Pnt2d& uv) const {
    const SurfacePoint point = surface_.inOccParameters().pointAt(uv.X(), uv.Y());
    return {point, id_, distance(p, point.position)};
  }

  int id_;
  TopoDS_Face face_;
  FaceSurface surface_;
  ShapeAnalysis_Surface finder_;
  BRepTopAdaptor_FClass2d inside_;
};

/// The box around a face, and how far a point is from it.
struct FaceBox {
  Point3 low, high;

  double distanceFrom(const Point3& p) const {
    const auto beyond = [](double low_, double x, double high_) {
      return std::max({low_ - x, x - high_, 0.0});
    };
    return length(
        {beyond(low.x, p.x, high.x), beyond(low.y, p.y, high.y), beyond(low.z, p.z, high.z)});
  }
};

std::vector<FaceBox> boxesOf(const ModelShape& model) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<FaceBox> boxes;
  for (int id = 1; id <= model.faces.Extent(); ++id) {
    Bnd_Box box;
    try {
      BRepBndLib::Add(model.faces(id), box, false);
    } catch (const Standard_Failure&) {
      box.SetVoid();
    }
    if (box.IsVoid() || box.IsOpen())
      boxes.push_back({{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}});
    else
      boxes.push_back({toPoint(box.CornerMin()), toPoint(box.CornerMax())});
  }
  return boxes;
}

/// Searches on all faces, for one thread.
class ModelFeet {
 public:
  ModelFeet(const ModelShape& model, const std::vector<FaceBox>& boxes)
      : model_(model), boxes_(boxes) {}

  PointOnModel onFace(const Point3& p, int face) {
    try {
      const auto [feet, isNew] = feet_.try_emplace(face);
      if (isNew) feet->second = std::make_unique<FaceFeet>(model_, face);
      if (feet->second) return feet->second->nearest(p);
    } catch (const Standard_Failure&) {
    } catch (const GeometryError&) {
    }
    return {};
  }

  /// Faces are tried from the nearest box on; of equally near points, that of the first face
  /// counts.
  PointOnModel onAll(const Point3& p) {
    order_.clear();
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      order_.emplace_back(boxes_[i].distanceFrom(p), static_cast<int>(i) + 1);
    std::ranges::sort(order_);
    PointOnModel best;
    for (const auto& [least, face] : order_) {
      if (best.face != 0 && least > best.distance) break;
      const PointOnModel here = onFace(p, face);
      if (here.face == 0) continue;
      if (best.face == 0 ||
          std::pair(here.distance, here.face) < std::pair(best.distance, best.face))
        best = here;
    }
    return best;
  }

 private:
  const ModelShape& model_;
  const std::vector<FaceBox>& boxes_;
  std::map<int, std::unique_ptr<FaceFeet>> feet_;  ///< null: the face has none
  std::vector<std::pair<double, int>> order_;
};

}  // namespace

std::vector<PointOnModel> pointsAt(const Model& model, int face,
                                   std::span<const Point2> parameters) {
  requireFace(model, face);
  std::optional<FaceSurface> surface;
  try {
    surface.emplace(model.shape().surface(face));
  } catch (const GeometryError& error) {
    throw InputError("face " + std::to_string(face) + ": " + error.what());
  }
  const GeneralSurface& general = surface->inOccParameters();
  std::vector<PointOnModel> points;
  points.reserve(parameters.size());
  for (const auto& [u, v] : parameters) {
    if (!std::isfinite(u) || !std::isfinite(v) || !general.has(u, v))
      throw InputError("face " + std::to_string(face) + " has no point with the parameters " +
                       textOf(Point2{u, v}));
    points.push_back({general.pointAt(u, v), face, 0});
  }
  return points;
}

std::vector<PointOnModel> nearestPoints(const Model& model, std::span<const Point3> points,
                                        std::span<const int> faces, int threads) {
  if (!faces.empty() && faces.size() != points.size())
    throw InputError("there are " + std::to_string(faces.size()) + " faces for " +
                     std::to_string(points.size()) + " points");
  for (const int face : faces)
    if (face != 0) requireFace(model, face);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const auto& [x, y, z] = points[i]; !std::isfinite(x + y + z))
      throw InputError("point " + std::to_string(i) + " has a coordinate that is no finite number");
  const std::vector<FaceBox> boxes = boxesOf(model.shape());
  constexpr std::size_t kAtOnce =
      512;  // setting up the search on a face takes as long as many points
  std::vector<PointOnModel> nearest(points.size());
  const Ranges ranges(points.size(), kAtOnce);
  forEachInParallel(ranges.count(), threads, [&](std::size_t part) {
    ModelFeet feet(model.shape(), boxes);
    for (const std::size_t i : ranges[part]) {
      const bool isAny = faces.empty() || faces[i] == 0;
      nearest[i] = isAny ? feet.onAll(points[i]) : feet.onFace(points[i], faces[i]);
      if (nearest[i].face == 0) nearest[i].point.position = points[i];
    }
  });
  return nearest;
}

}  // namespace af2::geometry
