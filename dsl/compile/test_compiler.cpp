#include "dsl/compile/test_compiler.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "dsl/compile/rule_compiler.h"
#include "dsl/compile/rule_titles.h"
#include "dsl/compile/test_piece.h"
#include "dsl/syntax/titles.h"
#include "dsl/text/words.h"

namespace af2::dsl {
namespace {

class TestCompiler {
 public:
  TestCompiler(CompileContext& context, const Module& module, const Test& test,
               std::span<const CompiledRule> rules, int maxLevel)
      : context_(context),
        module_(module),
        test_(test),
        rules_(rules),
        maxLevel_(maxLevel),
        expressions_(context, module, ExpressionPlace::Test, Algebra(builder_, {})) {
    expressions_.turnInTest = [this](int vertex) {
      return turnAt(result_.piece, static_cast<std::size_t>(vertex));
    };
  }

  std::optional<CompiledTest> compile();

 private:
  template <class... Arguments>
  void tell(Code code, Span span, std::string message, Arguments&&... arguments) {
    expressions_.tell(code, span, std::move(message), std::forward<Arguments>(arguments)...);
    hasErrors_ = true;
  }

  std::optional<double> number(const Expr& expr, const char* what) {
    const auto value = expressions_.constantNumber(expr, what);
    hasErrors_ = hasErrors_ || !value;
    return value;
  }

  std::optional<std::size_t> place(const TestVertex& vertex);
  std::optional<std::size_t> known(const Name& name);
  void addChains(const TestFront& front);
  void addPoints(const TestPoints& points);
  void addColours(const TestColours& colours);
  std::optional<bool> colourAmong(const VertexColour& given, std::size_t vertex);
  void setBase(const TestBase* base);
  void checkEdges();
  const CompiledRule* findRule(const Name& title);
  void readLevel(const TestLevel& level);
  void readSize(const TestSize& size);
  void addExpectation(const Expectation& expectation, Span span);
  std::optional<CompiledExpectation::IsRule> compileOutcome(const ExpectRule& expected,
                                                            bool negated);
  std::optional<CompiledExpectation::Front> compileOutcome(const ExpectFront& expected);
  template <class Outcome>
  void add(std::optional<Outcome> outcome, bool negated, Span span) {
    if (outcome) result_.expectations.push_back({negated, std::move(*outcome), span});
  }

  CompileContext& context_;
  const Module& module_;
  const Test& test_;
  std::span<const CompiledRule> rules_;
  int maxLevel_;
  ProgramBuilder builder_;
  ExpressionCompiler expressions_;
  CompiledTest result_;
  std::map<std::string, std::size_t> vertices_;
  std::map<std::string, Span> places_;
  std::set<std::string> broken_;
  std::set<std::size_t> isolated_;
  Span chainSpan_;
  bool hasErrors_ = false;
};

std::optional<std::size_t> TestCompiler::known(const Name& name) {
  const auto found = vertices_.find(name.text);
  if (found != vertices_.end()) return found->second;
  hasErrors_ = true;
  if (broken_.contains(name.text)) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& [text, index] : vertices_) names.push_back(text);
  const Help help = didYouMean(name.text, names);
  tell(Code::UnknownName, name.span, "this test has no vertex '" + name.text + "'", "",
       help.empty() ? "place it: `" + name.text + " (x, y)` in a `front` or `point` clause above"
                    : help);
  return std::nullopt;
}

std::optional<std::size_t> TestCompiler::place(const TestVertex& vertex) {
  if (!vertex.isPlaced) return known(vertex.name);
  const auto x = number(vertex.x, "a coordinate"), y = number(vertex.y, "a coordinate");
  if (vertices_.contains(vertex.name.text)) {
    tell(Code::DuplicateName, vertex.name.span,
         "the vertex '" + vertex.name.text + "' is placed twice", "",
         "name it without coordinates the second time",
         std::vector<DiagnosticNote>{
             {"placed here", placeOf(module_.source, places_[vertex.name.text])}});
    return vertices_[vertex.name.text];
  }
  const std::size_t index = result_.piece.vertices.size();
  result_.piece.vertices.push_back({x.value_or(0), y.value_or(0)});
  result_.vertexNames.push_back(vertex.name.text);
  vertices_[vertex.name.text] = index;
  places_[vertex.name.text] = vertex.name.span;
  Local local;
  local.value = expressions_.algebra().point(
      {builder_.constant(x.value_or(0)), builder_.constant(y.value_or(0))});
  local.value.vertex = static_cast<int>(index);
  local.kind = LocalKind::Vertex;
  expressions_.locals[vertex.name.text] = std::move(local);
  return index;
}

void TestCompiler::addChains(const TestFront& front) {
  for (const TestChain& chain : front.chains) {
    std::vector<std::size_t> indices;
    for (const TestVertex& vertex : chain)
      if (const auto index = place(vertex)) indices.push_back(*index);
    if (indices.size() == chain.size()) result_.piece.chains.push_back(std::move(indices));
    if (chainSpan_.end == 0) chainSpan_ = chain.front().name.span;
  }
}

void TestCompiler::addPoints(const TestPoints& points) {
  for (const TestVertex& vertex : points.points)
    if (const auto index = place(vertex)) isolated_.insert(*index);
}

void TestCompiler::checkEdges() {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& chain : result_.piece.chains)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const std::string text =
          result_.vertexNames[chain[i]] + " -> " + result_.vertexNames[chain[i + 1]];
      if (result_.piece.vertices[chain[i]] == result_.piece.vertices[chain[i + 1]])
        tell(Code::NotConstant, chainSpan_, "the front edge " + text + " has no length", "",
             "place its ends apart");
      else if (!edges.insert({chain[i], chain[i + 1]}).second)
        tell(Code::DuplicateName, chainSpan_, "the front edge " + text + " is given twice", "",
             "name each edge once");
    }
}

/// The colour that follows for a vertex from the colours given before in its open chain: they
/// alternate along it. The given colour if none was given there; nothing after an error.
std::optional<bool> TestCompiler::colourAmong(const VertexColour& given, std::size_t vertex) {
  const auto& chains = result_.piece.chains;
  const auto isChain = [&](const auto& chain) {
    return chain.front() != chain.back() && std::ranges::count(chain, vertex) == 1;
  };
  const auto chain = std::ranges::find_if(chains, isChain);
  if (chain == chains.end()) {
    tell(Code::IncompleteTest, given.vertex.span,
         "the vertex '" + given.vertex.text + "' is not on an open chain of the front", "",
         "a closed chain is a loop of its own, whose colours decide nothing");
    return std::nullopt;
  }
  const auto at = std::ranges::find(*chain, vertex);
  for (const auto& [other, colour] : result_.piece.colours) {
    const auto there = std::ranges::find(*chain, other);
    if (there != chain->end()) return colour != ((at - there) % 2 != 0);
  }
  return given.colour == 1;
}

void TestCompiler::addColours(const TestColours& colours) {
  for (const VertexColour& given : colours.colours) {
    const auto vertex = known(given.vertex);
    if (!vertex) continue;
    if (given.colour != 0 && given.colour != 1) {
      tell(Code::NotConstant, given.vertex.span, "a colour is 0 or 1");
      continue;
    }
    const auto colour = colourAmong(given, *vertex);
    if (colour && *colour != (given.colour == 1))
      tell(Code::IncompleteTest, given.vertex.span,
           "the colour of '" + given.vertex.text + "' contradicts one that is given before", "",
           "colours alternate along a chain, so one for each chain is enough");
    else if (colour)
      result_.piece.colours.emplace_back(*vertex, *colour);
  }
}

void TestCompiler::setBase(const TestBase* base) {
  if (!base) return;
  const auto from = known(base->from), to = known(base->to);
  if (!from || !to) return;
  for (const auto& chain : result_.piece.chains)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      if (chain[i] == *from && chain[i + 1] == *to) {
        result_.piece.base = {*from, *to};
        return;
      }
  tell(Code::UnknownName, cover(base->from.span, base->to.span),
       base->from.text + " -> " + base->to.text + " is not an edge of this test's front", "",
       "name an edge of a `front` clause");
}

const CompiledRule* TestCompiler::findRule(const Name& title) {
  std::vector<std::string> titles;
  for (const CompiledRule& rule : rules_) {
    if (rule.definition.name == title.text) return &rule;
    titles.push_back(rule.definition.name);
  }
  hasErrors_ = true;
  if (module_.hasBrokenImport) return nullptr;
  for (const auto& [name, imported] : module_.imports)
    if (!imported) return nullptr;
  const auto tellMissing = [&](const Help& help) -> const CompiledRule* {
    tell(Code::UnknownName, title.span, "there is no rule \"" + title.text + "\"", "", help);
    return nullptr;
  };
  if (!context_.mayGuess()) return tellMissing({});
  // A rule with errors is not among the compiled rules; its errors have been reported.
  for (const Item& item : module_.parsed.file.items) {
    if (item.content.index() == 0) return nullptr;
    for (const Name* written : titlesMadeBy(item, module_)) {
      const bool isCompiled = std::ranges::any_of(rules_, [&](const CompiledRule& rule) {
        return isTitleOf(written->text, rule.definition.name);
      });
      if (!isCompiled && isTitleOf(written->text, title.text)) return nullptr;
      if (!isCompiled) titles.push_back(written->text);
    }
  }
  return tellMissing(helpAmong(title.text, titles, "rules of this file"));
}

std::optional<CompiledExpectation::IsRule> TestCompiler::compileOutcome(const ExpectRule& expected,
                                                                        bool negated) {
  CompiledExpectation::IsRule result;
  result.title = expected.title.text;
  const CompiledRule* rule = findRule(expected.title);
  for (const auto& [vertex, value] : expected.bindings) {
    const auto bound = known(value);
    if (!rule) continue;
    const auto& vertices = rule->definition.vertices;
    const auto found = std::find_if(vertices.begin(), vertices.end(),
                                    [&](const PatternVertex& v) { return v.name == vertex.text; });
    if (found == vertices.end()) {
      std::vector<std::string> names;
      for (const PatternVertex& v : vertices) names.push_back(v.name);
      tell(Code::UnknownName, vertex.span,
           "the rule \"" + result.title + "\" matches no vertex '" + vertex.text + "'", "",
           helpAmong(vertex.text, names, "vertices that it matches"));
    } else if (bound) {
      result.bindings.emplace_back(vertex.text, *bound);
    }
  }
  for (const ExpectedReason& reason : expected.reasons) {
    CompiledExpectation::Reason compiled{reason.words, {}};
    for (const Name& name : reason.vertices)
      if (const auto index = known(name)) compiled.vertices.push_back(*index);
    result.reasons.push_back(std::move(compiled));
  }
  if (!expected.reasons.empty() && !negated)
    tell(Code::UnexpectedText, expected.title.span, "`because` says why a rule is not applied", "",
         "write `expect not rule ... because ...`");
  if (!rule) return std::nullopt;
  return result;
}

std::optional<CompiledExpectation::Front> TestCompiler::compileOutcome(
    const ExpectFront& expected) {
  CompiledExpectation::Front result{expected.only, {}};
  for (const auto& chain : expected.chains) {
    std::vector<std::size_t> indices;
    for (const ExpectedVertex& vertex : chain) {
      if (vertex.newIndex > 0)
        indices.push_back(result_.piece.vertices.size() +
                          static_cast<std::size_t>(vertex.newIndex) - 1);
      else if (const auto index = known(vertex.name))
        indices.push_back(*index);
    }
    result.chains.push_back(std::move(indices));
  }
  return result;
}

void TestCompiler::addExpectation(const Expectation& e, Span span) {
  using C = CompiledExpectation;
  const auto add = [&](auto outcome) { this->add(std::move(outcome), e.negated, span); };
  match(
      e.outcome, [](std::monostate) {},
      [&](const ExpectRule& o) { add(compileOutcome(o, e.negated)); },
      [&](const ExpectFront& o) { add(compileOutcome(o)); },
      [&](const ExpectNew& o) {
        const auto x = number(o.x, "a coordinate"), y = number(o.y, "a coordinate");
        if (o.index < 1)
          tell(Code::NotConstant, span, "new vertices are numbered from 1");
        else if (x && y)
          add(std::optional(C::NewAt{static_cast<std::size_t>(o.index) - 1, {*x, *y}}));
      },
      [&](const ExpectElements& o) {
        add(std::optional(C::Elements{static_cast<std::size_t>(o.count)}));
      },
      [&](const ExpectWeld& o) {
        const auto from = known(o.from), into = known(o.into);
        if (from && into) add(std::optional(C::Weld{*from, *into}));
      },
      [&](const ExpectStuck&) { add(std::optional(C::Stuck{})); },
      [&](const ExpectScore& o) {
        if (const auto value = number(o.value, "a score"))
          add(std::optional(C::Score{o.comparison, *value}));
      },
      [&](const ExpectCondition& o) {
        const Value value = expressions_.truth(o.condition, "the argument of `expect`");
        const auto held = value.isAny() ? std::nullopt : builder_.constantValue(value.number);
        const double truth = held.value_or(0);
        hasErrors_ = hasErrors_ || !held;
        if (held) add(std::optional(C::Condition{truth != 0 && !std::isnan(truth)}));
      });
}

void TestCompiler::readLevel(const TestLevel& level) {
  const auto value = number(level.value, "a quality level");
  if (value && (*value < 1 || *value > maxLevel_ || *value != std::floor(*value)))
    tell(Code::NotConstant, level.value.span,
         "a quality level is a whole number from 1 to " + std::to_string(maxLevel_),
         "this is " + shownNumber(*value));
  else if (value)
    result_.piece.level = static_cast<int>(*value);
}

void TestCompiler::readSize(const TestSize& size) {
  const auto value = number(size.value, "a size");
  if (value && !(*value > 0))
    tell(Code::NotConstant, size.value.span, "a size is a positive number");
  else if (value)
    result_.piece.size = *value;
}

std::optional<CompiledTest> TestCompiler::compile() {
  result_.title = test_.title.text;
  result_.span = test_.title.span;
  expressions_.ruleTitle.clear();
  for (const BrokenStretch& stretch : module_.parsed.broken)
    if (stretch.span.begin >= test_.span.begin && stretch.span.end <= test_.span.end) {
      hasErrors_ = true;
      broken_.insert(stretch.names.begin(), stretch.names.end());
    }
  const TestBase* base = nullptr;
  for (const TestClause& clause : test_.clauses) {
    match(
        clause.content, [&](const TestFront& c) { addChains(c); },
        [&](const TestPoints& c) { addPoints(c); }, [&](const TestBase& c) { base = &c; },
        [&](const TestLevel& c) { readLevel(c); }, [&](const TestSize& c) { readSize(c); },
        // What depends on the whole front is compiled when it is known.
        [](const AnyOf<std::monostate, TestColours, Expectation> auto&) {});
  }
  const bool hasFront = !result_.piece.chains.empty();
  if (!hasFront && !hasErrors_)
    tell(Code::IncompleteTest, test_.title.span, "this test has no front", "",
         "add `front p (0, 0) -> r (1, 0);`");
  if (hasFront) {
    if (!hasErrors_) checkEdges();
    result_.piece.base = {result_.piece.chains[0][0], result_.piece.chains[0][1]};
    joinChains(result_.piece);
    for (const auto& chain : result_.piece.chains)
      for (const std::size_t v : chain) isolated_.erase(v);
    result_.piece.isolated.assign(isolated_.begin(), isolated_.end());
  }
  setBase(base);
  for (const TestClause& clause : test_.clauses)
    if (const auto* colours = std::get_if<TestColours>(&clause.content)) addColours(*colours);
  for (const TestClause& clause : test_.clauses)
    if (const auto* expectation = std::get_if<Expectation>(&clause.content))
      addExpectation(*expectation, clause.span);
  if (result_.expectations.empty() && !hasErrors_)
    expressions_.tell(Code::IncompleteTest, test_.title.span, "this test expects nothing", "",
                      "add `expect rule \"...\";`", {}, Severity::Warning);
  if (hasErrors_) return std::nullopt;
  return std::move(result_);
}

}  // namespace

std::optional<CompiledTest> compileTest(CompileContext& context, const Module& module,
                                        const Test& test, std::span<const CompiledRule> rules,
                                        int maxLevel) {
  return TestCompiler(context, module, test, rules, maxLevel).compile();
}

}  // namespace af2::dsl
