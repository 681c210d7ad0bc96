#include "geometry/io/points_file.h"

#include "geometry/io/json_file.h"

namespace af2::geometry {
namespace {

std::vector<Point3> pointsOf(const JsonValue& list) {
  std::vector<Point3> points;
  for (const JsonValue& point : list.elements()) points.push_back(point.point());
  return points;
}

}  // namespace

InsideFaces readInsideFaces(const std::filesystem::path& path) {
  const JsonValue json = JsonValue::readFile(path);
  json.expectKeys({"points", "curves"});
  if (!json.has("curves")) return {pointsOf(json.at("points")), {}};
  InsideFaces inside;
  if (json.has("points")) inside.points = pointsOf(json.at("points"));
  for (const JsonValue& curve : json.at("curves").elements()) {
    inside.curves.push_back(pointsOf(curve));
    if (inside.curves.back().size() < 2) curve.fail("a curve needs at least two points");
  }
  return inside;
}

}  // namespace af2::geometry
