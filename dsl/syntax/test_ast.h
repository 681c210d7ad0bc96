// Tests and properties in the syntax tree. See ast.h.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "dsl/syntax/expression_ast.h"

namespace af2::dsl {

/// p (0, 0), or just p if the vertex already has a position.
struct TestVertex {
  Name name;
  bool isPlaced = false;
  Expr x, y;

  void visitParts(auto&& part) const {
    if (!isPlaced) return part(NameRole::Vertex, name);
    part(NameRole::TestVertex, name, cover(name.span, y.span));
    part(x);
    part(y);
  }
};

using TestChain = std::vector<TestVertex>;

struct TestFront {
  std::vector<TestChain> chains;

  void visitParts(auto&& part) const {
    for (const TestChain& chain : chains)
      for (const TestVertex& vertex : chain) vertex.visitParts(part);
  }
};

struct TestPoints {
  std::vector<TestVertex> points;

  void visitParts(auto&& part) const {
    for (const TestVertex& vertex : points) vertex.visitParts(part);
  }
};

struct TestBase {
  Name from, to;

  void visitParts(auto&& part) const {
    part(NameRole::Vertex, from);
    part(NameRole::Vertex, to);
  }
};

struct TestLevel {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct TestSize {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct VertexColour {
  Name vertex;
  int colour = 0;
};

/// colours p 0, w 1;
struct TestColours {
  std::vector<VertexColour> colours;

  void visitParts(auto&& part) const {
    for (const VertexColour& c : colours) part(NameRole::Vertex, c.vertex);
  }
};

/// A vertex in an expected chain: a name, or the number of a new vertex.
struct ExpectedVertex {
  Name name;
  int newIndex = 0;  ///< from 1; 0: not a new one

  void visitParts(auto&& part) const {
    if (newIndex == 0) part(NameRole::Vertex, name);
  }
};

/// One reason of a refusal.
struct ExpectedReason {
  std::string words;           ///< joined by blanks
  std::vector<Name> vertices;  ///< of `zone hit by edge u -> v`, `zone hit by vertex r`
};

struct ExpectRule {
  Name title;
  std::vector<std::pair<Name, Name>> bindings;  ///< with c = r
  std::vector<ExpectedReason> reasons;          ///< because ... or ...; empty: none

  void visitParts(auto&& part) const {
    part(NameRole::RuleTitle, title);
    for (const auto& [vertex, inTest] : bindings) {
      part(NameRole::RuleVertex, vertex);
      part(NameRole::Vertex, inTest);
    }
    for (const ExpectedReason& reason : reasons)
      for (const Name& name : reason.vertices) part(NameRole::Vertex, name);
  }
};

struct ExpectNew {
  int index = 0;
  Expr x, y;

  void visitParts(auto&& part) const {
    part(x);
    part(y);
  }
};

struct ExpectFront {
  bool only = false;
  std::vector<std::vector<ExpectedVertex>> chains;

  void visitParts(auto&& part) const {
    for (const auto& chain : chains)
      for (const ExpectedVertex& vertex : chain) vertex.visitParts(part);
  }
};

struct ExpectElements {
  int count = 0;

  void visitParts(auto&&) const {}
};

/// weld c into a
struct ExpectWeld {
  Name from, into;

  void visitParts(auto&& part) const {
    part(NameRole::Vertex, from);
    part(NameRole::Vertex, into);
  }
};

struct ExpectStuck {
  void visitParts(auto&&) const {}
};

struct ExpectScore {
  std::string comparison;
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct ExpectCondition {
  Expr condition;

  void visitParts(auto&& part) const { part(condition); }
};

using ExpectedOutcome =
    std::variant<std::monostate, ExpectRule, ExpectNew, ExpectFront, ExpectElements, ExpectWeld,
                 ExpectStuck, ExpectScore, ExpectCondition>;

struct Expectation {
  bool negated = false;
  ExpectedOutcome outcome;

  void visitParts(auto&& part) const { dsl::visitParts(outcome, part); }
};

using TestContent = std::variant<std::monostate, TestFront, TestPoints, TestColours, TestBase,
                                 TestLevel, TestSize, Expectation>;

struct TestClause {
  Span span;
  TestContent content;
};

struct Test {
  Name title;
  std::vector<TestClause> clauses;
  Span span;
};

/// property "title" forall match of "rule", q in 1..10 { expect ...; }
struct Property {
  Name title, rule;
  std::optional<Name> variable;
  Expr first, last;
  std::vector<Expr> expectations;
};

}  // namespace af2::dsl
