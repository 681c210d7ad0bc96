// Rules and their clauses in the syntax tree. See ast.h.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dsl/syntax/expression_ast.h"

namespace af2::dsl {

// ---- clauses of a rule --------------------------------------------------------------------------

using Chain = std::vector<Name>;

struct FrontClause {
  std::vector<Chain> chains;

  void visitParts(auto&& part) const {
    for (const Chain& chain : chains)
      for (const Name& name : chain) part(NameRole::ChainVertex, name);
  }
};

struct Place {
  Name name;
  Expr x, y;
  std::optional<Tolerance> tolerance;

  Span span() const { return cover(name.span, tolerance ? tolerance->span : y.span); }
};

struct AtClause {
  std::vector<Place> places;

  void visitParts(auto&& part) const {
    for (const Place& place : places) {
      part(NameRole::PlacedVertex, place.name, place.span());
      part(place.x);
      part(place.y);
      if (place.tolerance) part(place.tolerance->form);
    }
  }
};

/// near c of expr within expr
struct NearClause {
  struct Vertex {
    Name name;
    Expr at, reach;
  };
  std::vector<Vertex> vertices;

  void visitParts(auto&& part) const {
    for (const Vertex& vertex : vertices) {
      part(vertex.at);
      part(vertex.reach);
      part(NameRole::PlacedVertex, vertex.name, cover(vertex.name.span, vertex.reach.span));
    }
  }
};

struct SlopeClause {
  Name from, to;
  Tolerance tolerance;

  void visitParts(auto&& part) const {
    part(NameRole::Vertex, from);
    part(NameRole::Vertex, to);
    part(tolerance.form);
  }
};

/// One `name = expr`.
struct Definition {
  Name name;
  Expr value;

  void visitParts(NameRole role, auto&& part) const {
    part(role, name, cover(name.span, value.span));
    part(value);
  }
};

struct LetClause {
  std::vector<Definition> values;

  void visitParts(auto&& part) const {
    for (const Definition& d : values) d.visitParts(NameRole::Value, part);
  }
};

struct NewClause {
  std::vector<Definition> vertices;

  void visitParts(auto&& part) const {
    for (const Definition& d : vertices) d.visitParts(NameRole::NewVertex, part);
  }
};

struct ZoneClause {
  std::vector<Expr> corners;  ///< a list of corners, or one shape
  Expr when;                  ///< Missing: none

  void visitParts(auto&& part) const {
    for (const Expr& corner : corners) part(corner);
    part(when);
  }
};

struct ElementClause {
  Name kind;  ///< tri, quad or poly
  std::vector<std::vector<Name>> elements;

  void visitParts(auto&& part) const {
    for (const auto& corners : elements)
      for (const Name& corner : corners) part(NameRole::Vertex, corner);
  }
};

/// weld c into a at expr
struct WeldClause {
  Name from, into;
  Expr at;

  void visitParts(auto&& part) const {
    part(NameRole::Vertex, from);
    part(NameRole::Vertex, into);
    part(at);
  }
};

/// far c
struct FarClause {
  Name vertex;

  void visitParts(auto&& part) const { part(NameRole::PlacedVertex, vertex, vertex.span); }
};

/// path a -> c by expr
struct PathClause {
  Name from, to;
  Expr segments;

  void visitParts(auto&& part) const {
    part(NameRole::Vertex, from);
    part(NameRole::Vertex, to);
    part(segments);
  }
};

struct RequireClause {
  std::vector<Expr> conditions;

  void visitParts(auto&& part) const {
    for (const Expr& condition : conditions) part(condition);
  }
};

struct CostClause {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct PriorityClause {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct MetaEntry {
  Name key, value;
};

struct MetaClause {
  std::vector<MetaEntry> entries;

  void visitParts(auto&&) const {}  // remarks for tools contain no names
};

struct LevelRange {
  Expr first, last;  ///< `last` is Missing if the range has no upper end

  void visitParts(auto&& part) const {
    part(first);
    part(last);
  }
};

struct MirrorOverride {
  struct Vertex {
    Name name;
    Tolerance tolerance;
  };
  std::vector<Vertex> tolerances;    ///< at c ~ 1, d ~ 2;
  std::optional<LevelRange> levels;  ///< quality 3;
  std::optional<CostClause> cost;    ///< cost 0.1;
  Span span;

  void visitParts(auto&& part) const {
    for (const Vertex& vertex : tolerances) {
      part(NameRole::Vertex, vertex.name);
      part(vertex.tolerance.form);
    }
    if (levels) levels->visitParts(part);
    if (cost) cost->visitParts(part);
  }
};

struct MirrorClause {
  Name title;
  bool hasBody = false;
  std::vector<MirrorOverride> overrides;

  void visitParts(auto&& part) const {
    part(NameRole::MirrorTitle, title);
    for (const MirrorOverride& entry : overrides) entry.visitParts(part);
  }
};

using ClauseContent =
    std::variant<std::monostate, FrontClause, AtClause, NearClause, SlopeClause, LetClause,
                 NewClause, ZoneClause, ElementClause, WeldClause, FarClause, PathClause,
                 RequireClause, CostClause, PriorityClause, MetaClause, MirrorClause>;

struct Clause {
  Span span;  ///< empty: could not be read
  ClauseContent content;
};

// ---- rules --------------------------------------------------------------------------------------

/// for (k, h) in (1, 2), (3, 4)
struct Family {
  std::vector<Name> names;
  std::vector<Expr> tuples;
};

struct Rule {
  std::string doc;
  Name title;
  std::optional<Family> family;
  LevelRange levels;
  std::vector<Clause> clauses;
  Span span;
};

struct Template {
  std::string doc;
  Name name;
  std::vector<Name> parameters;
  Rule rule;
};

/// rule "title" = template(arguments);
struct Instance {
  std::string doc;
  Name title;
  Expr call;
};

}  // namespace af2::dsl
