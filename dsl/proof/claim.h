// Claims about a rule, expressed as non-negative nodes.
#pragma once

#include <optional>
#include <vector>

#include "dsl/proof/rule_graph.h"

namespace af2::dsl {

/// `node >= 0`, or that all or any of the parts hold.
struct Claim {
  enum class Kind { NotNegative, All, Any };
  Kind kind = Kind::All;
  Node node = -1;
  std::vector<Claim> parts;

  bool isTrue() const { return kind == Kind::All && parts.empty(); }
};

Claim notNegative(Node node);
/// Parts that are known to be true are left out.
Claim allOf(std::vector<Claim> parts);
Claim anyOf(std::vector<Claim> parts);

using Corners = std::vector<NodePair>;  ///< of a convex element, counter-clockwise

/// A claim which implies that a convex element is inside a shape, if the shape is valid. The claim
/// is sufficient, not necessary. Returns nothing if no such claim is known.
std::optional<Claim> liesIn(RuleGraph& graph, const GraphShape& shape, const Corners& element);

/// Adds facts that hold wherever a shape is valid: lists of corners are convex, radii are
/// non-negative.
void addShapeFacts(RuleGraph& graph, const GraphShape& shape, std::vector<Node>& facts);

}  // namespace af2::dsl
