// The contents of a picture of a rule, before it is drawn.
#pragma once

#include <string>
#include <vector>

#include "dsl/picture/rule_picture.h"

namespace af2::dsl::picture {

/// The free zone at one level.
struct Zone {
  int level;
  std::vector<Loop> loops;
};

/// A rule at one match.
struct Scene {
  const RuleSet& rules;
  const AF2Rule& rule;
  std::vector<Point2> placed;  ///< matched vertices, then the new vertices that have a value
  std::vector<Point2> references;
  std::vector<Loop> paths;  ///< for each reference that moves, its positions at the drawn levels
  std::vector<Zone> zones;
  std::vector<Loop> tolerances;
  std::vector<Point2> marks;
  std::string title, subtitle, note;
};

Scene sceneAtReference(const RuleSet& rules, const AF2Rule& rule, const PictureOptions& options);
Scene sceneAt(const RuleSet& rules, const AF2Rule& rule, const DrawnMatch& match,
              const PictureOptions& options);

/// The visible area: the whole pattern and the widest zone, and nearby tolerances only, because
/// tolerances may be very wide.
Box2 worldOf(const Scene& scene);

}  // namespace af2::dsl::picture
