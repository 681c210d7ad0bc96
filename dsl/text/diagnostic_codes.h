// The codes of faults in rule files; their table is diagnostic_codes.def.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace af2::dsl {

enum class Severity { Error, Warning };

/// A code by its name, in the order of the table: series and number.
enum class Code : std::uint8_t {
#define AF2_CODE(id, name, severity, allowance, evidence, stage, page, title, explanation) name,
#include "dsl/text/diagnostic_codes.def"
#include "engine/base/export.h"
#undef AF2_CODE
};

/// Whether `allow` and `--allow` silence a finding with this code.
enum class Allowance {
  AsWarning,  ///< only if the finding is a warning
  AsError,    ///< also if the finding is an error
};

/// The evidence for a finding.
enum class Evidence {
  Text,            ///< the text and the reference match of a rule
  Samples,         ///< many sampled matches of a rule
  Proof,           ///< samples; if none of them shows a fault, a proof is attempted
  TextAndSamples,  ///< the text, and also samples
  TextAndProof,    ///< the text, and also samples and a proof
};

/// The stage of compilation in which a fault is found. Faults of an earlier stage hide those of
/// later stages.
enum class Stage {
  Signs,  ///< words and clauses of the file
  Names,  ///< names and types
  Rules,  ///< the effect of rules
};

/// A row of the table.
struct CodeInfo {
  Code code;
  std::string_view id;    ///< such as "A1", as users see it
  std::string_view name;  ///< such as "PointWeights", as in the source code
  Severity severity;      ///< the usual one; the code that reports the finding can override it
  Allowance allowance;
  Evidence evidence;
  Stage stage;
  std::string_view page;         ///< the section of the documentation: "language.md#types"
  std::string_view title;        ///< one line
  std::string_view explanation;  ///< cause, example and way out
};

/// All codes, sorted by series and number.
AF2_EXPORT std::span<const CodeInfo> diagnosticCodes();

AF2_EXPORT const CodeInfo& infoOf(Code code);

/// Takes "A1" and "AF2-A1", in either case. Nothing if there is no such code.
AF2_EXPORT std::optional<Code> findCode(std::string_view id);

/// "A1", as `allow` lists it.
AF2_EXPORT std::string idOf(Code code);
/// "AF2-A1", as reports show it.
AF2_EXPORT std::string fullIdOf(Code code);

}  // namespace af2::dsl
