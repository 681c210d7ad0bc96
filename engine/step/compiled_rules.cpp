#include "engine/step/compiled_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "engine/base/error.h"
#include "engine/rule/rule_at_match.h"

namespace af2 {
namespace {

constexpr double kEverywhere = 1e6;

/// Base lengths that have a window each; a step uses the first one not below its own length.
constexpr std::array<double, 8> kBaseLengths{0.5, 0.75, 1, 1.25, 1.5, 2, 3, 4};

// ---- binding steps -----------------------------------------------------------------------------

struct ChainWalk {
  const RuleDefinition& rule;
  int level;
  std::vector<BindingStep> steps;
  std::vector<bool> isBound;

  int successor(int v) const {
    for (const PatternEdge& e : rule.edges)
      if (e.from == v) return e.to;
    return -1;
  }
  int predecessor(int v) const {
    for (const PatternEdge& e : rule.edges)
      if (e.to == v) return e.from;
    return -1;
  }
  void bind(BindingStep::Kind kind, int vertex, int from) {
    const PatternVertex& wanted = rule.vertices[static_cast<std::size_t>(vertex)];
    steps.push_back({kind, static_cast<std::int8_t>(vertex), static_cast<std::int8_t>(from),
                     wanted.reference.at(level),
                     wanted.tolerance ? wanted.tolerance->at(level) : ToleranceForm{0, 0, 0}});
    if (wanted.near) {
      steps.back().near = wanted.near->place.get();
      steps.back().reach = wanted.near->reach.at(level);
    }
    isBound[static_cast<std::size_t>(vertex)] = true;
  }
  bool bound(int v) const { return isBound[static_cast<std::size_t>(v)]; }

  /// Binds the rest of v's chain, forwards and backwards.
  void follow(int v) {
    using Kind = BindingStep::Kind;
    int u = v;
    for (int w = successor(u); w >= 0; u = w, w = successor(u)) {
      if (bound(w)) {
        if (!(u == 0 && w == 1)) bind(Kind::Closes, w, u);
        return;  // a closed chain is complete
      }
      bind(Kind::Next, w, u);
    }
    u = v;
    for (int w = predecessor(u); w >= 0 && !bound(w); u = w, w = predecessor(u))
      bind(Kind::Previous, w, u);
  }
};

std::vector<BindingStep> bindingSteps(const RuleDefinition& rule, int level) {
  const std::size_t matched = rule.vertices.size();
  ChainWalk walk{rule, level, {}, std::vector<bool>(matched, false)};
  walk.isBound[0] = walk.isBound[1] = true;
  walk.follow(1);
  int u = 0;
  for (int w = walk.predecessor(0); w >= 0 && !walk.bound(w); u = w, w = walk.predecessor(u))
    walk.bind(BindingStep::Kind::Previous, w, u);
  for (int v = 2; v < static_cast<int>(matched); ++v) {
    if (walk.bound(v)) continue;
    const PatternVertex& vertex = rule.vertices[static_cast<std::size_t>(v)];
    if (!vertex.tolerance && !vertex.near)
      throw InputError("rule \"" + rule.name + "\": vertex " + vertex.name +
                       " may be anywhere; give it a tolerance, or join it to a or b by a chain");
    walk.bind(vertex.near ? BindingStep::Kind::Near : BindingStep::Kind::Any, v, -1);
    walk.follow(v);
  }
  return walk.steps;
}

std::vector<SlopeTest> slopeTests(const RuleDefinition& rule, int level) {
  std::vector<SlopeTest> tests;
  for (const PatternEdge& e : rule.edges) {
    if (!e.slope) continue;
    const auto at = [&](int v) {
      return rule.vertices[static_cast<std::size_t>(v)].reference.at(level);
    };
    tests.push_back({static_cast<std::int8_t>(e.from), static_cast<std::int8_t>(e.to),
                     at(e.to) - at(e.from), e.slope->at(level)});
  }
  return tests;
}

std::vector<CompiledPattern> patternsOf(const AF2Rule& whole) {
  const RuleDefinition& rule = whole.definition();
  int levels = 1;
  for (const PatternVertex& v : rule.vertices) {
    levels = std::max(levels, v.reference.levelCount());
    if (v.tolerance) levels = std::max(levels, v.tolerance->levelCount());
    if (v.near) levels = std::max(levels, v.near->reach.levelCount());
  }
  for (const PatternEdge& e : rule.edges)
    if (e.slope) levels = std::max(levels, e.slope->levelCount());
  std::vector<CompiledPattern> patterns;
  for (int level = 1; level <= levels; ++level)
    patterns.push_back({&whole, bindingSteps(rule, level), slopeTests(rule, level)});
  return patterns;
}

// ---- fast forms --------------------------------------------------------------------------------

const AffinePointTransform* asAffine(const std::shared_ptr<const AF2PointTransform>& transform,
                                     int matchedCount) {
  const auto* affine = dynamic_cast<const AffinePointTransform*>(transform.get());
  return affine && affine->vertexCount() <= matchedCount ? affine : nullptr;
}

std::optional<AffineBatch> fastNewPoints(const AF2Rule& rule) {
  AffineBatch batch;
  if (rule.newCount() > AffineBatch::kCapacity) return std::nullopt;
  for (const auto& transform : rule.definition().newVertices) {
    const auto* affine = asAffine(transform, rule.matchedCount());
    if (!affine) return std::nullopt;
    batch.add(*affine, rule.matchedCount());
  }
  return batch;
}

bool fadesAtAll(const ConvexPolygonZoneDef& def) {
  return std::any_of(def.corners().begin(), def.corners().end(),
                     [](const auto& corner) { return corner.limiting != nullptr; });
}

/// The corner of a zone that is a (0) or b (1) at all levels, or -1.
int cornerAtEnd(const FastZone& zone, int end) {
  const auto isThere = [&](const AffineBatch& batch, std::size_t k) {
    bool isSo = batch.constantX[k] == 0 && batch.constantY[k] == 0;
    for (std::size_t r = 0; r < batch.rows.size(); ++r) {
      const AffineBatch::Row& row = batch.rows[r];
      const double own = end == 1 && r == 0 ? 1 : 0;
      isSo = isSo && row.xx[k] == own && row.yy[k] == own && row.xy[k] == 0 && row.yx[k] == 0;
    }
    return isSo;
  };
  for (int k = 0; k < zone.byLevel[0].count; ++k)
    if (std::ranges::all_of(zone.byLevel, [&](const AffineBatch& batch) {
          return isThere(batch, static_cast<std::size_t>(k));
        }))
      return k;
  return -1;
}

std::optional<FastZone> fastZone(const AF2Rule& rule, int maxLevel) {
  const auto* def = dynamic_cast<const ConvexPolygonZoneDef*>(rule.definition().zone.get());
  if (!def || def->corners().size() > AffineBatch::kCapacity) return std::nullopt;
  FastZone zone;
  const int levels = fadesAtAll(*def) ? maxLevel : 1;
  for (int level = 1; level <= levels; ++level) {
    AffineBatch batch;
    for (const auto& corner : def->corners()) {
      const auto* preferred = asAffine(corner.preferred, rule.matchedCount());
      const auto* limiting =
          corner.limiting ? asAffine(corner.limiting, rule.matchedCount()) : preferred;
      if (!preferred || !limiting) return std::nullopt;
      batch.add(corner.limiting ? preferred->blend(*limiting, def->fade(level)) : *preferred,
                rule.matchedCount());
    }
    zone.byLevel.push_back(std::move(batch));
  }
  const auto& edges = rule.definition().edges;
  if (std::ranges::none_of(edges, [](const PatternEdge& e) { return e.to == 0; }))
    zone.cornerAtA = cornerAtEnd(zone, 0);
  if (std::ranges::none_of(edges, [](const PatternEdge& e) { return e.from == 1; }))
    zone.cornerAtB = cornerAtEnd(zone, 1);
  return zone;
}

// ---- windows -----------------------------------------------------------------------------------

/// Added on all sides of a window. It covers rounding of the base's chart position and bases
/// slightly longer than their bucket, so that zones that begin at the base need no extra search.
constexpr double kWindowMargin = 0.05;

/// Whether a walk from a to b visits a vertex twice.
bool passesTwice(const std::vector<std::int8_t>& walk) {
  std::set<int> seen{0, 1};
  return !std::ranges::all_of(walk, [&](int v) { return seen.insert(v).second; });
}

/// In wanted lengths, from the base edge to the farthest side of a zone's box. A rule that puts
/// elements beside its base alone reaches less far: one length for these elements and most of
/// another for those that will stand beside them. Longer windows make each step transform more of
/// the front. A zone that reaches farther is therefore left out of the windows of steps that other
/// rules take.
constexpr double kOrdinaryReach = 2;

/// How far the zone reaches from the base at the reference match of the rule's first level.
double zoneReach(const RuleDefinition& rule) {
  const RuleAtMatch reference = RuleAtMatch::atReference(rule, rule.firstLevel);
  const auto made = rule.zone->makeFreeZone(reference.binding());
  if (!made.zone) return 0;
  const Box2 box = made.zone->boundingBox();
  return std::max({-box.low.x, box.high.x - 1, -box.low.y, box.high.y});
}

/// Half extents of the ellipse form(d) <= tolerance.
Point2 ellipseExtent(const ToleranceForm& form, double tolerance) {
  const double det = form.xx * form.yy - 0.25 * form.xy * form.xy;
  if (!(det > 1e-12 * form.xx * form.yy) || !(form.xx > 0)) return {kEverywhere, kEverywhere};
  return {std::sqrt(tolerance * form.yy / det), std::sqrt(tolerance * form.xx / det)};
}

/// All positions that a free vertex of the rule can match. Other vertices are found along the
/// front.
Window matchWindow(const CompiledRule& rule, int level, double tolerance) {
  Window window;
  for (const BindingStep& step : rule.patternAt(level).steps) {
    if (step.kind != BindingStep::Kind::Any && step.kind != BindingStep::Kind::Near) continue;
    // A computed place is usually about as far from the base edge as it is at the reference.
    const Point2 extent =
        step.near ? Point2{step.reach, step.reach} : ellipseExtent(step.form, tolerance);
    window.include(step.reference.x - extent.x, step.reference.y - extent.y);
    window.include(step.reference.x + extent.x, step.reference.y + extent.y);
  }
  return window;
}

void includeZone(const CompiledRule& rule, int level, const std::vector<Point2>& matched,
                 Window& window) {
  if (rule.zone) {
    double x[AffineBatch::kCapacity], y[AffineBatch::kCapacity];
    const AffineBatch& corners = rule.zone->at(level);
    corners.evaluate(matched.data(), x, y);
    for (int k = 0; k < corners.count; ++k) window.include(x[k], y[k]);
    return;
  }
  const RuleDefinition& definition = rule.rule->definition();
  const auto made =
      definition.zone->makeFreeZone(RuleAtMatch(definition, matched, level).binding());
  if (!made.zone) return;
  const Box2 box = made.zone->boundingBox();
  window.include(std::max(box.low.x, -kEverywhere), std::max(box.low.y, -kEverywhere));
  window.include(std::min(box.high.x, kEverywhere), std::min(box.high.y, kEverywhere));
}

/// By length of the base: the extent of the zone when matched vertices deviate, to either side, by
/// half of the tolerance.
std::array<Window, kBaseLengths.size()> zoneWindows(const CompiledRule& rule, int level,
                                                    double tolerance) {
  std::array<Window, kBaseLengths.size()> windows;
  const RuleDefinition& definition = rule.rule->definition();
  std::vector<Point2> matched(definition.vertices.size());
  for (int corner = 0; corner < 4; ++corner) {
    for (std::size_t i = 2; i < matched.size(); ++i) {
      const PatternVertex& v = definition.vertices[i];
      const ToleranceForm form = v.tolerance ? v.tolerance->at(level) : ToleranceForm{};
      const Point2 extent = ellipseExtent(form, tolerance);
      const double dx = std::min(0.5 * extent.x, 1.0), dy = std::min(0.5 * extent.y, 1.0);
      matched[i] = v.reference.at(level) + Point2{corner & 1 ? dx : -dx, corner & 2 ? dy : -dy};
    }
    for (std::size_t b = 0; b < windows.size(); ++b) {
      matched[1] = {kBaseLengths[b], 0};
      includeZone(rule, level, matched, windows[b]);
    }
  }
  return windows;
}

}  // namespace

void Window::include(double x, double y) {
  lowX = std::min(lowX, x);
  lowY = std::min(lowY, y);
  highX = std::max(highX, x);
  highY = std::max(highY, y);
}

Window Window::widened(double margin) const {
  return {lowX - margin, lowY - margin, highX + margin, highY + margin};
}

void Window::include(const Window& other) {
  include(other.lowX, other.lowY);
  include(other.highX, other.highY);
}

CompiledRules::CompiledRules(const RuleSet& rules)
    : set_(rules),
      scoring_(rules.definition()),
      windows_(static_cast<std::size_t>(rules.maxLevel())) {
  rules_.reserve(rules.rules().size());
  for (const AF2Rule& rule : rules.rules()) addRule(rule);
  byLevel_.resize(static_cast<std::size_t>(rules.maxLevel()));
  for (int level = 1; level <= rules.maxLevel(); ++level) collectRules(level);
}

void CompiledRules::addRule(const AF2Rule& rule) {
  const RuleDefinition& definition = rule.definition();
  CompiledRule compiled;
  compiled.rule = &rule;
  compiled.index = static_cast<std::uint16_t>(rules_.size());
  compiled.firstLevel = definition.firstLevel;
  compiled.lastLevel = definition.lastLevel.value_or(std::numeric_limits<int>::max());
  compiled.matchedCount = rule.matchedCount();
  compiled.newCount = rule.newCount();
  compiled.patterns =
      definition.path ? std::vector(1, CompiledPattern{&rule, {}, {}}) : patternsOf(rule);
  compiled.newPoints = fastNewPoints(rule);
  compiled.zone = fastZone(rule, set_.maxLevel());
  const auto corners = definition.zone->cornerVertices();
  if (!compiled.zone && corners.size() <= AffineBatch::kCapacity) compiled.zoneVertices = corners;
  compiled.isWide = zoneReach(definition) > kOrdinaryReach;
  compiled.touchesItself = passesTwice(rule.replacement());
  compiled.isPlain = definition.requirements.empty() && !definition.cost;
  rules_.push_back(std::move(compiled));
}

void CompiledRules::collectRules(int level) {
  auto& atLevel = byLevel_[indexOf(level)];
  for (const CompiledRule& rule : rules_) {
    const RuleDefinition& definition = rule.rule->definition();
    if (level < rule.firstLevel || level > rule.lastLevel || definition.path) continue;
    const bool isFast = rule.isPlain && rule.newPoints;
    const double least = isFast ? -INFINITY : scoring_.leastScore(definition, level);
    atLevel.push_back(
        {&rule, &rule.patternAt(level), rule.zone ? &rule.zone->at(level) : nullptr, least});
  }
  std::ranges::stable_sort(atLevel, {}, &RuleAtLevel::leastScore);
}

void CompiledRules::makeWindows(int level, Windows& windows) const {
  const double tolerance = set_.matchTolerance(level);
  std::array<Window, kBaseLengths.size()> usual, wide;
  Window matched;
  for (const RuleAtLevel& at : rulesAt(level)) {
    matched.include(matchWindow(*at.rule, level, tolerance));
    const auto zones = zoneWindows(*at.rule, level, tolerance);
    for (std::size_t b = 0; b < zones.size(); ++b)
      (at.rule->isWide ? wide : usual)[b].include(zones[b]);
  }
  windows.usual.clear();  // where an earlier attempt failed
  windows.withWide.clear();
  for (std::size_t b = 0; b < kBaseLengths.size(); ++b) {
    usual[b].include(matched);
    wide[b].include(usual[b]);
    windows.usual.push_back(usual[b].widened(kWindowMargin));
    windows.withWide.push_back(wide[b].widened(kWindowMargin));
  }
}

Window CompiledRules::windowAt(int level, double baseLength, bool withWide) const {
  Windows& windows = windows_[indexOf(level)];
  if (!windows.areMade.load(std::memory_order_acquire))
    std::call_once(windows.once, [&] {
      makeWindows(std::clamp(level, 1, set_.maxLevel()), windows);
      windows.areMade.store(true, std::memory_order_release);
    });
  const std::vector<Window>& row = withWide ? windows.withWide : windows.usual;
  const auto bucket = std::lower_bound(kBaseLengths.begin(), kBaseLengths.end(), baseLength);
  if (bucket != kBaseLengths.end())
    return row[static_cast<std::size_t>(bucket - kBaseLengths.begin())];
  // For longer bases the window grows in proportion, which is more than needed.
  Window window = row.back();
  const double stretch = baseLength / kBaseLengths.back();
  window.include(stretch * window.lowX, stretch * window.lowY);
  window.include(stretch * window.highX, stretch * window.highY);
  return window;
}

}  // namespace af2
