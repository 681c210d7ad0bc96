#include "dsl/program/known_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dsl/program/steps.h"

namespace af2::dsl {
namespace {

using Kind = KnownValue::Kind;

KnownValue numberOrNone(double value) {
  return std::isnan(value) ? KnownValue{Kind::None} : KnownValue{Kind::Number, value};
}

/// The value of one step, computed from those of earlier steps.
class OneStep {
 public:
  OneStep(const std::vector<KnownValue>& values, int level) : values_(values), level_(level) {}

  KnownValue valueOf(const Step& step) const {
    switch (step.op) {
      case Op::Constant:
        return numberOrNone(step.constant);
      case Op::Level:
        return {Kind::Number, static_cast<double>(level_)};
      case Op::And:
        return logical(step, [](const KnownValue& v) { return v.isFalse(); });
      case Op::Or:
        return logical(step, [](const KnownValue& v) { return v.isTrue(); });
      case Op::Select:
        return selected(step);
      case Op::Divide:
        if (at(step, 1).isFalse()) return {Kind::None};
        break;
      case Op::Power:
        if (at(step, 1).isFalse()) return {};  // anything to the power of 0 is 1
        break;
      default:
        break;
    }
    return usual(step);
  }

 private:
  /// One operand that decides the result is sufficient; otherwise both must have a value.
  template <class Decides>
  KnownValue logical(const Step& step, const Decides& decides) const {
    for (std::size_t i = 0; i < 2; ++i)
      if (decides(at(step, i))) return at(step, i);
    for (std::size_t i = 0; i < 2; ++i)
      if (at(step, i).isNone())
        return at(step, 1 - i).kind == Kind::Open ? KnownValue{} : KnownValue{Kind::None};
    return usual(step);
  }

  KnownValue selected(const Step& step) const {
    const KnownValue& condition = at(step, 0);
    if (condition.isNone()) return condition;
    if (condition.kind == Kind::Number) return at(step, condition.isTrue() ? 1 : 2);
    return at(step, 1).isNone() && at(step, 2).isNone() ? KnownValue{Kind::None} : KnownValue{};
  }

  KnownValue usual(const Step& step) const {
    std::array<double, Step::kMaxArguments> numbers{};
    Step folded = step;
    bool isKnown = isArithmetic(step.op);
    for (std::size_t i = 0; i < step.arguments.size(); ++i) {
      if (step.arguments[i] < 0) continue;
      const KnownValue& value = at(step, i);
      if (value.isNone()) return value;
      isKnown = isKnown && value.kind == Kind::Number;
      numbers[i] = value.number;
      folded.arguments[i] = static_cast<Node>(i);
    }
    return isKnown ? numberOrNone(evaluateStep(folded, numbers)) : KnownValue{};
  }

  const KnownValue& at(const Step& step, std::size_t i) const {
    return values_[static_cast<std::size_t>(step.arguments[i])];
  }

  const std::vector<KnownValue>& values_;
  int level_;
};

}  // namespace

KnownResults::KnownResults(const Program& program, int level)
    : program_(program), level_(level), isForgotten_(program.stepCount()) {
  follow();
}

void KnownResults::follow() {
  values_.clear();
  for (const Step& step : program_.steps()) {
    const bool isForgotten = isForgotten_[values_.size()];
    values_.push_back(isForgotten ? KnownValue{} : OneStep(values_, level_).valueOf(step));
  }
}

const KnownValue& KnownResults::operator[](std::size_t result) const {
  return values_[static_cast<std::size_t>(program_.results()[result])];
}

void KnownResults::forget(std::size_t result) {
  std::vector<bool> isNeeded(program_.stepCount());
  isNeeded[static_cast<std::size_t>(program_.results()[result])] = true;
  for (std::size_t i = isNeeded.size(); i-- > 0;) {
    if (!isNeeded[i]) continue;
    isForgotten_[i] = isForgotten_[i] || values_[i].isNone();
    for (const Node argument : program_.steps()[i].arguments)
      if (argument >= 0) isNeeded[static_cast<std::size_t>(argument)] = true;
  }
  follow();
}

bool asksForLevel(const Program& program) {
  return std::ranges::any_of(program.steps(),
                             [](const Step& step) { return step.op == Op::Level; });
}

}  // namespace af2::dsl
