// Findings about all matches of rules, told at the places of the text.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "dsl/proof/coverage.h"
#include "dsl/proof/sampled_checks.h"
#include "dsl/text/diagnostic.h"
#include "engine/base/export.h"

namespace af2::dsl {

/// One diagnostic for each finding, with the counter-example as a `test` on one line in a note.
/// Left out are codes that the rule itself allows: meta { allow "Z1, Z2"; }.
AF2_EXPORT std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded,
                                                 const SampledResult& result);

/// What shows that a mirror image is missing: the image of the rule, a match of it where no rule
/// does what it would do, and a test that fails there.
struct MirrorExample {
  std::shared_ptr<const AF2Rule> image;
  CounterExample example;
  std::string test;
};

/// For a finding of M1, which is told from the text alone. Nothing where no such match is found.
AF2_EXPORT std::optional<MirrorExample> mirrorExampleOf(const LoadedRules& loaded,
                                                        const Diagnostic& finding);

/// A test as a note, on one line.
AF2_EXPORT DiagnosticNote testNote(const std::string& test);

/// Adds a finding to what is told already, once for each fault: what is told of the same place for
/// another member of a family, for a mirror image, or from the text alone, is completed. That a
/// mirror image is never chosen follows from its being one too many (M2).
AF2_EXPORT void addFinding(std::vector<Diagnostic>& told, Diagnostic finding);

/// N1, at the head of the file: a warning if there are situations that no rule accepts.
AF2_EXPORT std::vector<Diagnostic> diagnosticsOf(const LoadedRules& loaded,
                                                 const Coverage& coverage);

}  // namespace af2::dsl
