#include "dsl/compile/ideal_score.h"

#include <cmath>
#include <string>

namespace af2::dsl {

void checkIdealScore(CompileContext& context, const Expr& score, const Module& home, int corners,
                     int maxLevel, const ScoreAtLevel& scoreAt) {
  const std::vector<Point2> ideal =
      corners == 3 ? std::vector<Point2>{{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}}
                   : std::vector<Point2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int level = 1; level <= maxLevel; ++level) {
    const std::optional<double> at = scoreAt(ideal, level);
    if (at && std::isfinite(*at)) continue;
    const char* element = corners == 3 ? "the triangle with sides of 1" : "the unit square";
    return context.tell(
        home, Code::NoValue, score.span,
        std::string("the score of ") + element + " has no value at level " + std::to_string(level),
        "a rule is refused where one of its elements has no score", {}, Severity::Warning);
  }
}

}  // namespace af2::dsl
