// Pictures of rules: pattern, tolerances, free zone by level, new elements and new front.
#pragma once

#include <string>
#include <vector>

#include "dsl/picture/canvas.h"
#include "engine/base/export.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

struct PictureOptions {
  double width = 420, height = 400;  ///< of one rule, in pixels
  /// The quality levels whose zones are shown; if empty, the first level of the rule, twice and
  /// four times that level, and the last level.
  std::vector<int> levels = {};
  bool names = true;
  bool tolerances = true;
};

/// A rule at its reference match. Returns the bytes of the file.
AF2_EXPORT std::string drawRule(const RuleSet& rules, const AF2Rule& rule, PictureFormat format,
                                const PictureOptions& options = {});

/// All rules of a set on one sheet, with a legend.
std::string drawRuleSet(const RuleSet& rules, PictureFormat format,
                        const PictureOptions& options = {.width = 300, .height = 300});

/// One match of a rule, as in a finding.
struct DrawnMatch {
  std::vector<Point2> vertices;  ///< the matched ones in pattern order
  int level = 1;
  std::vector<Point2> marks;  ///< places of faults, each drawn as a red cross
  std::string note;           ///< below the picture
};

AF2_EXPORT std::string drawMatch(const RuleSet& rules, const AF2Rule& rule, const DrawnMatch& match,
                                 PictureFormat format, const PictureOptions& options = {});

}  // namespace af2::dsl
