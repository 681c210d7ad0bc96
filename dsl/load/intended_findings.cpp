#include "dsl/load/intended_findings.h"

#include <algorithm>

#include "dsl/compile/allowed_codes.h"
#include "dsl/load/loaded_file.h"

namespace af2::dsl {

bool isMeantToBe(const LoadedFile& file, const Diagnostic& finding) {
  const bool canBe =
      finding.severity == Severity::Warning || infoOf(finding.code).allowance == Allowance::AsError;
  if (!canBe) return false;
  if (file.allowed.contains(finding.code)) return true;
  return !finding.rule.empty() && std::ranges::any_of(file.rules, [&](const CompiledRule& rule) {
    return rule.text && rule.definition.name == finding.rule && allows(*rule.text, finding.code);
  });
}

}  // namespace af2::dsl
