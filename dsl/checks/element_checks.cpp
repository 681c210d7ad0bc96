// G2: are all elements positive, whatever the match?
#include <fmt/format.h>

#include <algorithm>

#include "dsl/checks/rule_sample.h"
#include "dsl/checks/test_text.h"
#include "engine/predicates.h"

namespace af2::dsl {
namespace {

/// The corner at which an element does not turn left; nothing if it is positive.
std::optional<Point2> badCorner(const std::vector<Point2>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]) != Turn::Left)
      return corners[i];
  return std::nullopt;
}

struct Inverted {
  int element;
  Point2 corner;
};

std::optional<Inverted> invertedElement(const SampledMatch& one) {
  if (!one.zone || !one.placed) return std::nullopt;
  const auto& elements = one.match.rule().definition().elements;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (const auto corner = badCorner(cornersOf(elements[i], *one.placed)))
      return Inverted{static_cast<int>(i), *corner};
  return std::nullopt;
}

}  // namespace

std::optional<SampledFinding> findInverted(const RuleSample& sample) {
  int count = 0, valid = 0;
  const SampledMatch* nearest = nullptr;
  for (const SampledMatch& one : sample.matches) {
    valid += one.zone != nullptr;
    if (!invertedElement(one)) continue;
    ++count;
    if (!nearest || one.deviation < nearest->deviation) nearest = &one;
  }
  if (!nearest) return std::nullopt;

  const auto shows = [](const SampledMatch& one) { return invertedElement(one).has_value(); };
  const SampledMatch example = simplified(*nearest, sample.rules, shows);
  const Inverted inverted = *invertedElement(example);
  SampledFinding finding = findingAbout(sample, "G2", Severity::Error);
  finding.element = inverted.element;
  finding.message =
      fmt::format("a new element turns over at {} of {} matches that rule '{}' accepts at level {}",
                  count, valid, sample.name(), sample.level);
  finding.help = "require that the corners turn left, or make the pattern's tolerance smaller";
  finding.example = {example.match.vertices(), sample.level, {inverted.corner}, {}};
  finding.test =
      writeTest(example.match, {fmt::format("{}: no element turns over", sample.name()),
                                {},
                                fmt::format("not rule \"{}\" because require", sample.name())});
  return finding;
}

}  // namespace af2::dsl
