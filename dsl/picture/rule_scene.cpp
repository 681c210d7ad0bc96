#include "dsl/picture/rule_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dsl/match/pattern_match.h"
#include "dsl/shapes/shape.h"
#include "engine/base/elementary.h"

namespace af2::dsl::picture {
namespace {

/// Points on w(x - centre) = tolerance; axes longer than `longest` are shortened to it.
Loop ellipse(const ToleranceForm& w, Point2 centre, double tolerance, double longest) {
  const double mean = 0.5 * (w.xx + w.yy), half = 0.5 * (w.xx - w.yy);
  const double spread = std::sqrt(half * half + 0.25 * w.xy * w.xy);
  const double angle =
      0.5 * af2::angleOf({w.xx - w.yy, w.xy});  // of the axis with the larger weight
  const auto axis = [&](double strength) {
    return strength * longest * longest > tolerance ? std::sqrt(tolerance / strength) : longest;
  };
  const double p = axis(mean + spread), q = axis(mean - spread);
  const Point2 u = af2::directionAt(angle);
  Loop loop;
  constexpr int kCorners = 72;
  for (int i = 0; i < kCorners; ++i) {
    const double t = 2 * M_PI * i / kCorners, x = p * af2::cosine(t), y = q * af2::sine(t);
    loop.push_back(centre + Point2{x * u.x - y * u.y, x * u.y + y * u.x});
  }
  return loop;
}

std::vector<Loop> toleranceLoops(const RuleSet& rules, const AF2Rule& rule, int level) {
  constexpr double kLongest = 6;
  std::vector<Loop> loops;
  const double tolerance = rules.matchTolerance(std::min(level, rules.maxLevel()));
  for (std::size_t i = 2; i < rule.definition().vertices.size(); ++i) {
    const PatternVertex& vertex = rule.definition().vertices[i];
    if (vertex.tolerance)
      loops.push_back(
          ellipse(vertex.tolerance->at(level), vertex.reference.at(level), tolerance, kLongest));
  }
  return loops;
}

std::vector<Loop> pathsOf(const RuleDefinition& rule, const std::vector<int>& levels) {
  std::vector<Loop> paths;
  for (std::size_t i = 2; i < rule.vertices.size(); ++i) {
    Loop path;
    for (const int level : levels) {
      const Point2 p = rule.vertices[i].reference.at(level);
      if (path.empty() || p != path.back()) path.push_back(p);
    }
    if (path.size() > 1) paths.push_back(std::move(path));
  }
  return paths;
}

std::vector<int> levelsOf(const RuleSet& rules, const AF2Rule& rule,
                          const PictureOptions& options) {
  if (!options.levels.empty()) return options.levels;
  const int first = rule.definition().firstLevel;
  const int last =
      std::min(rule.definition().lastLevel.value_or(rules.maxLevel()), rules.maxLevel());
  std::vector<int> levels{first};
  for (const int level : {2 * first, 4 * first, last})
    if (level > levels.back() && level <= last) levels.push_back(level);
  return levels;
}

/// The zones of a match at several levels, without those equal to the previous one.
std::vector<Zone> zonesOf(const AF2Rule& rule, const std::vector<Point2>& vertices,
                          const std::vector<int>& levels, std::string& note) {
  std::vector<Zone> zones;
  for (const int level : levels) {
    const PatternMatch match(rule, vertices, level);
    const auto made = rule.definition().zone->makeFreeZone(match.binding());
    if (!made.zone) {
      if (zones.empty()) note = fmt::format("no zone here: {}", toString(made.refusal));
      continue;
    }
    auto loops = outline(*made.zone);
    if (zones.empty() || zones.back().loops != loops) zones.push_back({level, std::move(loops)});
  }
  return zones;
}

std::string levelText(const RuleDefinition& rule) {
  if (!rule.lastLevel) return fmt::format("quality {}", rule.firstLevel);
  return fmt::format("quality {}..{}", rule.firstLevel, *rule.lastLevel);
}

std::string sourceText(const RuleDefinition& rule) {
  const std::string mirrored = rule.source.mirrored ? ", mirrored" : "";
  if (rule.source.file.empty()) return levelText(rule) + mirrored;
  const std::string file = rule.source.file.substr(rule.source.file.find_last_of('/') + 1);
  return fmt::format("{}{}  \u00b7  {}:{}", levelText(rule), mirrored, file, rule.source.line);
}

Scene sceneOf(const RuleSet& rules, const AF2Rule& rule, std::vector<Point2> vertices,
              const std::vector<int>& levels, const PictureOptions& options) {
  Scene scene{rules, rule, {}, {}, {}, {}, {}, {}, rule.name(), sourceText(rule.definition()), ""};
  const PatternMatch match(rule, std::move(vertices), levels.front());
  scene.placed = match.placeAll().value_or(match.vertices());
  scene.references = PatternMatch::atReference(rule, levels.front()).vertices();
  scene.paths = pathsOf(rule.definition(), levels);
  scene.zones = zonesOf(rule, match.vertices(), levels, scene.note);
  if (options.tolerances) scene.tolerances = toleranceLoops(rules, rule, levels.front());
  return scene;
}

void include(Box2& box, Point2 p, double margin = 0) {
  box.low = {std::min(box.low.x, p.x - margin), std::min(box.low.y, p.y - margin)};
  box.high = {std::max(box.high.x, p.x + margin), std::max(box.high.y, p.y + margin)};
}

}  // namespace

Scene sceneAtReference(const RuleSet& rules, const AF2Rule& rule, const PictureOptions& options) {
  const auto levels = levelsOf(rules, rule, options);
  return sceneOf(rules, rule, PatternMatch::atReference(rule, levels.front()).vertices(), levels,
                 options);
}

Scene sceneAt(const RuleSet& rules, const AF2Rule& rule, const DrawnMatch& match,
              const PictureOptions& options) {
  Scene scene = sceneOf(rules, rule, match.vertices, {match.level}, options);
  scene.marks = match.marks;
  scene.subtitle += fmt::format("  \u00b7  at level {}", match.level);
  if (!match.note.empty()) scene.note = match.note;
  return scene;
}

Box2 worldOf(const Scene& scene) {
  constexpr double kClose = 1.25;
  Box2 world{scene.placed[0], scene.placed[0]};
  for (const Point2 p : scene.placed) include(world, p, 0.12);
  for (const Loop& path : scene.paths)
    for (const Point2 p : path) include(world, p, 0.05);
  for (const Loop& loop : scene.tolerances) {
    const auto isFar = [&](Point2 p) {
      return std::all_of(scene.references.begin() + 2, scene.references.end(),
                         [p](Point2 q) { return distance(p, q) > kClose; });
    };
    if (std::none_of(loop.begin(), loop.end(), isFar))
      for (const Point2 p : loop) include(world, p);
  }
  for (const Zone& zone : scene.zones)
    for (const Loop& loop : zone.loops)
      for (const Point2 p : loop) include(world, p);
  for (const Point2 p : scene.marks) include(world, p, 0.1);
  return world;
}

}  // namespace af2::dsl::picture
