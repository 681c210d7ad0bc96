#include "geometry/io/points_file.h"

#include "geometry/io/json_file.h"

namespace af2::geometry {

std::vector<Point3> readPoints(const std::filesystem::path& path) {
  const JsonValue json = JsonValue::readFile(path);
  json.expectKeys({"points"});
  std::vector<Point3> points;
  for (const JsonValue& point : json.at("points").elements()) points.push_back(point.point());
  return points;
}

}  // namespace af2::geometry
