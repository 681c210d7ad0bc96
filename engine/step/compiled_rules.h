// Rules prepared for the main loop: binding steps, coefficient tables by level, search windows.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "engine/rule/rule_set.h"
#include "engine/step/affine_batch.h"
#include "engine/step/rule_scoring.h"

namespace af2 {

/// The free zone of a rule in its fast form: a convex polygon with affine corners.
struct FastZone {
  /// One entry for all levels, or [level - 1], the last for all above.
  std::vector<AffineBatch> byLevel;
  /// The corners that are a and b at all levels and at which the front continues with an edge that
  /// the rule does not match; -1 otherwise.
  int cornerAtA = -1, cornerAtB = -1;
  const AffineBatch& at(int level) const {
    const auto last = byLevel.size() - 1;
    const auto index = static_cast<std::size_t>(level - 1);
    return byLevel[index < last ? index : last];
  }
};

/// How one pattern vertex is bound to a place of the front.
struct BindingStep {
  enum class Kind : std::uint8_t {
    Next,      ///< the place after that of `from`
    Previous,  ///< the place before that of `from`
    Closes,    ///< a check: the place after that of `from` is that of `vertex`
    Any,       ///< every matchable place in the window
    Near,      ///< every place within reach of a computed one
  };
  Kind kind = Kind::Next;
  std::int8_t vertex = 0;
  std::int8_t from = 0;
  Point2 reference;                         ///< reference position of the vertex
  ToleranceForm form;                       ///< 0 everywhere if any position will do
  const AF2PointTransform* near = nullptr;  ///< for Near: the computed place
  double reach = 0;                         ///< for Near: the largest distance from there

  bool fits(Point2 point, double tolerance) const {
    return form.allows(point - reference, tolerance);
  }
};

struct SlopeTest {
  std::int8_t from, to;
  Point2 reference;
  ToleranceForm form;

  bool fits(Point2 edge, double tolerance) const {
    return form.allows(edge - reference, tolerance);
  }
};

/// An axis-parallel window around the base edge, in chart units.
struct Window {
  double lowX = 0, lowY = 0, highX = 0, highY = 0;
  void include(double x, double y);
  void include(const Window& other);
  Window widened(double margin) const;
  bool contains(const Window& w) const {
    return lowX <= w.lowX && lowY <= w.lowY && highX >= w.highX && highY >= w.highY;
  }
};

/// What a match must satisfy at one level.
struct CompiledPattern {
  const AF2Rule* rule = nullptr;
  std::vector<BindingStep> steps;
  std::vector<SlopeTest> slopes;
};

struct CompiledRule {
  const AF2Rule* rule = nullptr;
  std::uint16_t index = 0;
  int firstLevel = 1, lastLevel = 1;
  int matchedCount = 2, newCount = 0;
  /// One entry for all levels, or [level - 1], the last for all above.
  std::vector<CompiledPattern> patterns;
  std::optional<AffineBatch> newPoints;  ///< the fast form, if all new points are affine
  std::optional<FastZone> zone;          ///< the fast form, if the zone has one
  /// The corners of a zone without a fast form, if they are vertices of the rule.
  std::span<const std::int8_t> zoneVertices;
  bool isPlain = false;  ///< no requirement and no cost: only geometry decides
  /// The free zone reaches so far that it has its own search, so that steps of other rules can look
  /// at a smaller window.
  bool isWide = false;
  /// Some of the new elements share only a vertex.
  bool touchesItself = false;

  const CompiledPattern& patternAt(int level) const {
    const auto last = patterns.size() - 1;
    const auto wanted = static_cast<std::size_t>(level - 1);
    return patterns[wanted < last ? wanted : last];
  }
};

/// A rule at one level, with its data for that level.
struct RuleAtLevel {
  const CompiledRule* rule = nullptr;
  const CompiledPattern* pattern = nullptr;
  const AffineBatch* zone = nullptr;  ///< of the fast form, if there is one
  /// No match has a lower score. -infinity for rules whose scores are computed fast.
  double leastScore = 0;
};

class CompiledRules {
 public:
  explicit CompiledRules(const RuleSet& rules);
  CompiledRules(const CompiledRules&) = delete;
  CompiledRules& operator=(const CompiledRules&) = delete;

  const RuleSet& set() const { return set_; }
  const RuleScoring& scoring() const { return scoring_; }
  const std::vector<CompiledRule>& rules() const { return rules_; }
  /// The rules that are used at a level, by their least scores; those with equal ones in order.
  const std::vector<RuleAtLevel>& rulesAt(int level) const { return byLevel_[indexOf(level)]; }
  /// The window that a step at this level searches first. It holds every place that a rule can
  /// match, and the free zones of typical matches; a zone that sticks out needs a second search.
  /// withWide  also the zones of wide rules
  Window windowAt(int level, double baseLength, bool withWide) const;

 private:
  std::size_t indexOf(int level) const {
    return static_cast<std::size_t>(std::clamp(level, 1, set_.maxLevel()) - 1);
  }
  void addRule(const AF2Rule& rule);
  void collectRules(int level);

  /// The windows of a level, by length of the base. Most fronts reach few of the levels, so each
  /// row is made by the first thread that asks for it.
  struct Windows {
    std::vector<Window> usual, withWide;
    std::once_flag once;
    std::atomic<bool> areMade = false;  ///< costs less to ask than `once`
  };
  void makeWindows(int level, Windows& windows) const;

  const RuleSet& set_;
  RuleScoring scoring_;
  std::vector<CompiledRule> rules_;
  std::vector<std::vector<RuleAtLevel>> byLevel_;  // [level - 1]
  mutable std::vector<Windows> windows_;           // [level - 1]
};

}  // namespace af2
