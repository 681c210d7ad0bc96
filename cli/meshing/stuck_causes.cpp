#include "cli/meshing/stuck_causes.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "dsl/run/explain.h"
#include "engine/rule/refusal.h"

namespace af2::cli {
namespace {

using geometry::FaceReport;
using geometry::ModelMesh;
using geometry::StuckPlace;

/// Places at which most rules were refused for the same reason.
struct StuckCause {
  Refusal reason = Refusal::None;
  std::size_t places = 0;
  std::set<int> faces;
  std::map<std::string, std::size_t> rules;  ///< refused for this reason: how often, by title
};

void add(const ModelMesh& mesh, const FaceReport& face, const StuckPlace& place,
         std::map<Refusal, StuckCause>& causes) {
  std::vector<Refusal> reasons;
  for (const auto& [rule, reason] : place.refusals) reasons.push_back(reason);
  const std::optional<Refusal> main = dsl::mainCause(reasons);
  if (!main) return;
  StuckCause& cause = causes[*main];
  cause.reason = *main;
  ++cause.places;
  cause.faces.insert(face.id);
  for (const auto& [rule, reason] : place.refusals)
    if (reason == *main) ++cause.rules[mesh.ruleNames[rule]];
}

/// The most frequent first.
std::vector<StuckCause> causesOf(const ModelMesh& mesh) {
  std::map<Refusal, StuckCause> byReason;
  for (const FaceReport& face : mesh.faces)
    for (const StuckPlace& place : face.stuck) add(mesh, face, place, byReason);
  std::vector<StuckCause> causes;
  for (auto& [reason, cause] : byReason) causes.push_back(std::move(cause));
  std::ranges::stable_sort(causes, std::ranges::greater(), &StuckCause::places);
  return causes;
}

}  // namespace

std::string stuckText(const ModelMesh& mesh) {
  const auto faces =
      std::ranges::count_if(mesh.faces, [](const FaceReport& face) { return !face.stuck.empty(); });
  if (faces == 0) return "";
  std::string text =
      fmt::format("af2: fronts got stuck on {} face{}", faces, faces == 1 ? "" : "s");
  if (const std::vector<StuckCause> causes = causesOf(mesh); !causes.empty())
    text += fmt::format("; most frequent reason: {}; {}", toString(causes.front().reason),
                        dsl::remedyFor(causes.front().reason));
  return text + "\naf2: --stuck-tests FILE writes tests of these places, which say why\n";
}

std::string stuckJson(const ModelMesh& mesh) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const StuckCause& cause : causesOf(mesh))
    json.push_back({{"cause", toString(cause.reason)},
                    {"places", cause.places},
                    {"faces", cause.faces},
                    {"rules", cause.rules},
                    {"remedy", dsl::remedyFor(cause.reason)}});
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace af2::cli
