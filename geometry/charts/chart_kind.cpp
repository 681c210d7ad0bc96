#include "geometry/charts/chart_kind.h"

#include <algorithm>
#include <vector>

namespace af2::geometry {

namespace {

using Kinds = std::span<const ChartKind>;

bool has(Kinds kinds, ChartKind kind) { return std::ranges::count(kinds, kind) > 0; }

bool always(Kinds) { return true; }
bool onlyIfAskedFor(Kinds) { return false; }
/// Charts in the parameters cannot fold, but lengths in them are off.
bool ifNotDeveloped(Kinds others) { return !has(others, ChartKind::Developed); }
bool ifNothingInParameters(Kinds others) {
  return !has(others, ChartKind::Developed) && !has(others, ChartKind::Affine);
}

using enum ChartDrawing;

constexpr ChartTraits kKinds[] = {
    {ChartKind::Plane, "plane", EachStep, false, false, always},
    {ChartKind::Developed, "developed", WholeFace, true, true, always},
    {ChartKind::Stereographic, "stereographic", EachStep, false, false, always},
    {ChartKind::Conformal, "conformal", WholeFace, true, false, always},
    {ChartKind::MeanNormal, "mean-normal", EachStep, false, false, always},
    {ChartKind::Affine, "affine", InParameters, true, true, ifNotDeveloped},
    {ChartKind::NormalLines, "normal-lines", EachStep, false, false, ifNothingInParameters},
    {ChartKind::Parametric, "parametric", InParameters, true, true, onlyIfAskedFor}};

/// The kind of plane faces follows from these.
bool canBeAskedFor(ChartKind kind) { return kind != ChartKind::Plane; }

}  // namespace

std::span<const ChartTraits> chartKinds() { return kKinds; }

std::string chartNames() {
  std::vector<ChartKind> kinds;
  for (const ChartTraits& traits : kKinds)
    if (canBeAskedFor(traits.kind)) kinds.push_back(traits.kind);
  std::ranges::sort(kinds);
  std::string names = toString(ChartKind::Auto);
  for (const ChartKind kind : kinds) names += std::string(", ") + toString(kind);
  return names;
}

const char* toString(ChartKind kind) {
  const auto* found = std::ranges::find(kKinds, kind, &ChartTraits::kind);
  return found == std::end(kKinds) ? "auto" : found->name;
}

std::optional<ChartKind> chartKindOf(std::string_view name) {
  if (name == toString(ChartKind::Auto)) return ChartKind::Auto;
  for (const ChartTraits& traits : kKinds)
    if (canBeAskedFor(traits.kind) && name == traits.name) return traits.kind;
  return std::nullopt;
}

}  // namespace af2::geometry
