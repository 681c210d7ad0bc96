// Evaluates one rule at given positions, for `af2 eval`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/rule/refusal.h"
#include "engine/rule/rule_at_match.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// Positions are in the frame of the base edge: a at the origin, b on the x axis.
struct EvalRequest {
  std::string rule;  ///< title
  int level = 1;
  std::map<std::string, Point2> match;  ///< by vertex; others are at their references
  std::vector<Point2> points;
  std::vector<std::pair<Point2, Point2>> segments;
  std::map<std::string, double> environment;  ///< see GivenMatch
};

/// What a rule determines beside new vertices and elements.
struct EvaluatedActs {
  /// A vertex that is looked for around a computed place.
  struct Near {
    std::string vertex;
    std::optional<Point2> place;  ///< no value where the expression has none
    double reach = 0;             ///< how far from the place the vertex may be
    std::optional<double> away;   ///< how far it is
  };
  struct Weld {
    std::string from, into;       ///< `into` remains
    std::optional<Point2> place;  ///< where it is then
  };
  struct Path {
    std::string from, to;
    std::optional<double> segments;  ///< as the rule asks; the front takes the nearest even number
  };
  std::vector<Near> near;
  std::optional<Weld> weld;
  std::optional<Path> path;
};

struct EvalResult {
  Refusal refused = Refusal::None;  ///< the first reason; ignores the rest of the front
  RefusalCause cause;               ///< the numbers of the refusal
  std::string because;              ///< a sentence with the numbers of the refusal; may be empty
  bool matches = false;
  bool requireHolds = false;
  std::vector<std::pair<std::string, std::optional<Point2>>> newVertices;
  EvaluatedActs acts;
  std::vector<std::vector<Point2>> zones;  ///< corners; for curved zones an outline
  std::vector<bool> pointsInZone;          ///< whether the closed zone contains the point
  std::vector<bool> segmentsMeetZone;      ///< whether the segment meets the interior
  std::optional<double> score;
};

/// The rule with this title. Throws InputError if there is none.
AF2_EXPORT const AF2Rule& findRule(const RuleSet& rules, const std::string& title);

/// Positions in pattern order. Vertices that are not given are at their reference at this level.
/// Throws InputError on a vertex that the rule does not match, or a number that is not finite.
AF2_EXPORT std::vector<Point2> matchedPositions(const RuleDefinition& rule,
                                                const std::map<std::string, Point2>& match,
                                                int level);

/// Throws InputError on an unknown rule or vertex, a level out of range, or a number that is not
/// finite.
AF2_EXPORT EvalResult evaluateRule(const RuleSet& rules, const EvalRequest& request);

/// {"refused", "because", "matches", "require", "near", "new", "weld", "path", "zones",
/// "points_in_zone", "segments_meet_zone", "score"}; "near", "weld" and "path" only of rules that
/// have them
AF2_EXPORT std::string toJson(const EvalResult& result);
AF2_EXPORT std::string toText(const EvalResult& result);

}  // namespace af2::dsl
