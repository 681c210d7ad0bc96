// Whether a claim holds for all matches: boxes of matches are cut until bounds decide each of them.
#pragma once

#include "dsl/proof/claim.h"
#include "dsl/proof/proof.h"
#include "dsl/proof/rule_graph.h"

namespace af2::dsl {

/// What a claim is held against, beyond what holds for every match of the graph.
struct Circumstances {
  std::vector<Node> facts;             ///< nodes that are >= 0
  std::vector<Node> truths, untruths;  ///< conditions
  /// A claim must hold with something to spare at most matches: elements are to be positive, not
  /// just never negative.
  bool isStrict = false;
};

bool holdsEverywhere(const RuleGraph& graph, const Claim& claim, const Circumstances& given,
                     ProofEffort& effort);

}  // namespace af2::dsl
