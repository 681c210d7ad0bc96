#include "cli/inspect/inspect_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/io/merging_json.h"
#include "geometry/occ/inspect/edge_list.h"
#include "geometry/occ/inspect/measures.h"

namespace af2::cli {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Point3& p) { return Json::array({p.x, p.y, p.z}); }

Json boxJson(const Point3& low, const Point3& high) {
  return {{"low", toJson(low)}, {"high", toJson(high)}};
}

std::vector<int> solidsOf(int face, const std::vector<geometry::SolidMeasures>& solids) {
  std::vector<int> numbers;
  for (const geometry::SolidMeasures& solid : solids)
    if (std::ranges::binary_search(solid.faces, face)) numbers.push_back(solid.number);
  return numbers;
}

Json facesJson(const geometry::Model& model, const std::vector<geometry::SolidMeasures>& solids) {
  const auto measures = geometry::measuresOfFaces(model);
  Json faces = Json::array();
  for (int id = 1; id <= model.faceCount(); ++id) {
    Json face{{"id", id}, {"name", model.faceName(id)}, {"surface", model.surfaceType(id)}};
    if (const auto& m = measures[static_cast<std::size_t>(id) - 1]) {
      face["area"] = m->area;
      face["centroid"] = toJson(m->centroid);
      face["box"] = boxJson(m->low, m->high);
      face["curvature"] = {{"min", m->leastCurvature}, {"max", m->greatestCurvature}};
      face["edges"] = m->edges;
      face["neighbors"] = m->neighbors;
    }
    face["solids"] = solidsOf(id, solids);
    faces.push_back(std::move(face));
  }
  return faces;
}

Json edgesJson(const geometry::Model& model) {
  Json edges = Json::array();
  for (const geometry::EdgeEntry& edge : geometry::edgesOf(model))
    edges.push_back({{"id", edge.id},
                     {"curve", edge.curve},
                     {"length", edge.length},
                     {"from", toJson(edge.from)},
                     {"to", toJson(edge.to)},
                     {"faces", edge.faces}});
  return edges;
}

Json solidsJson(const std::vector<geometry::SolidMeasures>& solids) {
  Json all = Json::array();
  for (const geometry::SolidMeasures& solid : solids)
    all.push_back({{"number", solid.number},
                   {"volume", solid.volume},
                   {"centroid", toJson(solid.centroid)},
                   {"box", boxJson(solid.low, solid.high)},
                   {"faces", solid.faces}});
  return all;
}

Json groupsJson(const geometry::Model& model) {
  Json groups = Json::array();
  for (const geometry::FaceGroup& group : model.groups())
    groups.push_back(
        {{"kind", geometry::toString(group.kind)}, {"name", group.name}, {"faces", group.faces}});
  return groups;
}

/// There are no elements yet whose distance from the faces could be told.
Json mergingJson(const MergingAtSize& found) {
  Json json = geometry::toJson(found.merging);
  for (Json& group : json["groups"]) group.erase("deviation");
  json["size"] = found.size;
  return json;
}

}  // namespace

std::string inspectJson(const geometry::Model& model, const std::optional<MergingAtSize>& merging) {
  const std::vector<geometry::SolidMeasures> solids = geometry::measuresOfSolids(model);
  Json json{{"unit", model.unit()},         {"file_unit", model.fileUnit()},
            {"diagonal", model.diagonal()}, {"faces", facesJson(model, solids)},
            {"edges", edgesJson(model)},    {"solids", solidsJson(solids)},
            {"groups", groupsJson(model)},  {"lost_faces", model.lostFaces()},
            {"notes", model.notes()}};
  if (merging) json["merging"] = mergingJson(*merging);
  // Names that are no UTF-8 must not end the program.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace af2::cli
