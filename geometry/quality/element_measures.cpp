#include "geometry/quality/element_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/elementary.h"

namespace af2::geometry {
namespace {

Point3 toNext(CornerPoints corners, std::size_t i) {
  return corners[(i + 1) % corners.size()] - corners[i];
}
Point3 toPrevious(CornerPoints corners, std::size_t i) {
  return corners[(i + corners.size() - 1) % corners.size()] - corners[i];
}

double jacobianOfTriangle(CornerPoints corners) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    most = std::max(most, length(toNext(corners, i)) * length(toPrevious(corners, i)));
  return most > 0 ? 2 / std::numbers::sqrt3 * length(areaVector(corners)) / most : 0;
}

double jacobianOfQuad(CornerPoints corners) {
  const Point3 normal = unit(areaVector(corners));
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 p = toNext(corners, i), q = toPrevious(corners, i);
    const double lengths = length(p) * length(q);
    least = std::min(least, lengths > 0 ? dot(cross(p, q), normal) / lengths : 0);
  }
  return least;
}

}  // namespace

Point3 areaVector(CornerPoints corners) {
  if (corners.size() == 3) return cross(corners[1] - corners[0], corners[2] - corners[0]);
  return cross(corners[2] - corners[0], corners[3] - corners[1]);
}

double scaledJacobian(CornerPoints corners) {
  return corners.size() == 3 ? jacobianOfTriangle(corners) : jacobianOfQuad(corners);
}

double aspectRatio(CornerPoints corners) {
  double longest = 0, sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double side = length(toNext(corners, i));
    longest = std::max(longest, side);
    sum += side;
  }
  const double twiceArea = length(areaVector(corners));
  if (twiceArea == 0) return std::numeric_limits<double>::infinity();
  const double ideal = corners.size() == 3 ? 2 * std::numbers::sqrt3 : 2;
  return longest * sum / (ideal * twiceArea);
}

double cornerAngle(CornerPoints corners, std::size_t i) {
  const Point3 p = toNext(corners, i), q = toPrevious(corners, i);
  const Point3 turn = cross(p, q);
  const double angle = angleOf({dot(p, q), length(turn)}) * 180 / std::numbers::pi;
  const bool isReflex = corners.size() == 4 && dot(turn, areaVector(corners)) < 0;
  return isReflex ? 360 - angle : angle;
}

}  // namespace af2::geometry
