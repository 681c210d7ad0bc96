#include "dsl/proof/changed_rules.h"

#include <algorithm>
#include <utility>

#include "dsl/program/shape_program.h"
#include "dsl/shapes/shape.h"

namespace af2::dsl {
namespace {

class LowCost final : public AF2BindingFunction {
 public:
  std::optional<double> evaluate(const AF2Binding&) const override { return -1e6; }
};

/// The zone of an earlier level, as if it did not grow.
class KeptZone final : public AF2FreeZoneDef {
 public:
  KeptZone(std::shared_ptr<const AF2FreeZoneDef> zone, int level)
      : zone_(std::move(zone)), level_(level) {}
  Made makeFreeZone(const AF2Binding& binding) const override {
    return zone_->makeFreeZone(
        {binding.vertices, std::min(binding.level, level_), binding.surroundings});
  }

 private:
  std::shared_ptr<const AF2FreeZoneDef> zone_;
  int level_;
};

/// A list of corners as a path, which need not be convex.
class PathZone final : public AF2FreeZoneDef {
 public:
  explicit PathZone(std::shared_ptr<const AF2FreeZoneDef> zone) : zone_(std::move(zone)) {}
  Made makeFreeZone(const AF2Binding& binding) const override {
    Made made = zone_->makeFreeZone(binding);
    const auto corners = made.refusal == Refusal::Convexity ? cornersAt(binding) : std::nullopt;
    if (!corners) return made;
    std::vector<PathStep> path;
    for (const Point2 corner : *corners) path.push_back({corner, std::nullopt});
    MadeZone whole = makeZone(Shape::poly(std::move(path)));
    return {std::move(whole.zone), whole.refusal};
  }

 private:
  std::optional<std::vector<Point2>> cornersAt(const AF2Binding& binding) const {
    if (const auto* list = dynamic_cast<const ConvexPolygonZoneDef*>(zone_.get()))
      return list->cornersAt(binding);
    const auto* shapes = dynamic_cast<const ShapeZoneDef*>(zone_.get());
    const auto shape = shapes ? shapes->shapeAt(binding) : std::nullopt;
    if (!shape || shape->kind() != ShapeKind::Convex) return std::nullopt;
    return std::vector<Point2>(shape->points().begin(), shape->points().end());
  }

  std::shared_ptr<const AF2FreeZoneDef> zone_;
};

}  // namespace

ChangedRules::ChangedRules(RuleSetDefinition definition, std::size_t index)
    : rules_(std::make_unique<const RuleSet>(std::move(definition))),
      stepper_(std::make_unique<SingleStepper>(*rules_)),
      index_(index) {}

ChangedRules ChangedRules::replacing(const RuleSet& rules, std::size_t rule, RuleDefinition by) {
  RuleSetDefinition definition = rules.definition();
  definition.rules[rule] = AF2Rule(std::move(by));
  return ChangedRules(std::move(definition), rule);
}

ChangedRules ChangedRules::adding(const RuleSet& rules, std::size_t behind,
                                  RuleDefinition further) {
  RuleSetDefinition definition = rules.definition();
  further.name += " (added)";  // titles are unique
  const auto at = definition.rules.begin() + static_cast<std::ptrdiff_t>(behind) + 1;
  definition.rules.insert(at, AF2Rule(std::move(further)));
  return ChangedRules(std::move(definition), behind + 1);
}

RuleDefinition atLowCost(RuleDefinition rule) {
  rule.cost = std::make_shared<LowCost>();
  return rule;
}

RuleDefinition withZoneKept(RuleDefinition rule, int level) {
  rule.zone = std::make_shared<KeptZone>(std::move(rule.zone), level);
  return rule;
}

RuleDefinition withPathAsZone(RuleDefinition rule) {
  rule.zone = std::make_shared<PathZone>(std::move(rule.zone));
  return rule;
}

}  // namespace af2::dsl
