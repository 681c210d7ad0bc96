// A compiled rule: its definition for the engine, and the place of each part in the text.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dsl/compile/compile_context.h"
#include "dsl/compile/module.h"
#include "dsl/syntax/ast.h"
#include "dsl/text/diagnostic.h"
#include "engine/rule/rule.h"

namespace af2::dsl {

/// A parameter of a family or template with its value.
struct RuleParameter {
  ConstantName value;
  Span span;
};

/// What a condition compares, so that its values can be told.
struct ComparedValue {
  std::string text;  ///< as it is written
  Type type = Type::Number;
  std::shared_ptr<const AF2BindingFunction> value;
};

/// A `require` condition as it was written.
struct WrittenCondition {
  Span span;
  std::vector<ComparedValue> compared;  ///< those that depend on the match or the level
};

/// One rule. A family makes several, a rule with a mirror image two.
struct CompiledRule {
  RuleDefinition definition;
  const Rule* text = nullptr;
  const Module* home = nullptr;  ///< the file that `text` is from
  Span title;                    ///< of a mirror image: its own title
  DiagnosticPlace titlePlace;    ///< of an instance of a template: in the file of the instance
  DiagnosticPlace askedAt;       ///< of an instance and its mirror image: the instance's title
  bool isMirror = false;
  std::vector<Span> elementSpans;  ///< one for each element of the definition
  std::vector<Span> vertexSpans;  ///< the definitions of the matched vertices, then of the new ones
  std::vector<Span> edgeSpans;    ///< one for each pattern edge; the title for an implied base edge
  std::vector<Span> zoneSpans;    ///< the zone clauses
  std::vector<WrittenCondition> conditions;  ///< one for each requirement of the definition
  std::optional<Span> costSpan;              ///< the value of the cost
  std::optional<Span> actSpan;               ///< the clause `weld` or `path`
  Span levelSpan;
  std::optional<Span> mirrorSpan;  ///< of the clause `mirror "..."` of this rule
  std::map<std::string, RuleParameter> parameters;
  const MirrorClause* mirror = nullptr;  ///< of a mirror image: its clause
  std::string doc;
  /// Declared names that the rule calls and that no program has registered. It cannot be evaluated.
  std::vector<MissingName> missing;
  std::shared_ptr<const RuleDefinition> image;  ///< its mirror image, even if no rule has it
};

}  // namespace af2::dsl
