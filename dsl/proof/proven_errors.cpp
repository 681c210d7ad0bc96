#include "dsl/proof/proven_errors.h"

#include "dsl/proof/match_diagnostics.h"

namespace af2::dsl {

ProvenErrors findProvenErrors(const LoadedRules& loaded) {
  SamplingOptions sampling;
  sampling.onlyErrors = true;
  sampling.samples = 500;
  sampling.effort = {100, 1e-2};
  SampledResult result = runSampledChecks(*loaded.rules, sampling);
  std::erase_if(result.findings,
                [](const SampledFinding& finding) { return finding.severity != Severity::Error; });
  std::vector<Diagnostic> diagnostics = diagnosticsOf(loaded, result);
  return {std::move(diagnostics), std::move(result)};
}

}  // namespace af2::dsl
