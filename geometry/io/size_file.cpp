#include "geometry/io/size_file.h"

#include "geometry/io/json_file.h"

namespace af2::geometry {
namespace {

SizeSource pointFrom(const JsonValue& json) {
  json.expectKeys({"at", "size", "radius"});
  SizeSource source{json.at("at").point(), json.at("size").size()};
  if (json.has("radius")) {
    source.radius = json.at("radius").number();
    if (!(source.radius >= 0)) json.at("radius").fail("must not be negative");
  }
  return source;
}

SizeBox boxFrom(const JsonValue& json) {
  json.expectKeys({"from", "to", "size"});
  const SizeBox box{json.at("from").point(), json.at("to").point(), json.at("size").size()};
  if (!(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z))
    json.fail("the corner 'from' must not be above 'to' in x, y or z");
  return box;
}

SizeGrid gridFrom(const JsonValue& json) {
  json.expectKeys({"origin", "spacing", "counts", "sizes"});
  SizeGrid grid;
  grid.origin = json.at("origin").point();
  grid.spacing = json.at("spacing").point();
  const std::vector<JsonValue> counts = json.at("counts").elements();
  if (counts.size() != 3) json.at("counts").fail("give the numbers of nodes along x, y and z");
  std::size_t nodes = 1;
  for (std::size_t i = 0; i < 3; ++i) nodes *= grid.counts[i] = counts[i].count();
  grid.sizes = json.at("sizes").numbers();
  if (grid.sizes.size() != nodes)
    json.at("sizes").fail("there are " + std::to_string(grid.sizes.size()) + " for " +
                          std::to_string(nodes) + " nodes");
  for (const double spacing : {grid.spacing.x, grid.spacing.y, grid.spacing.z})
    if (!(spacing > 0)) json.at("spacing").fail("must be greater than 0 in x, y and z");
  for (const double size : grid.sizes)
    if (!(size > 0)) json.at("sizes").fail("a size is a number greater than 0");
  return grid;
}

}  // namespace

SizeFile readSizeFile(const std::filesystem::path& path) {
  const JsonValue json = JsonValue::readFile(path);
  json.expectKeys({"points", "boxes", "fields", "parts", "chords"});
  SizeFile file;
  if (json.has("points"))
    for (const JsonValue& point : json.at("points").elements())
      file.sources.points.push_back(pointFrom(point));
  if (json.has("boxes"))
    for (const JsonValue& box : json.at("boxes").elements())
      file.sources.boxes.push_back(boxFrom(box));
  if (json.has("fields"))
    for (const JsonValue& grid : json.at("fields").elements())
      file.sources.grids.push_back(gridFrom(grid));
  if (json.has("parts"))
    for (const auto& [name, size] : json.at("parts").members())
      file.parts.emplace_back(name, size.size());
  if (json.has("chords"))
    for (const auto& [name, chord] : json.at("chords").members())
      file.chords.emplace_back(name, ChordBound{chord.size(), false});
  return file;
}

}  // namespace af2::geometry
