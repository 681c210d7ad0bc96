// The errors of rules that counter-examples prove, found before the rules run.
#pragma once

#include <vector>

#include "dsl/load/rule_file.h"
#include "dsl/proof/sampled_checks.h"
#include "dsl/text/diagnostic.h"
#include "engine/base/export.h"

namespace af2::dsl {

struct ProvenErrors {
  std::vector<Diagnostic> diagnostics;  ///< each with a counter-example
  SampledResult result;                 ///< with the errors alone
};

/// From a short search, which `af2 mesh` makes as well: a rule counts as sampled if neither a proof
/// nor a counter-example is found in it. The rules must have been loaded without errors.
AF2_EXPORT ProvenErrors findProvenErrors(const LoadedRules& loaded);

}  // namespace af2::dsl
