// What `af2 eval` prints of an evaluation.
#include <nlohmann/json.hpp>

#include "dsl/run/evaluate.h"
#include "engine/base/place_text.h"

namespace af2::dsl {
namespace {

constexpr int kDigits = 12;

std::string numberText(std::optional<double> value) {
  return value ? textOf(*value, kDigits) : "no value";
}

std::string placeText(std::optional<Point2> p) { return p ? textOf(*p, kDigits) : "no value"; }

std::string actsText(const EvaluatedActs& acts) {
  std::string text;
  if (acts.weld)
    text += "weld      " + acts.weld->from + " into " + acts.weld->into + " at " +
            placeText(acts.weld->place) + "\n";
  if (acts.path)
    text += "path      " + acts.path->from + " -> " + acts.path->to + " by " +
            numberText(acts.path->segments) +
            " edges, or the nearest number that leaves even loops\n";
  return text;
}

std::string nearText(const EvaluatedActs::Near& near) {
  return "near " + near.vertex + "    " + numberText(near.away) + " from " + placeText(near.place) +
         ", within " + numberText(near.reach) + "\n";
}

nlohmann::ordered_json numberJson(std::optional<double> value) {
  return value ? nlohmann::ordered_json(*value) : nullptr;
}

nlohmann::ordered_json pointJson(std::optional<Point2> p) {
  return p ? nlohmann::ordered_json::array({p->x, p->y}) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json nearJson(const EvaluatedActs::Near& near) {
  return {{"vertex", near.vertex},
          {"place", pointJson(near.place)},
          {"within", near.reach},
          {"away", numberJson(near.away)}};
}

nlohmann::ordered_json weldJson(const EvaluatedActs::Weld& weld) {
  return {{"from", weld.from}, {"into", weld.into}, {"at", pointJson(weld.place)}};
}

nlohmann::ordered_json pathJson(const EvaluatedActs::Path& path) {
  return {{"from", path.from}, {"to", path.to}, {"by", numberJson(path.segments)}};
}

}  // namespace

std::string toJson(const EvalResult& result) {
  nlohmann::ordered_json json;
  if (result.refused == Refusal::None)
    json["refused"] = nullptr;
  else
    json["refused"] = toString(result.refused);
  if (!result.because.empty()) json["because"] = result.because;
  json["matches"] = result.matches;
  json["require"] = result.requireHolds;
  for (const EvaluatedActs::Near& near : result.acts.near) json["near"].push_back(nearJson(near));
  json["new"] = nlohmann::ordered_json::object();
  for (const auto& [name, at] : result.newVertices) json["new"][name] = pointJson(at);
  if (result.acts.weld) json["weld"] = weldJson(*result.acts.weld);
  if (result.acts.path) json["path"] = pathJson(*result.acts.path);
  json["zones"] = nlohmann::ordered_json::array();
  for (const auto& zone : result.zones) {
    auto loop = nlohmann::ordered_json::array();
    for (Point2 p : zone) loop.push_back(pointJson(p));
    json["zones"].push_back(std::move(loop));
  }
  json["points_in_zone"] = result.pointsInZone;
  json["segments_meet_zone"] = result.segmentsMeetZone;
  json["score"] = numberJson(result.score);
  return json.dump(2) + "\n";
}

std::string toText(const EvalResult& result) {
  std::string text = std::string("refused   ") +
                     (result.refused == Refusal::None ? "no" : toString(result.refused)) + "\n";
  if (!result.because.empty()) text += "because   " + result.because + "\n";
  text += std::string("matches   ") + (result.matches ? "yes" : "no") + "\n";
  text += std::string("require   ") + (result.requireHolds ? "holds" : "does not hold") + "\n";
  for (const EvaluatedActs::Near& near : result.acts.near) text += nearText(near);
  for (const auto& [name, at] : result.newVertices)
    text += "new " + name + "     " + placeText(at) + "\n";
  text += actsText(result.acts);
  for (const auto& zone : result.zones) {
    text += "zone     ";
    for (Point2 p : zone) text += " " + placeText(p);
    text += "\n";
  }
  for (bool b : result.pointsInZone)
    text += std::string("point     ") + (b ? "in the zone" : "outside of the zone") + "\n";
  for (bool b : result.segmentsMeetZone)
    text += std::string("segment   ") + (b ? "meets the zone" : "keeps clear of the zone") + "\n";
  text += "score     " + (result.score ? textOf(*result.score, kDigits) : "none") + "\n";
  return text;
}

}  // namespace af2::dsl
