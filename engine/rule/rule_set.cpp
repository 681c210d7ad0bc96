#include "engine/rule/rule_set.h"

#include <algorithm>
#include <limits>

#include "engine/base/error.h"

namespace af2 {
namespace {

[[noreturn]] void fail(const RuleSetDefinition& set, const std::string& what) {
  throw InputError("rule set \"" + set.name + "\": " + what);
}

bool makes(const std::vector<AF2Rule>& rules, int corners) {
  return std::any_of(rules.begin(), rules.end(), [&](const AF2Rule& rule) {
    const auto& elements = rule.definition().elements;
    return std::any_of(elements.begin(), elements.end(),
                       [&](const RuleElement& e) { return e.size() == corners; });
  });
}

}  // namespace

RuleSet::RuleSet(RuleSetDefinition definition) : definition_(std::move(definition)) {
  constexpr int kMaxLevels = 1000;  // tables are kept by level
  const RuleSetDefinition& d = definition_;
  if (d.rules.empty()) fail(d, "has no rules");
  if (d.rules.size() > std::numeric_limits<std::uint16_t>::max()) fail(d, "has too many rules");
  if (d.maxLevel < 1 || d.maxLevel > kMaxLevels)
    fail(d, "the quality levels must end between 1 and " + std::to_string(kMaxLevels));
  if (d.matchTolerance.size() != static_cast<std::size_t>(d.maxLevel))
    fail(d, "needs one match tolerance for each quality level");
  for (double t : d.matchTolerance)
    if (!(t >= 0 && t <= 1e6)) fail(d, "a match tolerance is not a number between 0 and 1e6");
  if (!d.clearance.empty() && d.clearance.size() != static_cast<std::size_t>(d.maxLevel))
    fail(d, "needs one clearance for each quality level, or none");
  if (!d.metric) fail(d, "has no element metric");
  if (!d.order) fail(d, "has no front order");
}

double RuleSet::matchTolerance(int level) const {
  return definition_
      .matchTolerance[static_cast<std::size_t>(std::clamp(level, 1, definition_.maxLevel) - 1)];
}

bool RuleSet::makesTriangles() const { return makes(definition_.rules, 3); }
bool RuleSet::makesQuads() const { return makes(definition_.rules, 4); }

}  // namespace af2
