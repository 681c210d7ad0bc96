// Findings in SARIF 2.1.0, which code hosts and editors read.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "dsl/text/diagnostic.h"

namespace af2::dsl {
namespace {

using Json = nlohmann::ordered_json;

/// A path as a relative URI reference. Reserved and non-ASCII characters are escaped.
std::string uriOf(const std::string& path) {
  constexpr std::string_view kPlain = "/-._~!$&'()*+,;=@:";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool isAlphanumeric =
        (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (isAlphanumeric || kPlain.find(c) != kPlain.npos)
      uri += c;
    else
      uri += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
  }
  return uri;
}

Json locationOf(const DiagnosticPlace& p) {
  Json physical{{"artifactLocation", {{"uri", uriOf(p.file)}}}};
  if (p.line > 0)
    physical["region"] = {{"startLine", p.line},
                          {"startColumn", p.column},
                          {"endLine", p.endLine},
                          {"endColumn", std::max(p.endColumn, 1)}};
  return {{"physicalLocation", physical}};
}

Json fixOf(const SuggestedEdit& edit) {
  const Json location = locationOf(edit.place)["physicalLocation"];
  const Json replacement{{"deletedRegion", location["region"]},
                         {"insertedContent", {{"text", edit.replacement}}}};
  return {{"description", {{"text", edit.what}}},
          {"artifactChanges", Json::array({{{"artifactLocation", location["artifactLocation"]},
                                            {"replacements", Json::array({replacement})}}})}};
}

Json resultOf(const Diagnostic& d, std::size_t ruleIndex) {
  std::string text = d.message;
  if (!d.label.empty()) text += ": " + d.label;
  Json related = Json::array();
  for (const DiagnosticNote& note : d.notes) {
    if (!note.place) {
      text += "\nnote: " + note.message;
      continue;
    }
    Json location = locationOf(*note.place);
    location["message"] = {{"text", note.message}};
    related.push_back(location);
  }
  if (!d.help.empty()) text += "\nhelp: " + d.help;
  Json result{{"ruleId", fullIdOf(d.code)},
              {"ruleIndex", ruleIndex},
              {"level", d.severity == Severity::Error ? "error" : "warning"},
              {"message", {{"text", text}}},
              {"locations", Json::array({locationOf(d.place)})}};
  if (!related.empty()) result["relatedLocations"] = related;
  for (const SuggestedEdit& edit : d.edits) result["fixes"].push_back(fixOf(edit));
  return result;
}

Json ruleOf(Code code) {
  return {{"id", fullIdOf(code)},
          {"shortDescription", {{"text", infoOf(code).title}}},
          {"help", {{"text", infoOf(code).explanation}}}};
}

}  // namespace

std::string toSarif(std::span<const Diagnostic> diagnostics) {
  Json results = Json::array(), rules = Json::array();
  std::map<Code, std::size_t> known;
  for (const Diagnostic& d : diagnostics) {
    const auto [rule, isNew] = known.emplace(d.code, rules.size());
    if (isNew) rules.push_back(ruleOf(d.code));
    results.push_back(resultOf(d, rule->second));
  }
  const Json run{{"tool", {{"driver", {{"name", "af2"}, {"rules", rules}}}}},
                 {"columnKind", "unicodeCodePoints"},
                 {"results", results}};
  const Json log{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({run})}};
  return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace af2::dsl
