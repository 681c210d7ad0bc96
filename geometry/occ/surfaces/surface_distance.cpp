#include "geometry/occ/surfaces/surface_distance.h"

#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "engine/base/elementary.h"
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
class GeneralDistance final : public FaceDistance {
 public:
  GeneralDistance(const GeneralSurface& surface, const SplineSurface::Box& box)
      : surface_(surface) {
    constexpr int kPlaces = 32;  // along each parameter
    for (int i = 0; i <= kPlaces; ++i)
      for (int j = 0; j <= kPlaces; ++j) {
        const double u = box.u1 + (box.u2 - box.u1) * i / kPlaces;
        const double v = box.v1 + (box.v2 - box.v1) * j / kPlaces;
        places_.push_back({surface_.frameAt(u, v).position, u, v});
      }
    last_ = places_.front();
  }

  double of(const Point3& point) override {
    const auto gap = [&](const Place& place) {
      const Point3 d = place.position - point;
      return dot(d, d);
    };
    const Place nearest = *std::ranges::min_element(places_, {}, gap);
    Place best = refined(point, last_);
    if (const Place other = refined(point, nearest); gap(other) < gap(best)) best = other;
    last_ = best;
    return distance(point, best.position);
  }

 private:
  struct Place {
    Point3 position;
    double u = 0, v = 0;
  };
  Place refined(const Point3& point, Place from) const {
    surface_.refine(point, from.u, from.v);
    from.position = surface_.frameAt(from.u, from.v).position;
    return from;
  }

  GeneralSurface surface_;
  std::vector<Place> places_;
  Place last_;
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
