#include "geometry/occ/surfaces/swept_maps.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace af2::geometry {

namespace {

double senseOf(const GeneralSurface& surface) { return surface.isFlipped() ? -1 : 1; }

class ExtrusionMap final : public PlaneMap {
 public:
  /// lengths  of the curve across the direction
  /// heights  along the direction
  ExtrusionMap(const GeneralSurface& surface, const Extrusion& extrusion, double start,
               LengthTable lengths, LengthTable heights)
      : surface_(surface),
        extrusion_(extrusion),
        start_(start),
        sense_(extrusion.isAlongU ? -senseOf(surface) : senseOf(surface)),
        lengths_(std::move(lengths)),
        heights_(std::move(heights)) {}

  Point2 flatten(const SurfacePoint& point) const override {
    return {sense_ * lengths_.lengthAt(extrusion_.isAlongU ? point.v : point.u),
            dot(point.position, extrusion_.direction)};
  }
  SurfacePoint lift(Point2 place) const override {
    const double across = lengths_.parameterAt(sense_ * place.x);
    const auto [u, v] = at(across, start_);
    const double low = dot(surface_.frameAt(u, v).position, extrusion_.direction);
    const auto [liftedU, liftedV] = at(across, heights_.parameterAt(place.y - low));
    return surface_.pointAt(liftedU, liftedV);
  }

 private:
  std::pair<double, double> at(double across, double along) const {
    return extrusion_.isAlongU ? std::pair{along, across} : std::pair{across, along};
  }

  const GeneralSurface& surface_;
  Extrusion extrusion_;
  double start_, sense_;
  LengthTable lengths_, heights_;
};

class RevolutionMap final : public PlaneMap {
 public:
  RevolutionMap(const GeneralSurface& surface, const AxisFrame& frame, double u, double radius,
                LengthTable lengths)
      : surface_(surface),
        frame_(frame),
        u_(u),
        radius_(radius),
        sense_(senseOf(surface)),
        lengths_(std::move(lengths)) {}

  Point2 flatten(const SurfacePoint& point) const override {
    // The meridian need not lie in a plane with the axis.
    const double angle = point.u - u_ + angleOfMeridian(point.v);
    return {sense_ * radius_ * angle, radius_ * lengths_.lengthAt(point.v)};
  }
  SurfacePoint lift(Point2 place) const override {
    const double v = lengths_.parameterAt(place.y / radius_);
    return surface_.pointAt(sense_ * place.x / radius_ + u_ - angleOfMeridian(v), v);
  }
  double scaleAt(Point2 place) const override {
    const double v = lengths_.parameterAt(place.y / radius_);
    return radius_ / fromAxis(surface_.frameAt(u_, v).position);
  }
  Point2 scaleGradientAt(Point2 place) const override {
    const SurfaceFrame at = surface_.frameAt(u_, lengths_.parameterAt(place.y / radius_));
    const Point3 d = at.position - frame_.origin;
    const Point3 outwards = unit(d - dot(d, frame_.axis) * frame_.axis);
    const Point3 around = cross(frame_.axis, outwards);
    // Along the meridian the distance from the axis changes by this share of the length.
    const double share = dot(at.dv, outwards) / length(at.dv - dot(at.dv, around) * around);
    return {0, -share / radius_};
  }

 private:
  double angleOfMeridian(double v) const {
    return frame_.angleNear(surface_.frameAt(u_, v).position, 0);
  }
  double fromAxis(const Point3& p) const {
    const Point3 d = p - frame_.origin;
    return length(d - dot(d, frame_.axis) * frame_.axis);
  }

  const GeneralSurface& surface_;
  AxisFrame frame_;
  double u_, radius_, sense_;
  LengthTable lengths_;
};

}  // namespace

std::unique_ptr<PlaneMap> makeExtrusionMap(const GeneralSurface& surface,
                                           const SplineSurface::Box& box,
                                           const Extrusion& extrusion) {
  const bool alongU = extrusion.isAlongU;
  const auto frameAt = [&](double across, double along) {
    return alongU ? surface.frameAt(along, across) : surface.frameAt(across, along);
  };
  const auto [start, end] = alongU ? std::pair{box.u1, box.u2} : std::pair{box.v1, box.v2};
  const auto [from, to] = alongU ? std::pair{box.v1, box.v2} : std::pair{box.u1, box.u2};
  auto lengths = LengthTable::make(from, to, [&](double across) {
    const SurfaceFrame frame = frameAt(across, start);
    const Point3& d = alongU ? frame.dv : frame.du;
    return length(d - dot(d, extrusion.direction) * extrusion.direction);
  });
  auto heights = LengthTable::make(start, end, [&](double along) {
    const SurfaceFrame frame = frameAt(from, along);
    return dot(alongU ? frame.du : frame.dv, extrusion.direction);
  });
  if (!lengths || !heights) return nullptr;
  return std::make_unique<ExtrusionMap>(surface, extrusion, start, std::move(*lengths),
                                        std::move(*heights));
}

std::unique_ptr<PlaneMap> makeRevolutionMap(const GeneralSurface& surface,
                                            const SplineSurface::Box& box, const Point3& onAxis,
                                            const Point3& axis) {
  const auto across = [&](const Point3& d) { return d - dot(d, axis) * axis; };
  constexpr double kMinShare = 0.02;  // of the largest distance from the axis
  double radius = 0, least = std::numeric_limits<double>::infinity();
  auto lengths = LengthTable::make(box.v1, box.v2, [&](double v) {
    const SurfaceFrame at = surface.frameAt(box.u1, v);
    const Point3 radial = across(at.position - onAxis);
    const double fromAxis = length(radial);
    radius = std::max(radius, fromAxis);
    least = std::min(least, fromAxis);
    const Point3 around = cross(axis, unit(radial));
    return length(at.dv - dot(at.dv, around) * around) / fromAxis;
  });
  if (!lengths || !(least > kMinShare * radius)) return nullptr;
  const Point3 x = unit(across(surface.frameAt(box.u1, 0.5 * (box.v1 + box.v2)).position - onAxis));
  return std::make_unique<RevolutionMap>(surface, AxisFrame{onAxis, x, cross(axis, x), axis},
                                         box.u1, radius, std::move(*lengths));
}

}  // namespace af2::geometry
