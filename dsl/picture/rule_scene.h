// What a picture of a rule shows, before it is drawn.
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
  std::vector<Point2> placed;  ///< matched vertices, then new ones as far as they have a value
  std::vector<Point2> references;
  std::vector<Loop> paths;  ///< of a reference that moves: where it is at each level drawn
  std::vector<Zone> zones;
  std::vector<Loop> tolerances;
  std::vector<Point2> marks;
  std::string title, subtitle, note;
};

Scene sceneAtReference(const RuleSet& rules, const AF2Rule& rule, const PictureOptions& options);
Scene sceneAt(const RuleSet& rules, const AF2Rule& rule, const DrawnMatch& match,
              const PictureOptions& options);

/// What has to be seen: all of the pattern and the widest zone; of tolerances those that are close,
/// for they may be very wide.
Box2 worldOf(const Scene& scene);

}  // namespace af2::dsl::picture
