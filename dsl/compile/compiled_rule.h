// A rule between text and engine: its definition, and where each part of it was written.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dsl/compile/module.h"
#include "dsl/syntax/ast.h"
#include "dsl/text/diagnostic.h"
#include "engine/rule/rule.h"

namespace af2::dsl {

/// A name with a known value that a rule is compiled with: of its family, of its template.
struct RuleParameter {
  ConstantName value;
  Span span;
};

/// One rule: a family gives several, a rule with a mirror two.
struct CompiledRule {
  RuleDefinition definition;
  const Rule* text = nullptr;
  const Module* home = nullptr;  ///< the file that `text` is from
  Span title;                    ///< of a mirror: the mirror's title
  DiagnosticPlace titlePlace;    ///< of an instance: in the file that asks for it
  DiagnosticPlace askedAt;       ///< of an instance and its mirror image: the instance's title
  bool isMirror = false;
  std::vector<Span> elementSpans;  ///< one for each element of the definition
  std::vector<Span> vertexSpans;   ///< matched, then new ones: where each is defined
  std::vector<Span> edgeSpans;     ///< one for each pattern edge; the implied base: the title
  std::vector<Span> zoneSpans;     ///< the zone clauses
  Span levelSpan;
  std::optional<Span> mirrorSpan;  ///< of the clause `mirror "..."` of this rule
  std::map<std::string, RuleParameter> parameters;
  const MirrorClause* mirror = nullptr;  ///< of a mirror: the clause that asks for it
  std::string doc;
  std::shared_ptr<const RuleDefinition> image;  ///< what its mirror image would be
};

}  // namespace af2::dsl
