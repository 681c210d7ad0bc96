// The chart of one step as text, for the page of a trace.
#pragma once

#include <span>
#include <string>

#include "engine/rule/rule_set.h"
#include "engine/step/observer.h"

namespace af2::cli {

/// A step, as an observer of the run received it.
struct ObservedStep {
  const StepReport& report;
  const LocalFront& around;
  std::span<const RuleRefusal> refusals;
  std::span<const Element> made;  ///< the elements of the rule that was applied
};

/// One line of JSON, with positions in the frame of the base edge:
///
/// {"v": [[id, x, y], ...],     the vertices of the front around the base edge
///  "c": [[vertex, ...], ...],  its chains
///  "i": [vertex, ...],         its isolated vertices
///  "b": [from, to],            the base edge
///  "s": size,
///  "r": [[rule, reason, matches, score, matched, zones, new, cause, hit], ...]}
///
/// Vertices are indices in "v". Each rule that was tried has an entry in "r": `reason` is the value
/// of Refusal, 0 for the rule that was applied; `matched` are the vertices of the match that came
/// farthest, or that the pattern most likely means; `zones` are outlines [x, y, x, y, ...], `new`
/// the new vertices [x, y] or null, `cause` [index, is edge, value, limit], and `hit` what hit the
/// zone. What is missing is null, or left out at the end.
std::string stepChart(const RuleSet& rules, const ObservedStep& step);

}  // namespace af2::cli
