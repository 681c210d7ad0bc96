// Positions and values as they are typed on the command line: "c=0.5,0.9".
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/rule/rule_set.h"

namespace af2::cli {

/// "x,y". This and the following functions throw UsageError, which names `option`.
Point2 parsePoint(const std::string& option, const std::string& text);

/// "x,y,z"
Point3 parsePoint3(const std::string& option, const std::string& text);

/// "x,y,x,y"
std::pair<Point2, Point2> parseSegment(const std::string& option, const std::string& text);

/// Parses items such as "c=0.5,0.9".
std::map<std::string, Point2> parseMatch(const std::string& option,
                                         const std::vector<std::string>& texts);

/// Parses items such as "h=0.8" or "turn(c)=90".
std::map<std::string, double> parseValues(const std::string& option,
                                          const std::vector<std::string>& texts);

/// The rule with this title.
const AF2Rule& findRule(const RuleSet& rules, const std::string& title);

/// Positions in pattern order; vertices that are not given are at their reference positions for
/// this level.
std::vector<Point2> matchedVertices(const AF2Rule& rule, const std::map<std::string, Point2>& given,
                                    int level);

}  // namespace af2::cli
