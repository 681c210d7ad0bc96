#include "engine/step/application.h"

#include <array>

#include "engine/mesh/element_shape.h"

namespace af2 {
namespace {

/// Whether a corner is an angle of its own, not what rounding leaves of three points on a line: new
/// vertices may come to lie on an edge of the boundary.
bool isOpen(const Point3& ahead, const Point3& behind, double turned) {
  constexpr double kMinSine = 1e-11;
  return turned > kMinSine * kMinSine * dot(ahead, ahead) * dot(behind, behind);
}

}  // namespace

bool staysUnfolded(const Front& front, const Application& application, int reflexCorners) {
  const CompiledRule& rule = *application.rule;
  const auto pointOf = [&](std::int8_t v) -> const SurfacePoint& {
    return v < rule.matchedCount
               ? front[application.open.places[static_cast<std::size_t>(v)]].point
               : *application.newPoints[static_cast<std::size_t>(v - rule.matchedCount)].point;
  };
  for (const RuleElement& element : rule.rule->definition().elements) {
    const auto n = static_cast<std::size_t>(element.size());
    std::array<const SurfacePoint*, 4> corners;
    for (std::size_t i = 0; i < n; ++i) corners[i] = &pointOf(element.corners[i]);
    const SurfacePoint* behind = corners[n - 1];
    int turned = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const SurfacePoint *corner = corners[i], *ahead = corners[i + 1 == n ? 0 : i + 1];
      const Point3 p = ahead->position - corner->position, q = behind->position - corner->position;
      const Point3 across = cross(p, q);
      turned += !facesNormal(across, corner->normal) || !isOpen(p, q, dot(across, across));
      behind = corner;
    }
    if (turned > reflexCorners) return false;
  }
  return true;
}

}  // namespace af2
