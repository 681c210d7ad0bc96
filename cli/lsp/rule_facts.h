// Facts about a rule that follow from it without being written in it.
#pragma once

#include <string>
#include <vector>

#include "cli/lsp/document.h"

namespace af2::lsp {

/// Chains of front edges, such as "a -> d -> c".
struct RuleFacts {
  std::vector<std::string> consumed;  ///< leave the front
  std::vector<std::string> kept;      ///< belong to the pattern and stay
  std::vector<std::string> made;      ///< join the front
  std::vector<std::string> newVertices;
  std::size_t triangles = 0, quads = 0;
};

RuleFacts factsOf(const AF2Rule& rule);

/// "a -> b, c -> d"; `none` if there are no edges.
std::string joined(const std::vector<std::string>& parts, const std::string& none = "none");

/// The rule in the set of sound rules; null if it has errors.
const AF2Rule* findSound(const RuleSet& rules, const std::string& title);

}  // namespace af2::lsp
