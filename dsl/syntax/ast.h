// A rule file as it was written: the tree that the grammar builds.
//
// Nothing here is resolved or checked. Every node knows its span; a node whose span is empty could
// not be read, was told about, and is to be passed over in silence.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dsl/text/source_text.h"

namespace af2::dsl {

/// A name or a string with its place.
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

// ---- clauses of a rule --------------------------------------------------------------------------

using Chain = std::vector<Name>;

struct FrontClause {
  std::vector<Chain> chains;
};

struct Place {
  Name name;
  Expr x, y;
  std::optional<Tolerance> tolerance;
};

struct AtClause {
  std::vector<Place> places;
};

struct SlopeClause {
  Name from, to;
  Tolerance tolerance;
};

/// One `name = expr`.
struct Definition {
  Name name;
  Expr value;
};

struct LetClause {
  std::vector<Definition> values;
};

struct NewClause {
  std::vector<Definition> vertices;
};

struct ZoneClause {
  std::vector<Expr> corners;  ///< a list of corners, or one shape
  Expr when;                  ///< Missing: none
};

struct ElementClause {
  Name kind;  ///< tri, quad or poly
  std::vector<std::vector<Name>> elements;
};

struct RequireClause {
  std::vector<Expr> conditions;
};

struct CostClause {
  Expr value;
};

struct PriorityClause {
  Expr value;
};

struct MetaEntry {
  Name key, value;
};

struct MetaClause {
  std::vector<MetaEntry> entries;
};

struct LevelRange {
  Expr first, last;  ///< `last` is Missing where there is no upper end
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
};

struct MirrorClause {
  Name title;
  bool hasBody = false;
  std::vector<MirrorOverride> overrides;
};

using ClauseContent = std::variant<std::monostate, FrontClause, AtClause, SlopeClause, LetClause,
                                   NewClause, ZoneClause, ElementClause, RequireClause, CostClause,
                                   PriorityClause, MetaClause, MirrorClause>;

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
};

struct MatchSetting {
  Expr value;
};

struct FadeSetting {
  Expr value;
};

struct ScoreSetting {
  Name fold;  ///< max, sum or mean
  Expr metric;
};

struct AcceptSetting {
  Expr condition;
};

struct OrderSetting {
  std::vector<Expr> keys;
};

/// front rows(start: smallest_turn)
struct RowsSetting {
  std::vector<MetaEntry> arguments;
};

struct ClassesSetting {
  Expr first, last;
};

struct ScaleSetting {
  Name unit;
};

struct ParitySetting {
  Name parity;
};

using SettingContent = std::variant<std::monostate, ElementsSetting, MatchSetting, FadeSetting,
                                    ScoreSetting, AcceptSetting, OrderSetting, RowsSetting,
                                    ClassesSetting, ScaleSetting, ParitySetting, MetaClause>;

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

/// p (0, 0), or just p where the vertex has been placed before.
struct TestVertex {
  Name name;
  bool isPlaced = false;
  Expr x, y;
};

using TestChain = std::vector<TestVertex>;

struct TestFront {
  std::vector<TestChain> chains;
};

struct TestPoints {
  std::vector<TestVertex> points;
};

struct TestBase {
  Name from, to;
};

struct TestLevel {
  Expr value;
};

struct TestSize {
  Expr value;
};

/// A vertex in an expected chain: a name, or the n-th new vertex.
struct ExpectedVertex {
  Name name;
  int newIndex = 0;  ///< from 1; 0: not a new one
};

struct ExpectRule {
  Name title;
  std::vector<std::pair<Name, Name>> bindings;  ///< with c = r
  std::string reason;                ///< because ...: the words joined by blanks; empty: none
  std::vector<Name> reasonVertices;  ///< of `zone hit by edge u -> v`, `zone hit by vertex r`
};

struct ExpectNew {
  int index = 0;
  Expr x, y;
};

struct ExpectFront {
  bool only = false;
  std::vector<std::vector<ExpectedVertex>> chains;
};

struct ExpectElements {
  int count = 0;
};

struct ExpectStuck {};

struct ExpectScore {
  std::string comparison;
  Expr value;
};

struct ExpectCondition {
  Expr condition;
};

using ExpectedOutcome = std::variant<std::monostate, ExpectRule, ExpectNew, ExpectFront,
                                     ExpectElements, ExpectStuck, ExpectScore, ExpectCondition>;

struct Expectation {
  bool negated = false;
  ExpectedOutcome outcome;
};

using TestContent =
    std::variant<std::monostate, TestFront, TestPoints, TestBase, TestLevel, TestSize, Expectation>;

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

using ItemContent = std::variant<std::monostate, Import, Use, Constant, Function, Metric,
                                 RuleSetBlock, Rule, Template, Instance, Test, Property>;

struct Item {
  Span span;
  ItemContent content;
};

struct File {
  std::vector<Item> items;
};

}  // namespace af2::dsl
