// Compiles a test to a piece of front and the expectations on the rules there.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/expressions.h"
#include "dsl/syntax/ast.h"
#include "engine/rule/refusal.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

/// One `expect` with its names resolved.
struct CompiledExpectation {
  struct Reason {
    std::string words;                  ///< as written
    std::vector<std::size_t> vertices;  ///< one vertex, or the two of an edge
  };
  struct IsRule {
    std::string title;
    std::vector<std::pair<std::string, std::size_t>>
        bindings;                 ///< from pattern vertex to vertex of the test
    std::vector<Reason> reasons;  ///< one of these; empty: any
  };
  struct NewAt {
    std::size_t index = 0;  ///< from 0
    Point2 at;
  };
  /// Vertices of the test, then the new vertices.
  struct Front {
    bool only = false;
    std::vector<std::vector<std::size_t>> chains;
  };
  struct Elements {
    std::size_t count = 0;
  };
  struct Weld {
    std::size_t from = 0, into = 0;
  };
  struct Stuck {};
  struct Score {
    std::string comparison;
    double value = 0;
  };
  struct Condition {
    bool holds = false;
  };

  bool negated = false;
  std::variant<Stuck, IsRule, NewAt, Front, Elements, Weld, Score, Condition> outcome;
  Span span;
};

struct CompiledTest {
  std::string title;
  Span span;  ///< of the title
  FrontPiece piece;
  std::vector<std::string> vertexNames;
  std::vector<CompiledExpectation> expectations;
};

/// A `property`, with its expectations compiled for its rule.
struct CompiledProperty {
  std::string title;
  Span span;
  std::string rule;
  int firstLevel = 1, lastLevel = 1;
  std::vector<std::shared_ptr<const AF2BindingFunction>> expectations;
  std::vector<Span> expectationSpans;
};

/// Nothing if the test has errors, which are reported.
std::optional<CompiledTest> compileTest(CompileContext& context, const Module& module,
                                        const Test& test, std::span<const CompiledRule> rules,
                                        int maxLevel);

}  // namespace af2::dsl
