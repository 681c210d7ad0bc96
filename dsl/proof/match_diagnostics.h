// Converts findings about all matches of rules to diagnostics with places in the text.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "dsl/proof/coverage.h"
#include "dsl/proof/sampled_checks.h"
#include "dsl/text/diagnostic.h"
#include "engine/base/export.h"

namespace af2::dsl {

/// The rules that call names that are declared and not registered, by their index in the rule set.
/// They cannot be evaluated.
AF2_EXPORT std::set<std::size_t> unknownRules(const LoadedRules& loaded);

/// R6 as a warning at each of these declarations, with what is not checked because of it.
AF2_EXPORT std::vector<Diagnostic> missingNamesIn(const LoadedRules& loaded);

/// One diagnostic for each finding, with the counter-example as a `test` on one line in a note.
/// Findings with codes that the rule allows are left out: meta { allow "Z1, Z2"; }.
AF2_EXPORT std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded,
                                                 const SampledResult& result);

/// An example of a missing mirror image: the mirror image of the rule, a match where no rule has
/// the same effect, and a test that fails there.
struct MirrorExample {
  std::shared_ptr<const AF2Rule> image;
  CounterExample example;
  std::string test;
};

/// An example for a finding of M1, which comes from the text alone. Nothing if no such match is
/// found.
AF2_EXPORT std::optional<MirrorExample> mirrorExampleOf(const LoadedRules& loaded,
                                                        const Diagnostic& finding);

/// Takes away the findings of M1 that ask for a mirror image which would never be chosen: whoever
/// added it would be told so by D3.
AF2_EXPORT void dropIdleMirrors(const LoadedRules& loaded, std::vector<Diagnostic>& told);

/// A test as a note, on one line.
AF2_EXPORT DiagnosticNote testNote(const std::string& test);

/// Adds a finding to the diagnostics, once for each fault. A diagnostic at the same place for
/// another member of a family, for a mirror image, or from the text alone, is completed instead. A
/// finding that a mirror image is never chosen is left out if the image is redundant (M2).
AF2_EXPORT void addFinding(std::vector<Diagnostic>& told, Diagnostic finding);

/// N1, C1 and N2, at the top of the file: warnings if there are situations that no rule accepts, or
/// small loops that the rules do not close.
AF2_EXPORT std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded,
                                                 const Coverage& coverage);

}  // namespace af2::dsl
