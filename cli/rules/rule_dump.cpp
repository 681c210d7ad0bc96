#include "cli/rules/rule_dump.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "cli/rules/program_text.h"
#include "dsl/program/shape_program.h"
#include "dsl/text/keywords.h"

namespace af2::cli {
namespace {

constexpr int kIndent = 6;

class RuleDump {
 public:
  explicit RuleDump(const AF2Rule& rule) : rule_(rule), definition_(rule.definition()) {
    for (const PatternVertex& vertex : definition_.vertices) matched_.push_back(vertex.name);
  }

  std::string text() const {
    std::string out = head() + vertices();
    out += "  consumed  " + edges(rule_.consumedEdges());
    out += "  new edges " + edges(rule_.newEdges());
    out += newVertices() + zone() + elements() + conditions();
    return out;
  }

 private:
  std::string head() const {
    const RuleSource& source = definition_.source;
    const std::string file = std::filesystem::path(source.file).filename().string();
    const std::string last =
        definition_.lastLevel ? fmt::format("..{}", *definition_.lastLevel) : " and above";
    return fmt::format("rule \"{}\"  ({}:{}{})\n  level     {}{}\n", definition_.name, file,
                       source.line, source.mirrored ? ", mirrored" : "", definition_.firstLevel,
                       last);
  }

  std::string name(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return v < matched_.size() ? matched_[v] : definition_.newVertexNames[v - matched_.size()];
  }

  static std::string formText(const ToleranceForm& form) {
    return fmt::format("{} dx2 + {} dx dy + {} dy2", numberText(form.xx), numberText(form.xy),
                       numberText(form.yy));
  }

  static std::string pointText(const Point2& p) {
    return fmt::format("({}, {})", numberText(p.x), numberText(p.y));
  }

  /// One value, or the values at the first and the last level if they differ.
  template <class T, class Text>
  std::string byLevel(const ByLevel<T>& value, const Text& textOf) const {
    const int first = definition_.firstLevel, last = std::max(first, value.levelCount());
    const std::string text = textOf(value.at(first));
    if (value.levelCount() == 1) return text;
    return fmt::format("{} at level {}, {} at level {}", text, first, textOf(value.at(last)), last);
  }

  std::string tolerance(const std::optional<ToleranceByLevel>& form) const {
    return form ? byLevel(*form, formText) : "any";
  }

  std::string vertices() const {
    std::string out;
    for (std::size_t i = 2; i < definition_.vertices.size(); ++i) {
      const PatternVertex& vertex = definition_.vertices[i];
      out += fmt::format("  match     {} {}  tolerance {}\n", vertex.name,
                         byLevel(vertex.reference, pointText), tolerance(vertex.tolerance));
    }
    for (const PatternEdge& edge : definition_.edges) {
      out += fmt::format("  edge      {}->{}", name(edge.from), name(edge.to));
      if (edge.slope) out += "  slope " + tolerance(edge.slope);
      out += "\n";
    }
    return out;
  }

  std::string edges(const std::vector<PatternEdge>& list) const {
    std::string out;
    for (const PatternEdge& edge : list) {
      out += (out.empty() ? "" : ", ") + name(edge.from) + "->" + name(edge.to);
    }
    return (out.empty() ? "none" : out) + "\n";
  }

  std::string newVertices() const {
    std::string out;
    for (std::size_t i = 0; i < definition_.newVertices.size(); ++i) {
      out += fmt::format("  new       {}: {}", definition_.newVertexNames[i],
                         transformText(*definition_.newVertices[i], matched_, kIndent));
    }
    return out;
  }

  std::string zone() const {
    if (const auto* list = dynamic_cast<const ConvexPolygonZoneDef*>(definition_.zone.get())) {
      return corners(*list);
    }
    if (const auto* shapes = dynamic_cast<const dsl::ShapeZoneDef*>(definition_.zone.get())) {
      const std::size_t count = shapes->alternatives().size();
      return fmt::format("  zone      shape, {} alternative{}\n", count, count == 1 ? "" : "s");
    }
    return "  zone      a custom shape\n";
  }

  std::string corners(const ConvexPolygonZoneDef& zone) const {
    std::string out = fmt::format("  zone      convex, {} corners\n", zone.corners().size());
    for (const ConvexPolygonZoneDef::Corner& corner : zone.corners()) {
      out += "    corner  " + transformText(*corner.preferred, matched_, kIndent);
      if (corner.limiting) out += "      => " + transformText(*corner.limiting, matched_, kIndent);
    }
    return out;
  }

  std::string elements() const {
    std::string out;
    for (const RuleElement& element : definition_.elements) {
      out += element.size() == 3 ? "  tri      " : "  quad     ";
      for (int c = 0; c < element.size(); ++c) {
        out += " " + name(element.corners[static_cast<std::size_t>(c)]);
      }
      out += "\n";
    }
    return out;
  }

  std::string conditions() const {
    std::string out;
    for (const auto& condition : definition_.requirements) {
      out += "  require   " + functionText(*condition, matched_, kIndent);
    }
    if (definition_.cost)
      out += "  cost      " + functionText(*definition_.cost, matched_, kIndent);
    if (definition_.priority != 0) out += fmt::format("  priority  {}\n", definition_.priority);
    return out;
  }

  const AF2Rule& rule_;
  const RuleDefinition& definition_;
  VertexNames matched_;
};

std::string settingsText(const RuleSet& rules) {
  const RuleSetDefinition& set = rules.definition();
  std::string out =
      fmt::format("ruleset \"{}\"\n  levels    1..{}\n  match    ", set.name, set.maxLevel);
  const int shown = std::min(set.maxLevel, 5);
  for (int level = 1; level <= shown; ++level) {
    out += fmt::format(" {}: {},", level, numberText(rules.matchTolerance(level)));
  }
  out +=
      fmt::format(" ..., {}: {}\n", set.maxLevel, numberText(rules.matchTolerance(set.maxLevel)));
  out += fmt::format("  unit      {}\n", set.unit == ChartUnit::BaseLength ? "base" : "h");
  out += fmt::format("  parity    {}\n", set.parity == Parity::Even ? "even" : "any");
  out += fmt::format("  finish    {}\n", dsl::kFinishes.at(static_cast<std::size_t>(set.finish)));
  return out;
}

}  // namespace

std::string dumpText(const RuleSet& rules, const std::string& rule) {
  std::string out = settingsText(rules);
  for (const AF2Rule& one : rules.rules()) {
    if (rule.empty() || one.name() == rule) out += "\n" + RuleDump(one).text();
  }
  return out;
}

}  // namespace af2::cli
