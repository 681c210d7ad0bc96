// The page of a comparison: the table, and the meshes side by side.
#include <fmt/core.h>

#include "cli/compare/comparison_text.h"
#include "geometry/io/formats.h"
#include "geometry/io/output_file.h"

namespace af2::cli {
namespace {

constexpr const char* kStyle = R"(
body { font: 15px/1.45 "DejaVu Sans", system-ui, sans-serif; color: #1f2933; margin: 2em auto; max-width: 1200px; padding: 0 1em; }
table { border-collapse: collapse; margin: 1em 0 2em; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2em 0.9em; text-align: right; border-bottom: 1px solid #d9e0e6; }
th:first-child, td:first-child, td:last-child, th:last-child { text-align: left; }
.better { color: #1b6b3a; font-weight: bold; } .worse { color: #b3261e; font-weight: bold; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1.5em; margin-bottom: 2em; }
.pair svg { width: 100%; height: auto; } figure { margin: 0; } figcaption { margin-bottom: 0.4em; }
)";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

std::string_view meaningOf(std::string_view name) {
  for (const ComparedMeasure& measure : comparedMeasures())
    if (measure.name == name) return measure.meaning;
  return "";
}

void writeTable(const ComparisonReport& report, MeshStage stage, geometry::OutputFile& file) {
  file.text(
      fmt::format("<h2>{} meshes</h2>\n<table><tr><th>measure</th><th>models</th><th>A</th>"
                  "<th>B</th><th>B - A</th><th>95 % interval</th><th>B is</th></tr>\n",
                  stage == MeshStage::Raw ? "Raw" : "Finished"));
  for (const MeasureComparison& row : report.rows) {
    if (row.stage != stage) continue;
    const auto number = [](std::size_t count, double value) {
      return count > 0 ? fmt::format("{:.4g}", value) : std::string("-");
    };
    file.text(fmt::format("<tr><td title=\"{}\">{}</td><td>{}</td><td>{}</td><td>{}</td>",
                          escaped(meaningOf(row.name)), row.name, row.pairs,
                          number(row.firstCount, row.first), number(row.secondCount, row.second)));
    if (row.pairs > 0)
      file.text(fmt::format("<td>{:+.3g}</td><td>{:+.3g} to {:+.3g}</td><td class=\"{}\">{}</td>",
                            row.difference, row.low, row.high, toString(row.verdict),
                            toString(row.verdict)));
    else
      file.text("<td></td><td></td><td></td>");
    file.text("</tr>\n");
  }
  file.text("</table>\n");
}

void writeFigure(const std::string& set, const CaseResult& result, geometry::OutputFile& file) {
  file.text("<figure><figcaption>" + escaped(set) + "</figcaption>");
  if (result.drawn)
    geometry::writeSvg(*result.drawn, {}, file);
  else
    file.text("<p>no mesh" + (result.fault.empty() ? "" : ": " + escaped(result.fault)) + "</p>");
  file.text("</figure>\n");
}

void writePictures(const ComparisonReport& report, geometry::OutputFile& file) {
  for (std::size_t i = 0; i < report.result.cases.size(); ++i)
    for (std::size_t stage = 0; stage < kMeshStages.size(); ++stage) {
      const auto& sets = report.result.cases[i][stage];
      if (!sets[kFirstSet].drawn && !sets[kSecondSet].drawn) continue;
      file.text(fmt::format("<h3>{}, {}</h3>\n<div class=\"pair\">",
                            escaped(report.result.names[i]), toString(kMeshStages[stage])));
      writeFigure("A: " + report.first, sets[kFirstSet], file);
      writeFigure("B: " + report.second, sets[kSecondSet], file);
      file.text("</div>\n");
    }
}

}  // namespace

void writeComparisonPage(const ComparisonReport& report, const std::filesystem::path& path) {
  geometry::OutputFile file(path);
  file.text(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<title>Comparison of two rule sets</title>\n<style>");
  file.text(kStyle);
  file.text(
      fmt::format("</style></head>\n<body><h1>Comparison of two rule sets</h1>\n<p>A: {}<br>B: {}"
                  "<br>{} models</p>\n",
                  escaped(report.first), escaped(report.second), report.result.cases.size()));
  for (const MeshStage stage : kMeshStages) writeTable(report, stage, file);
  for (const std::string& note : report.notes) file.text("<p>Note: " + escaped(note) + "</p>\n");
  writePictures(report, file);
  file.text("</body></html>\n");
  file.commit();
}

}  // namespace af2::cli
