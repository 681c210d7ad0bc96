// The syntax tree of a rule file, as the parser builds it.
//
// Nothing here is resolved or checked. Every node has a span. A node with an empty span could not
// be read; it has been reported and must be skipped without further messages.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dsl/syntax/match.h"
#include "dsl/text/keywords.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

/// A name or a string with its span.
struct Name {
  std::string text;
  Span span;
};

enum class ExprKind {
  Missing,   ///< could not be read
  Number,    ///< 12; `name` keeps the digits as written
  Angle,     ///< 60deg, in degrees
  Name,      ///< a
  Imported,  ///< lib.H: `qualifier`.`name`
  Call,      ///< f(x, ...), or lib.f(x, ...)
  Paren,     ///< (x)
  Tuple,     ///< (x, y): a vector; with three parts a tolerance form; more only in families
  Member,    ///< p.x: `name` is x or y
  Negate,
  Not,
  Binary,  ///< `name` is the operator: + - * / ^ < <= > >= == != and or | &
  In,      ///< x in from..to
  If,      ///< if c then x else y
  Fade,    ///< preferred => limit, in zones only
};

struct Expr {
  ExprKind kind = ExprKind::Missing;
  Span span;
  std::string name, qualifier;
  double number = 0;
  std::vector<Expr> parts;

  bool isMissing() const { return kind == ExprKind::Missing; }
};

struct Tolerance {
  bool any = false;
  Expr form;  ///< a weight, or a Tuple of three; not read if `any`
  Span span;
};

// ---- the parts of a clause ----------------------------------------------------------------------

// Each clause, setting and clause of a test lists its parts with `visitParts(part)`, in the order
// of the text. Code that needs the names or expressions of any clause, such as the symbol index,
// uses this list. `part` is called with
//
//     part(expr)                an expression that the clause evaluates
//     part(role, name)          a name and its role
//     part(role, name, whole)   a name that the clause defines, and the text of the definition

/// The parts of the clause in `content`. A clause that could not be read has none.
template <class... Contents>
void visitParts(const std::variant<std::monostate, Contents...>& content, auto&& part) {
  match(
      content, [](std::monostate) {},
      [&](const AnyOf<Contents...> auto& held) { held.visitParts(part); });
}

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

// ---- rule sets ----------------------------------------------------------------------------------

struct ElementsSetting {
  std::vector<Name> kinds;

  void visitParts(auto&&) const {}  // kinds are keywords
};

struct MatchSetting {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct FadeSetting {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

struct ScoreSetting {
  Name fold;  ///< max, sum or mean
  Expr metric;

  void visitParts(auto&& part) const { part(metric); }
};

struct AcceptSetting {
  std::vector<Expr> conditions;  ///< all must hold

  void visitParts(auto&& part) const {
    for (const Expr& condition : conditions) part(condition);
  }
};

struct ClearSetting {
  Expr value;

  void visitParts(auto&& part) const { part(value); }
};

/// counts 130deg, 235deg, 315deg
struct CountsSetting {
  std::vector<Expr> bounds;

  void visitParts(auto&& part) const {
    for (const Expr& bound : bounds) part(bound);
  }
};

/// columns 0.7..1.4 from layer 3
struct ColumnsSetting {
  Expr low, high, layer;

  void visitParts(auto&& part) const {
    part(low);
    part(high);
    part(layer);
  }
};

/// at row smooth 3
struct RowEndSetting {
  Expr rounds;

  void visitParts(auto&& part) const { part(rounds); }
};

struct OrderSetting {
  std::vector<Expr> keys;

  void visitParts(auto&& part) const {
    for (const Expr& key : keys) part(key);
  }
};

/// front rows(start: smallest_turn)
struct RowsSetting {
  std::vector<MetaEntry> arguments;

  void visitParts(auto&&) const {}  // arguments and their values are keywords
};

struct ClassesSetting {
  Expr first, last;

  void visitParts(auto&& part) const {
    part(first);
    part(last);
  }
};

struct ScaleSetting {
  Name unit;

  void visitParts(auto&&) const {}  // units are keywords
};

struct ParitySetting {
  Name parity;

  void visitParts(auto&&) const {}  // parities are keywords
};

struct FinishSetting {
  Name finish;

  void visitParts(auto&&) const {}  // ways to finish are keywords
};

using SettingContent =
    std::variant<std::monostate, ElementsSetting, MatchSetting, FadeSetting, ScoreSetting,
                 AcceptSetting, ClearSetting, OrderSetting, RowsSetting, RowEndSetting,
                 ClassesSetting, ScaleSetting, ParitySetting, CountsSetting, ColumnsSetting,
                 FinishSetting, MetaClause>;

struct Setting {
  Span span;
  SettingContent content;
};

struct RuleSetBlock {
  std::string doc;
  Name name;
  std::optional<Name> base;  ///< extends
  std::vector<Setting> settings;
};

// ---- tests --------------------------------------------------------------------------------------

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

// ---- files --------------------------------------------------------------------------------------

struct Import {
  Name path;
  std::optional<Name> alias;
};

/// use lib.*; use lib."right 60"; use lib.* except "a", "b";
struct Use {
  Name library;
  std::optional<Name> rule;  ///< nothing: all
  std::vector<Name> except;
};

struct Constant {
  std::string doc;
  Name name;
  Expr value;
};

struct Function {
  std::string doc;
  Name name;
  std::vector<Name> parameters;
  Expr value;
};

struct Metric {
  std::string doc;
  Name name;
  std::vector<Name> parameters;
  Expr value;
};

/// extern function heat(point) : number;
struct Extern {
  std::string doc;
  Name kind;  ///< function, shape or metric
  Name name;
  bool hasList = false;          ///< whether there are parentheses
  std::vector<Name> parameters;  ///< the types of the arguments
  std::optional<Name> result;    ///< the type of the value
};

using ItemContent = std::variant<std::monostate, Import, Use, Constant, Function, Metric, Extern,
                                 RuleSetBlock, Rule, Template, Instance, Test, Property>;

struct Item {
  Span span;
  ItemContent content;
};

struct File {
  std::vector<Item> items;
};

}  // namespace af2::dsl
