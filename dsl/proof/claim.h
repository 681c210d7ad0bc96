// Claims about a rule that hold where certain nodes are not negative.
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
/// Parts that are true already are left out.
Claim allOf(std::vector<Claim> parts);
Claim anyOf(std::vector<Claim> parts);

using Corners = std::vector<NodePair>;  ///< of a convex element, counter-clockwise

/// What has to be shown for a convex element to lie in a shape, given that the shape has a valid
/// form; nothing if no way is known. It need not hold for an element that does.
std::optional<Claim> liesIn(RuleGraph& graph, const GraphShape& shape, const Corners& element);

/// Adds what holds wherever a shape has a valid form: lists of corners are convex, radii are not
/// negative.
void addShapeFacts(RuleGraph& graph, const GraphShape& shape, std::vector<Node>& facts);

}  // namespace af2::dsl
