#include "geometry/charts/chart_kind.h"

#include <algorithm>

namespace af2::geometry {

namespace {

struct Named {
  ChartKind kind;
  const char* name;
};

constexpr Named kNamed[] = {{ChartKind::Auto, "auto"},
                            {ChartKind::MeanNormal, "mean-normal"},
                            {ChartKind::NormalLines, "normal-lines"},
                            {ChartKind::Parametric, "parametric"},
                            {ChartKind::Affine, "affine"},
                            {ChartKind::Developed, "developed"},
                            {ChartKind::Stereographic, "stereographic"},
                            {ChartKind::Conformal, "conformal"}};

}  // namespace

std::string chartNames() {
  std::string names;
  for (const Named& named : kNamed) names += (names.empty() ? "" : ", ") + std::string(named.name);
  return names;
}

const char* toString(ChartKind kind) {
  const auto* found = std::ranges::find(kNamed, kind, &Named::kind);
  return found == std::end(kNamed) ? "plane" : found->name;
}

std::optional<ChartKind> chartKindOf(std::string_view name) {
  const auto* found =
      std::ranges::find_if(kNamed, [&](const Named& named) { return name == named.name; });
  if (found == std::end(kNamed)) return std::nullopt;
  return found->kind;
}

}  // namespace af2::geometry
