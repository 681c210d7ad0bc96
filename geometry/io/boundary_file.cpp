#include "geometry/io/boundary_file.h"

#include "geometry/base/words.h"
#include "geometry/io/json_file.h"

namespace af2::geometry {
namespace {

int edgeId(const JsonValue& json, const std::string& text) {
  const auto id = numberIn<int>(text);
  if (!id || *id < 1) json.fail("'" + text + "' is not the id of an edge");
  return *id;
}

}  // namespace

EdgePoints readEdgePoints(const std::filesystem::path& path) {
  const JsonValue json = JsonValue::readFile(path);
  json.expectKeys({"edges"});
  EdgePoints edges;
  for (const auto& [id, points] : json.at("edges").members()) {
    std::vector<Point3>& own = edges[edgeId(json, id)];
    for (const JsonValue& point : points.elements()) own.push_back(point.point());
  }
  return edges;
}

}  // namespace af2::geometry
