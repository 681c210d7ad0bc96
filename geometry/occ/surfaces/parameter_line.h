// A line on a surface along which one parameter varies and the other is fixed.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/surfaces/general_surface.h"

namespace af2::geometry {

/// Keeps a reference to the surface.
class ParameterLine {
 public:
  ParameterLine(const GeneralSurface& surface, bool isInU, double fixed)
      : surface_(surface), isInU_(isInU), fixed_(fixed) {}

  struct Place {
    double parameter;
    Point3 position, normal;
  };
  Place at(double parameter) const {
    const SurfaceFrame frame =
        isInU_ ? surface_.frameAt(parameter, fixed_) : surface_.frameAt(fixed_, parameter);
    const Point3 normal = cross(frame.du, frame.dv);
    const double size = length(normal);
    return {parameter, frame.position, size > 0 ? (1 / size) * normal : Point3{}};
  }
  double speedAt(double parameter) const {
    const SurfaceFrame frame =
        isInU_ ? surface_.frameAt(parameter, fixed_) : surface_.frameAt(fixed_, parameter);
    return length(isInU_ ? frame.du : frame.dv);
  }
  double lengthBetween(double from, double to) const {
    constexpr int kChords = 16;
    double sum = 0;
    Point3 last = at(from).position;
    for (int i = 1; i <= kChords; ++i) {
      const Point3 next = at(from + (to - from) * i / kChords).position;
      sum += distance(last, next);
      last = next;
    }
    return sum;
  }

 private:
  const GeneralSurface& surface_;
  bool isInU_;
  double fixed_;
};

/// Distance between the unit normals at two places; 0 if one has no normal.
inline double turnBetween(const ParameterLine::Place& a, const ParameterLine::Place& b) {
  if (!(dot(a.normal, a.normal) > 0 && dot(b.normal, b.normal) > 0)) return 0;
  return distance(a.normal, b.normal);
}

/// Goes on from the last of some places to another one, with places between them so dense that it
/// is known where the line turns, but not nearer to each other than `shortest`.
inline void follow(const ParameterLine& line, const ParameterLine::Place& to, double shortest,
                   std::vector<ParameterLine::Place>& places, int depth = 0) {
  constexpr int kDeepest = 20;
  constexpr double kKnown = 0.25;  // turn
  const ParameterLine::Place from = places.back();
  const bool isShort = distance(from.position, to.position) < shortest;
  if (depth < kDeepest && turnBetween(from, to) > kKnown && !isShort) {
    const ParameterLine::Place middle = line.at((from.parameter + to.parameter) / 2);
    follow(line, middle, shortest, places, depth + 1);
    follow(line, to, shortest, places, depth + 1);
  } else {
    places.push_back(to);
  }
}

}  // namespace af2::geometry
