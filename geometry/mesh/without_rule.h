// Elements that no rule made: what stands in the place of the rule, and how many there are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/mesh/mesh.h"
#include "engine/rule/rule_set.h"

namespace af2::geometry {

/// How elements come about where no rule makes them.
enum class WithoutRule {
  Closing,  ///< triangles between vertices of the boundary or of a front that got stuck
  Fan,      ///< triangles around a tip that is too sharp for a front
  Layer,    ///< layers along an edge, which were asked for
};

/// Their names, in the order of the enumeration, as ModelMesh::ruleNames has them after the rules.
inline constexpr std::string_view kLayerName = "layer";  ///< only if layers were asked for
inline constexpr std::array<std::string_view, 3> kWithoutRuleNames{"closing", "fan", kLayerName};

inline ElementOrigin originOf(WithoutRule kind, const RuleSet& rules) {
  ElementOrigin origin;
  origin.rule = static_cast<std::uint16_t>(rules.rules().size() + static_cast<std::size_t>(kind));
  return origin;
}

/// How many elements of a face rules did not make, or not in the way that they are meant to.
struct WithoutRuleCounts {
  std::size_t closing = 0, fan = 0;
  /// Elements whose corners lean against the surface: made where surface normals were ignored.
  std::size_t leaning = 0;

  std::size_t total() const { return closing + fan + leaning; }
  WithoutRuleCounts& operator+=(const WithoutRuleCounts& other) {
    closing += other.closing;
    fan += other.fan;
    leaning += other.leaning;
    return *this;
  }
  bool operator==(const WithoutRuleCounts&) const = default;
};

}  // namespace af2::geometry
