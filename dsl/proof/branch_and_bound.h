// Proves claims for all matches: boxes of matches are split until bounds decide each of them.
#pragma once

#include "dsl/proof/claim.h"
#include "dsl/proof/proof.h"
#include "dsl/proof/rule_graph.h"

namespace af2::dsl {

/// Assumptions of a claim, in addition to the facts that hold for every match of the graph.
struct Circumstances {
  std::vector<Node> facts;             ///< nodes that are >= 0
  std::vector<Node> truths, untruths;  ///< conditions
  /// Whether the claim must hold with a margin at some match of each box, because elements must
  /// have positive area, not just non-negative area.
  bool isStrict = false;
};

bool holdsEverywhere(const RuleGraph& graph, const Claim& claim, const Circumstances& given,
                     ProofEffort& effort);

}  // namespace af2::dsl
