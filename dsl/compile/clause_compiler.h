// The clauses of one rule, as written or for its mirror image, become a definition.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/compile/expressions.h"
#include "dsl/compile/rule_compiler.h"
#include "dsl/program/known_values.h"
#include "dsl/syntax/names.h"

namespace af2::dsl {

/// Compiles the clauses of one rule, as written or for its mirror image.
class ClauseCompiler {
 public:
  ClauseCompiler(CompileContext& context, const Module& home, const SharedSettings& settings,
                 const Rule& rule, const MirrorClause* mirror)
      : home_(home),
        registry_(context.registry),
        settings_(settings),
        rule_(rule),
        mirror_(mirror),
        expressions_(
            context, home, ExpressionPlace::Rule,
            Algebra(builder_, {countPlaces(rule) + 2, mirror != nullptr, settings.counts})) {
    expressions_.fade = [this] { return fadeNode(); };
    result_.text = &rule;
    result_.home = &home;
    result_.isMirror = mirror != nullptr;
    poisonBrokenNames();
  }

  ExpressionCompiler& expressions() { return expressions_; }

  void define(const std::string& name, const RuleCompiler::Parameter& parameter) {
    warnIfHiding({name, parameter.span});
    Local local;
    local.value = valueOf(parameter.value);
    local.span = parameter.span;
    local.kind = LocalKind::Parameter;
    expressions_.locals[name] = std::move(local);
    isGeneric_ = isGeneric_ || parameter.value.type == Type::Any;
  }

  /// An expression that is evaluated at a match, and therefore needs a value at every level.
  struct UsedValue {
    enum class Kind { Requirement, NewVertex, Cost, When, Zone };  ///< Zone: of the When before it
    Kind kind;
    Span span;
    std::size_t first, last;  ///< of usedNodes_; the last one is not among them
    bool isTold = false;
  };

  /// Nothing if an error was reported, so that there is no rule.
  std::optional<CompiledRule> compile(const std::string& title, Span titleSpan);

 private:
  static int countPlaces(const Rule& rule) {
    return static_cast<int>(namesIn(rule, {NameRole::PlacedVertex}).size());
  }

  const Algebra& algebra() const { return expressions_.algebra(); }
  RuleDefinition& definition() { return result_.definition; }
  int stored(int vertex) const { return algebra().frame().stored(vertex); }

  Value valueOf(const ConstantName& c) const {
    switch (c.type) {
      case Type::Number:
        return algebra().number(c.number);
      case Type::Angle:
        return algebra().angle(c.number);
      case Type::Truth:
        return algebra().truth(c.number != 0);
      case Type::Geometric:
        return algebra().vector({builder_.constant(c.x), builder_.constant(c.y)});
      default:
        return {};
    }
  }

  Node fadeNode() {
    if (fade_ >= 0) return fade_;
    const Node q = builder_.make(Op::Level, std::initializer_list<Node>{});
    fade_ = builder_.divide(builder_.constant(1), q);
    if (settings_.fadeExpression) {
      DiagnosticList silent;  // reported once, with the rule set
      CompileContext quiet{silent, registry_};
      ExpressionCompiler compiler(quiet, *settings_.fadeHome, ExpressionPlace::Level,
                                  Algebra(builder_, {}));
      const Value value = compiler.evaluate(*settings_.fadeExpression);
      if (value.type == Type::Number) fade_ = value.number;
    }
    return fade_;
  }

  template <class... Arguments>
  void tell(Code code, Span span, std::string message, Arguments&&... arguments) {
    expressions_.tell(code, span, std::move(message), std::forward<Arguments>(arguments)...);
    hasErrors_ = true;
  }

  void warn(Code code, Span span, std::string message, std::string help) {
    expressions_.tell(code, span, std::move(message), "", std::move(help));
  }

  void warnIfHiding(const Name& name);
  void markBroken(const std::string& name) {
    broken_.insert(name);
    Local local;
    local.kind = LocalKind::Broken;
    expressions_.locals.emplace(name, std::move(local));
  }
  bool defineLocal(const Name& name, Value value, LocalKind kind);
  void poisonBrokenNames();
  bool tellTooManyVertices();
  void collectPattern();
  void readLevels();
  void compileClause(const Clause& clause);
  void compileLet(const LetClause& clause);
  void compilePlaces(const AtClause& at);
  void compileNear(const NearClause& clause);
  void placeNearVertices();
  void compileWeld(const WeldClause& clause, Span span);
  void compileFar(const FarClause& clause);
  void compilePath(const PathClause& clause, Span span);
  void addZoneOfAct();
  std::optional<ReferenceByLevel> referenceOf(const Place& place);
  std::optional<ToleranceByLevel> toleranceOf(const Tolerance& tolerance, bool& isAny);
  std::optional<ToleranceByLevel> formOf(const Expr& expr);
  std::optional<std::vector<double>> numberByLevel(const Expr& expr, const std::string& what);
  int lastLevel() const;
  void addChain(const Chain& chain);
  void addEdge(const Name& from, const Name& to);
  std::optional<int> matchedVertex(const Name& name, const char* use);
  bool isNewVertexOfRule(const std::string& name) const;
  void compileSlope(const SlopeClause& slope);
  void compileNew(const NewClause& clause);
  void compileElements(const ElementClause& clause);
  void addElement(const Name& kind, const std::vector<Name>& corners);
  std::optional<int> elementVertex(const Name& kind, const Name& name);
  void tellIdleAlternatives();
  void compileZones();
  void compileRequire(const RequireClause& clause);
  void addCompared(const Expr& condition, std::vector<ComparedValue>& compared);
  void compileCost(const CostClause& clause);
  void compileOwnCost(const CostClause& clause, Span span);
  void compilePriority(const PriorityClause& clause, Span span);
  void applyOverrides();
  void warnAboutNames();
  /// A zone clause, evaluated at its place in the text, because definitions stand above their uses.
  struct ReadZone {
    const ZoneClause* text = nullptr;
    std::vector<ExpressionCompiler::Corner> corners;  ///< of a list
    Value shape;                                      ///< of a shape
    Value when;
    bool isRight = false;
  };

  void use(UsedValue::Kind kind, const Value& value, Span span);
  void useZones();
  void tellMissingValues();
  void tellMissingAt(int level, KnownResults known);
  void readZone(const ZoneClause& clause, Span span);
  std::shared_ptr<const AF2FreeZoneDef> cornerZone(const ReadZone& zone);
  ShapeValue shapeOf(const ReadZone& zone);
  void listNamesBelow();
  std::vector<std::int8_t> cornerVerticesOf(const ShapeValue& shape);
  static ShapeValue unionOf(std::vector<ShapeValue> shapes);
  Value oneShape(const Expr& expr);
  bool isShapeClause(const ZoneClause& clause) { return clause.corners.size() == 1; }

  const Module& home_;
  const Registry& registry_;
  const SharedSettings& settings_;
  const Rule& rule_;
  const MirrorClause* mirror_;
  ProgramBuilder mutable builder_;
  ExpressionCompiler expressions_;
  CompiledRule result_;
  std::map<std::string, int> matched_;
  std::vector<ReadZone> zones_;
  std::vector<UsedValue> used_;
  std::vector<Node> usedNodes_;
  std::map<std::string, bool> atDefined_;
  std::vector<NodePair> newPlaces_;
  std::set<std::string> broken_;
  Node fade_ = -1;
  bool hasErrors_ = false;
  bool isGeneric_ = false;
  bool hasCost_ = false, hasPriority_ = false;
  std::optional<int> far_;  ///< the vertex of `far`
};

}  // namespace af2::dsl
