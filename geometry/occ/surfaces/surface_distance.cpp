#include "geometry/occ/surfaces/surface_distance.h"

#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "engine/base/elementary.h"
#include "geometry/base/box_tree.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {
namespace {

/// In closed form.
class QuadricDistance final : public FaceDistance {
 public:
  explicit QuadricDistance(std::function<double(const Point3&)> distance)
      : distance_(std::move(distance)) {}
  double of(const Point3& point) override { return distance_(point); }

 private:
  std::function<double(const Point3&)> distance_;
};

/// A place as seen from an axis: along it, and away from it.
struct FromAxis {
  double along, away;
};

struct Axis {
  Point3 origin, direction;
  explicit Axis(const gp_Ax3& position)
      : origin(toPoint(position.Location())), direction(toPoint(position.Direction())) {}
  FromAxis at(const Point3& p) const {
    const double along = dot(p - origin, direction);
    return {along, length(p - origin - along * direction)};
  }
};

std::unique_ptr<FaceDistance> quadric(const BRepAdaptor_Surface& surface) {
  const auto made = [](std::function<double(const Point3&)> distance) {
    return std::make_unique<QuadricDistance>(std::move(distance));
  };
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      return made([axis = Axis(surface.Cylinder().Position()),
                   radius = surface.Cylinder().Radius()](const Point3& p) {
        return std::abs(axis.at(p).away - radius);
      });
    case GeomAbs_Sphere:
      return made([centre = toPoint(surface.Sphere().Location()),
                   radius = surface.Sphere().Radius()](const Point3& p) {
        return std::abs(distance(p, centre) - radius);
      });
    case GeomAbs_Torus:
      return made([axis = Axis(surface.Torus().Position()), major = surface.Torus().MajorRadius(),
                   minor = surface.Torus().MinorRadius()](const Point3& p) {
        const FromAxis at = axis.at(p);
        return std::abs(length(Point2{at.away - major, at.along}) - minor);
      });
    case GeomAbs_Cone:
      return made([axis = Axis(surface.Cone().Position()), radius = surface.Cone().RefRadius(),
                   angle = surface.Cone().SemiAngle()](const Point3& p) {
        // The nearer one of both nappes, as lines in the plane through the axis.
        const FromAxis at = axis.at(p);
        const double on = radius + at.along * tangent(angle);
        return cosine(angle) * std::min(std::abs(at.away - on), std::abs(at.away + on));
      });
    default:
      return nullptr;
  }
}

/// By Newton's method from the nearest of many places on the face, and from the last one found.
/// Where the face closes without being smooth, the foot may be beyond the end of a parameter.
class GeneralDistance final : public FaceDistance {
 public:
  GeneralDistance(const GeneralSurface& surface, const SplineSurface::Box& box)
      : surface_(surface), box_(box), places_(placesOn(surface, box)), tree_(boxesOf(places_)) {
    double extent = 0, acrossU = 0, acrossV = 0;
    for (const Place& place : places_)
      extent = std::max(extent, distance(place.position, places_[0].position));
    for (std::size_t k = 0; k <= kPlaces; ++k) {
      const std::size_t row = k * (kPlaces + 1), end = kPlaces * (kPlaces + 1);
      acrossU = std::max(acrossU, distance(places_[k].position, places_[end + k].position));
      acrossV = std::max(acrossV, distance(places_[row].position, places_[row + kPlaces].position));
    }
    closesInU_ = acrossU <= kSame * extent;
    closesInV_ = acrossV <= kSame * extent;
  }

  double of(const Point3& point) override {
    const auto gap = [&](const Place& place) { return distance(point, place.position); };
    const std::uint32_t nearest =
        tree_.nearest(point, 1e300, [&](std::uint32_t i) { return gap(places_[i]); });
    Place best = refined(point, last_);
    if (nearest != BoxTree::kNone)
      if (const Place other = refined(point, places_[nearest]); gap(other) < gap(best))
        best = other;
    last_ = best;
    return gap(best);
  }

 private:
  static constexpr std::size_t kPlaces = 64;  // along each parameter
  static constexpr double kSame = 1e-7;       // of the extent of the face
  struct Place {
    Point3 position;
    double u = 0, v = 0;
  };

  static std::vector<Place> placesOn(const GeneralSurface& surface, const SplineSurface::Box& box) {
    std::vector<Place> places;
    for (std::size_t i = 0; i <= kPlaces; ++i)
      for (std::size_t j = 0; j <= kPlaces; ++j) {
        const double u = box.u1 + (box.u2 - box.u1) * static_cast<double>(i) / kPlaces;
        const double v = box.v1 + (box.v2 - box.v1) * static_cast<double>(j) / kPlaces;
        places.push_back({surface.frameAt(u, v).position, u, v});
      }
    return places;
  }
  static std::vector<Box3> boxesOf(const std::vector<Place>& places) {
    std::vector<Box3> boxes;
    for (const Place& place : places) boxes.push_back({place.position, place.position});
    return boxes;
  }

  Place refined(const Point3& point, const Place& from) const {
    Place best = foot(point, from.u, from.v);
    const auto improve = [&](double u, double v) {
      const Place other = foot(point, u, v);
      if (distance(point, other.position) < distance(point, best.position)) best = other;
    };
    if (closesInU_ && (best.u <= box_.u1 || best.u >= box_.u2))
      improve(best.u <= box_.u1 ? box_.u2 : box_.u1, best.v);
    if (closesInV_ && (best.v <= box_.v1 || best.v >= box_.v2))
      improve(best.u, best.v <= box_.v1 ? box_.v2 : box_.v1);
    return best;
  }
  Place foot(const Point3& point, double u, double v) const {
    surface_.refine(point, u, v);
    return {surface_.frameAt(u, v).position, u, v};
  }

  GeneralSurface surface_;
  SplineSurface::Box box_;
  bool closesInU_ = false, closesInV_ = false;
  std::vector<Place> places_;
  BoxTree tree_;
  Place last_ = places_.front();
};

}  // namespace

std::unique_ptr<FaceDistance> distanceFromSurface(const TopoDS_Face& face,
                                                  const FaceSurface& surface) {
  if (surface.isPlane()) return nullptr;
  const BRepAdaptor_Surface adaptor(face, false);
  if (auto closed = quadric(adaptor)) return closed;
  return std::make_unique<GeneralDistance>(surface.inOccParameters(), surface.box());
}

}  // namespace af2::geometry
