// Why a rule was not applied: the stated reasons, in the order in which they are checked.
#pragma once

#include "engine/base/export.h"

namespace af2 {

enum class Refusal {
  None,             ///< not refused
  Class,            ///< the base edge's quality level is outside the rule's range
  Pattern,          ///< no front vertices where the pattern wants them
  Require,          ///< a `require` condition does not hold
  NoValue,          ///< an expression has no value at this match
  Parity,           ///< the step would leave a loop with an odd number of edges
  Shape,            ///< the free zone has no valid shape at this match
  Convexity,        ///< the commonest shape fault: the corner list is not convex
  ZoneHitByVertex,  ///< the free zone holds a vertex of the front
  ZoneHitByEdge,    ///< the free zone holds part of a front edge
  Clearance,        ///< a new edge would come too close to a front edge
  Inverted,         ///< a new element would not be positively oriented
  Weld,             ///< the mesh or the front would not stay sound
  Score,            ///< the rule set does not accept the score
  Surface,  ///< a new vertex has no point on the surface, or an element would fold over there
  Beaten,   ///< another rule scored better
};

/// The name of a reason in rule tests and reports.
AF2_EXPORT const char* toString(Refusal refusal);

}  // namespace af2
