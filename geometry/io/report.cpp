#include "geometry/io/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geometry/io/merging_json.h"
#include "geometry/io/output_file.h"
#include "geometry/mesh/fingerprint.h"

namespace af2::geometry {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Point3& p) { return Json::array({p.x, p.y, p.z}); }

Json toJson(const StuckPlace& place, const std::vector<std::string>& ruleNames) {
  Json json{{"from", toJson(place.from)},
            {"to", toJson(place.to)},
            {"uv", {place.u, place.v}},
            {"level", place.level},
            {"refused", Json::object()}};
  for (const auto& [rule, reason] : place.refusals)
    json["refused"][ruleNames[rule]] = toString(reason);
  return json;
}

Json toJson(const WithoutRuleCounts& counts) {
  return {{"closing", counts.closing}, {"fan", counts.fan}, {"leaning", counts.leaning}};
}

Json toJson(const FaceReport::OddLoop& odd) {
  Json json{{"loop", odd.loop}, {"edges", odd.segments}};
  const auto& [from, to, sizes] = odd.longest;
  if (sizes > 0) json["longest"] = {{"from", toJson(from)}, {"to", toJson(to)}, {"sizes", sizes}};
  return json;
}

Json toJson(const FrontActCounts& acts) {
  Json json;
  acts.forEach([&](const char* name, std::size_t count) { json[name] = count; });
  return json;
}

Json toJson(const LayersAlongEdge& along) {
  return {
      {"edge", along.edge},           {"asked", along.asked},       {"fewest", along.fewest},
      {"most", along.most},           {"segments", along.segments}, {"fewer", along.fewer},
      {"place", toJson(along.place)}, {"thinner", along.thinner},   {"thinnest", along.thinnest}};
}

Json toJson(const FaceReport& face, const std::vector<std::string>& ruleNames) {
  Json json{{"id", face.id}};
  if (!face.name.empty()) json["name"] = face.name;
  json["surface_type"] = face.surfaceType;
  json["status"] = toString(face.status);
  if (!face.chart.empty()) json["chart"] = face.chart;
  json["elements"] = face.elements;
  if (face.congruentTo > 0) json["congruent_to"] = face.congruentTo;
  json["area"] = face.area;
  json["seconds"] = face.seconds;
  json["reason"] = face.reason;
  if (face.cause != FailureCause::Unknown) json["cause"] = toString(face.cause);
  if (face.withoutRule.total() > 0) json["without_rule"] = toJson(face.withoutRule);
  if (face.acts != FrontActCounts{}) json["acts"] = toJson(face.acts);
  for (const LayersAlongEdge& along : face.layers) json["layers"].push_back(toJson(along));
  if (!face.layers.empty()) json["layer_elements"] = face.layerElements;
  if (face.triangles > 0) json["triangles"] = face.triangles;
  if (face.triangles > 0) json["first_triangle"] = toJson(face.firstTriangle);
  for (const FaceReport::OddLoop& odd : face.oddLoops)
    if (face.triangles > 0) json["odd_loops"].push_back(toJson(odd));
  if (face.deviation) json["deviation"] = *face.deviation;
  if (!face.attempts.empty()) json["attempts"] = face.attempts;
  for (const StuckPlace& place : face.stuck) json["stuck"].push_back(toJson(place, ruleNames));
  return json;
}

Json toJson(const Healing& healing) {
  Json changes = Json::array();
  for (const HealedChange& change : healing.changes) {
    Json entry{{"what", change.what}, {"count", change.count}};
    if (const auto& place = change.place) entry["place"] = {place->x, place->y, place->z};
    changes.push_back(std::move(entry));
  }
  return {{"tolerance", healing.tolerance}, {"changes", changes}, {"undone", healing.undone}};
}

Json toJson(const Imprinting& imprinting) {
  Json json{{"tolerance", imprinting.tolerance},
            {"parts", imprinting.parts},
            {"interfaces", imprinting.interfaces},
            {"changes", imprinting.changes}};
  if (!imprinting.undone.empty()) json["undone"] = imprinting.undone;
  return json;
}

Json toJson(const PartContacts& contacts) {
  Json pairs = Json::array();
  for (const PartContact& pair : contacts.pairs) {
    Json entry{{"kind", toString(pair.kind)}, {"parts", {pair.one, pair.other}}};
    if (pair.kind != ContactKind::Unknown) {
      entry["area"] = pair.area;
      entry["length"] = pair.length;
      entry["volume"] = pair.volume;
      entry["place"] = {pair.place.x, pair.place.y, pair.place.z};
      entry["equal_faces"] = pair.twins;
    }
    pairs.push_back(std::move(entry));
  }
  return {{"parts", contacts.parts}, {"pairs", pairs}, {"not_compared", contacts.notCompared}};
}

Json toJson(const Deviation& deviation) {
  Json json{{"largest", deviation.largest}, {"place", toJson(deviation.place)}};
  if (deviation.face > 0) json["face"] = deviation.face;
  if (deviation.edge > 0) json["edge"] = deviation.edge;
  return json;
}

Json toJson(const StageSeconds& seconds) {
  return {{"read", seconds.read},       {"contacts", seconds.contacts}, {"edges", seconds.edges},
          {"surface", seconds.surface}, {"optimize", seconds.optimize}, {"write", seconds.write}};
}

Json toJson(const LengthRatio& edges) {
  return {{"mean", edges.mean},
          {"p5", edges.p5},
          {"p95", edges.p95},
          {"bounds", LengthRatio::kBounds},
          {"histogram", edges.histogram},
          {"asked", {edges.leastWanted, edges.mostWanted}},
          {"achieved", {edges.leastLength, edges.mostLength}}};
}

Json toJson(const MeshQuality& quality) {
  return {{"min", quality.min},
          {"worst", {{"face", quality.worstFace}, {"place", toJson(quality.worstPlace)}}},
          {"p1", quality.p1},
          {"mean", quality.mean},
          {"min_angle", quality.minAngle},
          {"max_angle", quality.maxAngle},
          {"edge_ratio", toJson(quality.edges)},
          {"free_edges", quality.freeEdges}};
}

}  // namespace

const char* toString(RunStatus status) {
  switch (status) {
    case RunStatus::Complete:
      return "complete";
    case RunStatus::Partial:
      return "partial";
    case RunStatus::Failed:
      return "failed";
    case RunStatus::Cancelled:
      return "cancelled";
  }
  return "failed";
}

const char* toString(GroupKind kind) {
  switch (kind) {
    case GroupKind::Part:
      return "part";
    case GroupKind::Solid:
      return "solid";
    case GroupKind::Layer:
      return "layer";
    case GroupKind::Color:
      return "color";
    case GroupKind::Interface:
      return "interface";
  }
  return "part";
}

std::string shownName(const EdgeGroup& boundary) {
  return boundary.name.empty() ? std::to_string(boundary.number) : boundary.name;
}

const char* toString(FaceStatus status) {
  switch (status) {
    case FaceStatus::Complete:
      return "complete";
    case FaceStatus::Failed:
      return "failed";
    case FaceStatus::Cancelled:
      return "cancelled";
    case FaceStatus::Skipped:
      return "skipped";
  }
  return "failed";
}

const char* toString(FailureCause cause) {
  switch (cause) {
    case FailureCause::Unknown:
      return "";
    case FailureCause::Model:
      return "model";
    case FailureCause::Size:
      return "size";
  }
  return "";
}

RunStatus statusOf(const ModelMesh& mesh) {
  const auto count = [&](FaceStatus status) {
    return std::ranges::count(mesh.faces, status, &FaceReport::status);
  };
  if (count(FaceStatus::Cancelled) > 0) return RunStatus::Cancelled;
  if (count(FaceStatus::Complete) == 0) return RunStatus::Failed;
  return count(FaceStatus::Failed) > 0 ? RunStatus::Partial : RunStatus::Complete;
}

void writeReport(const RunReport& report, const ModelMesh& mesh, OutputFile& file) {
  const std::size_t quads = quadCount(mesh);
  Json json{{"status", toString(report.status)}};
  if (!report.reason.empty()) json["reason"] = report.reason;
  json["order"] = mesh.midsides.empty() ? 1 : 2;
  for (const ElementId element : mesh.straightened) {
    const Point3& p = mesh.vertices[mesh.elements[element.value].corners[0].value];
    json["straightened"].push_back({{"element", element.value},
                                    {"face", mesh.face[element.value]},
                                    {"place", {p.x, p.y, p.z}}});
  }
  if (!mesh.unit.empty()) json["unit"] = mesh.unit;
  if (!mesh.fileUnit.empty()) json["file_unit"] = mesh.fileUnit;
  json["vertices"] = vertexCount(mesh);
  json["triangles"] = elementCount(mesh) - quads;
  json["quads"] = quads;
  json["without_rule"] = toJson(elementsWithoutRule(mesh));
  json["faces"] = Json::array();
  for (const FaceReport& face : mesh.faces) json["faces"].push_back(toJson(face, mesh.ruleNames));
  for (const FaceGroup& group : mesh.groups) {
    Json entry{{"kind", toString(group.kind)}, {"name", group.name}, {"faces", group.faces}};
    if (!group.inward.empty()) entry["inward"] = group.inward;
    json["groups"].push_back(std::move(entry));
  }
  for (const EdgeGroup& boundary : mesh.boundaries)
    json["groups"].push_back({{"kind", "boundary"},
                              {"name", shownName(boundary)},
                              {"number", boundary.number},
                              {"edges", boundary.edges}});
  if (!mesh.notes.empty()) json["notes"] = mesh.notes;
  if (mesh.healing) json["healing"] = toJson(*mesh.healing);
  if (mesh.imprinting) json["imprinting"] = toJson(*mesh.imprinting);
  if (mesh.merging) json["merging"] = toJson(*mesh.merging);
  for (const PeriodicPair& pair : mesh.periodic)
    json["periodic"].push_back({{"first", pair.first},
                                {"second", pair.second},
                                {"transform", pair.transform},
                                {"vertices", pair.vertices.size()}});
  if (mesh.deviation) json["deviation"] = toJson(*mesh.deviation);
  if (mesh.contacts.parts > 1) json["contacts"] = toJson(mesh.contacts);
  for (const auto& [name, value] : report.sections) json[name] = Json::parse(value);
  json["seconds"] = toJson(mesh.seconds);
  json["quality"] = toJson(report.quality);
  json["fingerprint"] = fingerprint(mesh);
  // Names come from CAD files, which need not be valid UTF-8.
  file.text(json.dump(2, ' ', false, Json::error_handler_t::replace));
  file.text("\n");
}

void writeReport(const RunReport& report, const ModelMesh& mesh,
                 const std::filesystem::path& path) {
  OutputFile file(path);
  writeReport(report, mesh, file);
  file.commit();
}

}  // namespace af2::geometry
