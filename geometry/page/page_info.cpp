#include "geometry/page/page_info.h"

#include <nlohmann/json.hpp>

#include "geometry/io/report.h"
#include "geometry/page/page_writer.h"

namespace af2::geometry {
namespace {

using Json = nlohmann::ordered_json;

Json pointJson(const Point3& p) { return Json::array({p.x, p.y, p.z}); }

Json stuckJson(const StuckPlace& place) {
  Json refused = Json::array();
  for (const auto& [rule, reason] : place.refusals) refused.push_back({rule, toString(reason)});
  return {{"from", pointJson(place.from)},
          {"to", pointJson(place.to)},
          {"level", place.level},
          {"refused", refused}};
}

Json faceJson(const FaceReport& face) {
  Json stuck = Json::array();
  for (const StuckPlace& place : face.stuck) stuck.push_back(stuckJson(place));
  return {{"id", face.id},
          {"name", face.name},
          {"surface", face.surfaceType},
          {"chart", face.chart},
          {"status", toString(face.status)},
          {"elements", face.elements},
          {"reason", face.reason},
          {"attempts", face.attempts},
          {"stuck", stuck}};
}

Json rulesJson(const ModelMesh& mesh) {
  Json rules = Json::array();
  for (std::size_t rule = 0; rule < mesh.ruleNames.size(); ++rule) {
    Json json{{"name", mesh.ruleNames[rule]}};
    if (rule < mesh.ruleTexts.size()) {
      json["file"] = mesh.ruleTexts[rule].file;
      json["line"] = mesh.ruleTexts[rule].line;
      json["text"] = mesh.ruleTexts[rule].text;
    }
    rules.push_back(std::move(json));
  }
  return rules;
}

Json groupsJson(const std::vector<FaceGroup>& groups) {
  Json list = Json::array();
  for (const FaceGroup& group : groups)
    list.push_back({{"kind", toString(group.kind)}, {"name", group.name}, {"faces", group.faces}});
  return list;
}

}  // namespace

std::string pageInfo(const ModelMesh& mesh, const Point3& centre, int cornersPerElement) {
  Json json{{"title", mesh.name.empty() ? "Mesh" : mesh.name},
            {"unit", mesh.unit},
            {"centre", pointJson(centre)},
            {"elementCount", mesh.elements.size()},
            {"cornersPerElement", cornersPerElement},
            {"rules", rulesJson(mesh)},
            {"faces", Json::array()},
            {"groups", groupsJson(mesh.groups)},
            {"notes", mesh.notes},
            {"findings", mesh.findings}};
  for (const FaceReport& face : mesh.faces) json["faces"].push_back(faceJson(face));
  // Names come from CAD files, which need not be valid UTF-8.
  return jsonInScript(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace af2::geometry
