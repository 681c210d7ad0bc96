#include "dsl/items.h"
#include "dsl/token_parsers.h"

// The grammar runs over words (lexer.h), not over characters: no skipper, small types, and every
// position is a word. Attributes are put together by semantic actions: `into` sets a member of what
// the rule makes, `append` adds to a list in it. `need` is a part without which the clause is
// broken.

namespace af2::dsl {
namespace {

using namespace parsers;

// ---- expressions --------------------------------------------------------------------------------

#define AF2_RULE(id, attribute, text, ...) \
  struct id##_id __VA_ARGS__ {};           \
  const x3::rule<id##_id, attribute> id = text

AF2_RULE(expr, Expr, "an expression");
AF2_RULE(negation, Expr, "an expression");
AF2_RULE(comparison, Expr, "an expression");
AF2_RULE(unary, Expr, "an expression");
AF2_RULE(power, Expr, "an expression");
AF2_RULE(post, Expr, "an expression");
AF2_RULE(primary, Expr, "an expression");
AF2_RULE(call, Expr, "an expression");
AF2_RULE(arguments, std::vector<Expr>, "arguments in parentheses");
AF2_RULE(bracketed, Expr, "an expression");
AF2_RULE(choice, Expr, "an expression");
AF2_RULE(corner, Expr, "a corner");

constexpr const char* kExpression = kExpressionWanted;

Expr binary(const std::string& symbol, Expr left, Expr right) {
  Expr result;
  result.kind = ExprKind::Binary;
  result.name = symbol;
  result.span = cover(left.span, right.span);
  result.parts.push_back(std::move(left));
  result.parts.push_back(std::move(right));
  return result;
}

/// operand { operator operand }, grouped from the left.
template <class Operand>
struct LeftGrouped : TokenParser<LeftGrouped<Operand>, Expr> {
  LeftGrouped(Operand const& o, std::initializer_list<const char*> s) : operand(o), symbols(s) {}
  Operand operand;
  std::vector<const char*> symbols;

  bool isOperator(It first, It last) const {
    if (first == last) return false;
    for (const char* symbol : symbols)
      if (first->is(symbol)) return true;
    return false;
  }

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const& context, RContext& rcontext,
             Attribute& attribute) const {
    Expr left;
    if (!operand.parse(first, last, context, rcontext, left)) return false;
    while (isOperator(first, last)) {
      const std::string symbol = first->text;
      ++first;
      Expr right;
      if (!operand.parse(first, last, context, rcontext, right))
        boost::throw_exception(x3::expectation_failure<It>(first, kExpression));
      left = binary(symbol, std::move(left), std::move(right));
    }
    x3::traits::move_to(std::move(left), attribute);
    return true;
  }
};

template <class Operand>
auto leftGrouped(Operand const& operand, std::initializer_list<const char*> symbols) {
  return LeftGrouped<Operand>(operand, symbols);
}

const auto wrap = [](ExprKind kind) {
  return [kind](auto& context) {
    Expr& result = x3::_val(context);
    result.kind = kind;
    result.parts.push_back(std::move(x3::_attr(context)));
  };
};
/// What was read so far becomes the first part of an expression of another kind.
const auto becomePart = [](Expr& value, ExprKind kind) {
  Expr part = std::move(value);
  value = Expr{};
  value.kind = kind;
  value.parts.push_back(std::move(part));
};
const auto addPart = [](auto& context) {
  x3::_val(context).parts.push_back(std::move(x3::_attr(context)));
};
const auto beginComparison = [](auto& context) {
  becomePart(x3::_val(context), ExprKind::Binary);
  x3::_val(context).name = x3::_attr(context).text;
};
const auto beginRange = [](auto& context) { becomePart(x3::_val(context), ExprKind::In); };
const auto beginFade = [](auto& context) { becomePart(x3::_val(context), ExprKind::Fade); };
const auto beginPower = [](auto& context) {
  becomePart(x3::_val(context), ExprKind::Binary);
  x3::_val(context).name = "^";
};

const auto sum = leftGrouped(leftGrouped(unary, {"*", "/"}), {"+", "-"});
const auto shapeSum = leftGrouped(sum, {"|", "&"});

const auto expr_def = leftGrouped(leftGrouped(negation, {"and"}), {"or"});
const auto negation_def = spanned(
    (word("not") >> need(comparison, kExpression)[wrap(ExprKind::Not)]) | comparison[assign]);

const OneOf compareWord{"<", "<=", ">", ">=", "==", "!="};
const auto comparison_def =
    spanned(shapeSum[assign] >>
            -((compareWord[beginComparison] >> need(shapeSum, kExpression)[addPart]) |
              (Word("in") >> x3::eps[beginRange] >> need(shapeSum, kExpression)[addPart] >>
               need("..") >> need(shapeSum, kExpression)[addPart])));

const auto unary_def =
    spanned((word("-") >> need(power, kExpression)[wrap(ExprKind::Negate)]) | power[assign]);
const auto power_def = spanned(
    post[assign] >> -(word("^") >> x3::eps[beginPower] >> need(unary, kExpression)[addPart]));

const auto takeMember = [](auto& context) {
  Expr& value = x3::_val(context);
  Name& member = x3::_attr(context);
  const bool isCoordinate = member.text == "x" || member.text == "y";
  if (value.kind == ExprKind::Name && !isCoordinate) {
    value.kind = ExprKind::Imported;
    value.qualifier = std::move(value.name);
  } else {
    const Span from = value.span;
    becomePart(value, ExprKind::Member);
    value.span = cover(from, member.span);
  }
  value.span = cover(value.span, member.span);
  value.name = std::move(member.text);
};
const auto takeArguments = [](auto& context) {
  Expr& value = x3::_val(context);
  if (value.kind != ExprKind::Imported) {
    x3::_pass(context) = false;  // only functions of a library are called behind a dot
    return;
  }
  value.kind = ExprKind::Call;
  value.parts = std::move(x3::_attr(context));
};
const auto post_def =
    spanned(primary[assign] >>
            *(word(".") >> need(anyName, "x or y")[takeMember] >> -(arguments[takeArguments])));

const auto setName = [](ExprKind kind) {
  return [kind](auto& context) {
    x3::_val(context).kind = kind;
    x3::_val(context).name = std::move(x3::_attr(context).text);
    x3::_val(context).span = x3::_attr(context).span;
  };
};
const auto setArguments = [](auto& context) {
  x3::_val(context).kind = ExprKind::Call;
  x3::_val(context).parts = std::move(x3::_attr(context));
};
const auto closeBracket = [](auto& context) {
  Expr& value = x3::_val(context);
  value.kind = value.parts.size() == 1 ? ExprKind::Paren : ExprKind::Tuple;
};
const auto setIf = [](auto& context) { x3::_val(context).kind = ExprKind::If; };

const auto arguments_def = word("(") >>
                           (word(")") | (list(corner, push, kExpression) >> need(")")));
const auto call_def = name[setName(ExprKind::Name)] >> -(arguments[setArguments]);
const auto bracketed_def = word("(") >> list(corner, addPart, kExpression) >>
                           need(")") >> x3::eps[closeBracket];
const auto choice_def = word("if") >> x3::eps[setIf] >> need(expr, "a condition")[addPart] >>
                        need("then") >> need(expr, kExpression)[addPart] >> need("else") >>
                        need(expr, kExpression)[addPart];
const auto primary_def =
    spanned(number[assign] | choice[assign] | call[assign] | bracketed[assign]);

/// preferred => limit
const auto corner_def = spanned(expr[assign] >> -(word("=>") >> x3::eps[beginFade] >>
                                                  need(expr, kExpression)[addPart] >>
                                                  need(!word("=>"), kNoSecondFade)));

BOOST_SPIRIT_DEFINE(expr, negation, comparison, unary, power, post, primary, call, arguments,
                    bracketed, choice, corner)

// ---- clauses of rules ---------------------------------------------------------------------------

AF2_RULE(chain, Chain, "a chain of front vertices");
AF2_RULE(tolerance, Tolerance, "a tolerance");
AF2_RULE(place, Place, "a vertex with its place");
AF2_RULE(definition, Definition, "a name with its value");
AF2_RULE(levels, LevelRange, "quality levels");
AF2_RULE(meta, MetaClause, "meta");
AF2_RULE(metaEntry, MetaEntry, "an entry");

constexpr const char* kVertex = "the name of a vertex";
constexpr const char* kString = "a string";
constexpr const char* kName = "a name";

const auto chain_def = name[push] >> need("->") >> need(name, kVertex)[push] >>
                       *(word("->") >> need(name, kVertex)[push]);
const auto tolerance_def = spanned(
    word("~") >> (word("any")[setFlag(&Tolerance::any)] |
                  need(expr, "a weight, a form (xx, xy, yy) or 'any'")[into(&Tolerance::form)]));
const auto place_def = name[into(&Place::name)] >> need("(") >>
                       need(expr, kExpression)[into(&Place::x)] >> need(",") >>
                       need(expr, kExpression)[into(&Place::y)] >> need(")") >>
                       -(tolerance[into(&Place::tolerance)]);
const auto definition_def = name[into(&Definition::name)] >> need("=") >>
                            need(expr, kExpression)[into(&Definition::value)];
const auto levels_def = word("quality") >>
                        need(expr, "a quality level")[into(&LevelRange::first)] >>
                        -(word("..") >> need(expr, "a quality level")[into(&LevelRange::last)]);
const auto metaEntry_def = anyName[into(&MetaEntry::key)] >>
                           need(string, kString)[into(&MetaEntry::value)] >> need(";");
const auto meta_def = word("meta") >> need("{") >> *metaEntry[append(&MetaClause::entries)] >>
                      need("}");

BOOST_SPIRIT_DEFINE(chain, tolerance, place, definition, levels, meta, metaEntry)

AF2_RULE(frontClause, FrontClause, "front");
AF2_RULE(atClause, AtClause, "at");
AF2_RULE(slopeClause, SlopeClause, "slope");
AF2_RULE(letClause, LetClause, "let");
AF2_RULE(newClause, NewClause, "new");
AF2_RULE(zoneClause, ZoneClause, "zone");
AF2_RULE(corners, std::vector<Name>, "the vertices of an element");
AF2_RULE(elementClause, ElementClause, "an element");
AF2_RULE(requireClause, RequireClause, "require");
AF2_RULE(costClause, CostClause, "cost");
AF2_RULE(priorityClause, PriorityClause, "priority");
AF2_RULE(clause, Clause, "a clause", : Recovering<SyntaxUnit::Clause>);

const auto frontClause_def = word("front") >> parts(SyntaxUnit::Clause, ListPart::Walk, chain,
                                                    append(&FrontClause::chains), kVertex) >>
                             clauseEnd;
const auto atClause_def = word("at") >> parts(SyntaxUnit::Clause, ListPart::Position, place,
                                              append(&AtClause::places), kVertex) >>
                          clauseEnd;
const auto slopeClause_def = word("slope") >> need(name, kVertex)[into(&SlopeClause::from)] >>
                             need("->") >> need(name, kVertex)[into(&SlopeClause::to)] >>
                             need(tolerance, "~")[into(&SlopeClause::tolerance)] >> clauseEnd;
const auto letClause_def = word("let") >> parts(SyntaxUnit::Clause, ListPart::Assignment,
                                                definition, append(&LetClause::values), kName) >>
                           clauseEnd;
const auto newClause_def = word("new") >>
                           parts(SyntaxUnit::Clause, ListPart::Assignment, definition,
                                 append(&NewClause::vertices), kVertex) >>
                           clauseEnd;
const auto zoneClause_def =
    word("zone") >> parts(SyntaxUnit::Clause, ListPart::Expression, corner,
                          append(&ZoneClause::corners), "a corner or a shape") >>
    -(word("when") >> need(expr, "a condition")[into(&ZoneClause::when)]) >> clauseEnd;
const auto corners_def = need(name, kVertex)[push] >> need(name, kVertex)[push] >>
                         need(name, kVertex)[push] >> *name[push];
const OneOf elementKind{"tri", "quad", "poly"};
const auto elementClause_def =
    elementKind[into(&ElementClause::kind)] >>
    list(corners, append(&ElementClause::elements), kVertex) >> clauseEnd;
const auto requireClause_def = word("require") >>
                               parts(SyntaxUnit::Clause, ListPart::Expression, expr,
                                     append(&RequireClause::conditions), "a condition") >>
                               clauseEnd;
const auto costClause_def = word("cost") >>
                            need(expr, kExpression)[into(&CostClause::value)] >> clauseEnd;
const auto priorityClause_def =
    word("priority") >> need(unary, "a whole number")[into(&PriorityClause::value)] >> clauseEnd;

BOOST_SPIRIT_DEFINE(frontClause, atClause, slopeClause, letClause, newClause, zoneClause, corners,
                    elementClause, requireClause, costClause, priorityClause)

// ---- mirror -------------------------------------------------------------------------------------

AF2_RULE(mirrorVertex, MirrorOverride::Vertex, "a vertex with its tolerance");
AF2_RULE(mirrorPart, MirrorOverride, "at, quality or cost", : Recovering<SyntaxUnit::MirrorPart>);
AF2_RULE(mirrorClause, MirrorClause, "mirror");

const auto beginTolerances = [](auto& context) {
  x3::_val(context).tolerances.push_back(std::move(x3::_attr(context)));
};
const auto mirrorVertex_def = name[into(&MirrorOverride::Vertex::name)] >>
                              need(tolerance, "~")[into(&MirrorOverride::Vertex::tolerance)];
const auto mirrorPart_def = spanned(
    !word("}") >> ((word("at") >> list(mirrorVertex, beginTolerances, kVertex) >> mirrorPartEnd) |
                   (levels[into(&MirrorOverride::levels)] >> mirrorPartEnd) |
                   costClause[into(&MirrorOverride::cost)] |
                   (!atBlockEnd >> need(Nothing(), "'at', 'quality' or 'cost'"))));
const auto mirrorClause_def =
    word("mirror") >>
    need(string, "the mirror rule's title in quotes")[into(&MirrorClause::title)] >>
    (word(";") | (need("{", "; or {") >> x3::eps[setFlag(&MirrorClause::hasBody)] >>
                  *mirrorPart[append(&MirrorClause::overrides)] >> need("}")));

const auto clause_def =
    spanned(!word("}") >> !atBlockEnd >>
            (frontClause[content] | atClause[content] | slopeClause[content] | letClause[content] |
             newClause[content] | zoneClause[content] | elementClause[content] |
             requireClause[content] | costClause[content] | priorityClause[content] |
             meta[content] | mirrorClause[content] | need(Nothing(), kClause)));

BOOST_SPIRIT_DEFINE(mirrorVertex, mirrorPart, mirrorClause, clause)

// ---- rules --------------------------------------------------------------------------------------

/// What stands before the brace; apart, so that a fault in it does not hide the clauses.
struct RuleHeader {
  Name title;
  std::optional<Family> family;
  LevelRange levels;
};

AF2_RULE(family, Family, "for");
AF2_RULE(ruleHeader, RuleHeader, "a rule", : Recovering<SyntaxUnit::RuleHeader>);
AF2_RULE(rule, Rule, "a rule");
AF2_RULE(instance, Instance, "an instance of a template");
AF2_RULE(parameters, std::vector<Name>, "parameters");
AF2_RULE(templateItem, Template, "a template");

const auto family_def = word("for") >> need("(") >> list(name, append(&Family::names), kName) >>
                        need(")") >> need("in") >>
                        list(sum, append(&Family::tuples), "values in parentheses");
const auto ruleHeader_def = word("rule") >>
                            need(string, "the rule's title in quotes")[into(&RuleHeader::title)] >>
                            -family[into(&RuleHeader::family)] >>
                            need(levels, "quality")[into(&RuleHeader::levels)] >>
                            need(&OpenBrace(true), "{");
const auto setHeader = [](auto& context) {
  Rule& value = x3::_val(context);
  RuleHeader& header = x3::_attr(context);
  value.title = std::move(header.title);
  value.family = std::move(header.family);
  value.levels = std::move(header.levels);
};
const auto rule_def =
    spanned(&Word("rule") >> ruleHeader[setHeader] >> need(OpenBrace(false), "{") >>
            *clause[append(&Rule::clauses)] >> need("}"));
const auto instance_def = word("rule") >> string[into(&Instance::title)] >> word("=") >>
                          need(post, "template(values)")[into(&Instance::call)] >> itemEnd;
const auto parameters_def = need("(") >> list(name, push, kName) >> need(")");
const auto templateItem_def = word("template") >> need(name, kName)[into(&Template::name)] >>
                              parameters[into(&Template::parameters)] >>
                              need(rule, "rule")[into(&Template::rule)];

BOOST_SPIRIT_DEFINE(family, ruleHeader, rule, instance, parameters, templateItem)

// ---- rule sets ----------------------------------------------------------------------------------

AF2_RULE(elementsSetting, ElementsSetting, "elements");
AF2_RULE(matchSetting, MatchSetting, "match");
AF2_RULE(fadeSetting, FadeSetting, "fade");
AF2_RULE(scoreSetting, ScoreSetting, "score");
AF2_RULE(acceptSetting, AcceptSetting, "accept");
AF2_RULE(orderSetting, OrderSetting, "front by");
AF2_RULE(rowsArgument, MetaEntry, "an argument");
AF2_RULE(rowsSetting, RowsSetting, "front rows");
AF2_RULE(classesSetting, ClassesSetting, "classes");
AF2_RULE(scaleSetting, ScaleSetting, "scale");
AF2_RULE(paritySetting, ParitySetting, "parity");
AF2_RULE(setting, Setting, "a setting", : Recovering<SyntaxUnit::Setting>);
AF2_RULE(ruleSet, RuleSetBlock, "a rule set");

const auto elementsSetting_def =
    word("elements") >>
    list(elementKind, append(&ElementsSetting::kinds), "tri, quad or poly") >> settingEnd;
const auto matchSetting_def = word("match") >>
                              need(expr, kExpression)[into(&MatchSetting::value)] >> settingEnd;
const auto fadeSetting_def = word("fade") >>
                             need(expr, kExpression)[into(&FadeSetting::value)] >> settingEnd;
const OneOf foldWord{"max", "sum", "mean"};
const auto scoreSetting_def = word("score") >>
                              need(foldWord, "max, sum or mean")[into(&ScoreSetting::fold)] >>
                              need("of") >>
                              need(expr, "a metric")[into(&ScoreSetting::metric)] >> settingEnd;
const auto acceptSetting_def =
    word("accept") >> need(expr, "a condition")[into(&AcceptSetting::condition)] >> settingEnd;
const auto orderSetting_def = word("front") >> word("by") >>
                              parts(SyntaxUnit::Setting, ListPart::Expression, expr,
                                    append(&OrderSetting::keys), kExpression) >>
                              settingEnd;
const auto rowsArgument_def = anyName[into(&MetaEntry::key)] >> need(":") >>
                              need(anyName, kName)[into(&MetaEntry::value)];
const auto rowsSetting_def = word("front") >> need("rows", "'by' or 'rows'") >>
                             -(word("(") >> list(rowsArgument, append(&RowsSetting::arguments),
                                                 "start: smallest_turn") >>
                               need(")")) >>
                             settingEnd;
const auto classesSetting_def =
    word("classes") >> need(sum, "a range such as 1..50")[into(&ClassesSetting::first)] >>
    need("..") >> need(sum, "a whole number")[into(&ClassesSetting::last)] >> settingEnd;
const auto scaleSetting_def =
    word("scale") >> need(OneOf{"h", "base"}, "h or base")[into(&ScaleSetting::unit)] >> settingEnd;
const auto paritySetting_def =
    word("parity") >>
    need(OneOf{"even", "any"}, "even or any")[into(&ParitySetting::parity)] >> settingEnd;
const auto setting_def =
    spanned(!word("}") >> !atBlockEnd >>
            (elementsSetting[content] | matchSetting[content] | fadeSetting[content] |
             scoreSetting[content] | acceptSetting[content] | orderSetting[content] |
             rowsSetting[content] | classesSetting[content] | scaleSetting[content] |
             paritySetting[content] | meta[content] | need(Nothing(), kSetting)));
const auto ruleSet_def =
    word("ruleset") >> need(string, "the rule set's name in quotes")[into(&RuleSetBlock::name)] >>
    -(word("extends") >> need(string, "a rule set's name in quotes")[into(&RuleSetBlock::base)]) >>
    need("{") >> *setting[append(&RuleSetBlock::settings)] >> need("}");

BOOST_SPIRIT_DEFINE(elementsSetting, matchSetting, fadeSetting, scoreSetting, acceptSetting,
                    orderSetting, rowsArgument, rowsSetting, classesSetting, scaleSetting,
                    paritySetting, setting, ruleSet)

// ---- tests --------------------------------------------------------------------------------------

AF2_RULE(testVertex, TestVertex, "a vertex");
AF2_RULE(placedVertex, TestVertex, "a vertex with its place");
AF2_RULE(testChain, TestChain, "a chain of vertices");
AF2_RULE(testFront, TestFront, "front");
AF2_RULE(testPoints, TestPoints, "point");
AF2_RULE(testBase, TestBase, "base");
AF2_RULE(testLevel, TestLevel, "class");
AF2_RULE(testSize, TestSize, "size");
AF2_RULE(expectedVertex, ExpectedVertex, "a vertex");
AF2_RULE(expectedChain, std::vector<ExpectedVertex>, "a chain of vertices");
AF2_RULE(reasonWords, ExpectRule, "a reason");
AF2_RULE(expectRule, ExpectRule, "rule");
AF2_RULE(expectNew, ExpectNew, "new");
AF2_RULE(expectFront, ExpectFront, "front");
AF2_RULE(expectElements, ExpectElements, "elements");
AF2_RULE(expectScore, ExpectScore, "score");
AF2_RULE(expectCondition, ExpectCondition, "a condition");
AF2_RULE(binding, Definition, "a binding");
AF2_RULE(expectation, Expectation, "expect");
AF2_RULE(testClause, TestClause, "a test clause", : Recovering<SyntaxUnit::TestClause>);
AF2_RULE(test, Test, "a test");
AF2_RULE(propertyExpectation, Expr, "expect");
AF2_RULE(property, Property, "a property");

const auto setPlaced = setFlag(&TestVertex::isPlaced);
const auto coordinates = [](auto xMember, auto yMember, const char* open) {
  return need("(", open) >> need(expr, kExpression)[into(xMember)] >> need(",") >>
         need(expr, kExpression)[into(yMember)] >> need(")");
};
const auto testVertex_def = name[into(&TestVertex::name)] >>
                            -(&Word("(") >> x3::eps[setPlaced] >>
                              coordinates(&TestVertex::x, &TestVertex::y, "("));
const auto placedVertex_def = name[into(&TestVertex::name)] >> x3::eps[setPlaced] >>
                              coordinates(&TestVertex::x, &TestVertex::y, "(");
const auto testChain_def = testVertex[push] >> need("->") >> need(testVertex, kVertex)[push] >>
                           *(word("->") >> need(testVertex, kVertex)[push]);
const auto testFront_def = word("front") >> parts(SyntaxUnit::TestClause, ListPart::Position,
                                                  testChain, append(&TestFront::chains), kVertex) >>
                           testClauseEnd;
const auto testPoints_def = word("point") >>
                            parts(SyntaxUnit::TestClause, ListPart::Position, placedVertex,
                                  append(&TestPoints::points), kVertex) >>
                            testClauseEnd;
const auto testBase_def = word("base") >> need(name, kVertex)[into(&TestBase::from)] >>
                          need("->") >> need(name, kVertex)[into(&TestBase::to)] >> testClauseEnd;
const auto testLevel_def = word("class") >>
                           need(expr, "a whole number")[into(&TestLevel::value)] >> testClauseEnd;
const auto testSize_def = word("size") >>
                          need(expr, kExpression)[into(&TestSize::value)] >> testClauseEnd;

const auto expectedVertex_def =
    (word("new") >>
     need(ordinal, "the number of a new vertex, from 1")[into(&ExpectedVertex::newIndex)]) |
    name[into(&ExpectedVertex::name)];
const auto expectedChain_def = expectedVertex[push] >> need("->") >>
                               need(expectedVertex, kVertex)[push] >>
                               *(word("->") >> need(expectedVertex, kVertex)[push]);

const auto setReason = [](const char* reason) {
  return [reason](auto& context) { x3::_val(context).reason = reason; };
};
const auto addVertex = append(&ExpectRule::reasonVertices);
const OneOf simpleReason{"class",     "pattern",  "require", "novalue", "shape",
                         "convexity", "inverted", "score",   "beaten"};
const auto takeReason = [](auto& context) { x3::_val(context).reason = x3::_attr(context).text; };
const auto takeReasonOf = [](auto& context) {
  x3::_val(context).reason = std::move(x3::_attr(context).reason);
  x3::_val(context).reasonVertices = std::move(x3::_attr(context).reasonVertices);
};
const auto reasonWords_def =
    simpleReason[takeReason] |
    (word("zone") >> need("hit") >> need("by") >>
     ((word("edge") >> x3::eps[setReason("zone hit by edge")] >> need(name, kVertex)[addVertex] >>
       need("->") >> need(name, kVertex)[addVertex]) |
      (need("vertex", "'edge' or 'vertex'") >> x3::eps[setReason("zone hit by vertex")] >>
       need(name, kVertex)[addVertex])));
const auto binding_def = name[into(&Definition::name)] >> need("=") >>
                         need(call, kVertex)[into(&Definition::value)];
const auto addBinding = [](auto& context) {
  Definition& d = x3::_attr(context);
  x3::_val(context).bindings.emplace_back(d.name, Name{d.value.name, d.value.span});
};
const auto expectRule_def =
    word("rule") >> need(string, "a rule's title in quotes")[into(&ExpectRule::title)] >>
    -(word("with") >> list(binding, addBinding, "c = vertex")) >>
    -(word("because") >>
      need(reasonWords,
           "a reason such as 'zone hit by edge u -> v', 'pattern', 'score'")[takeReasonOf]);
const auto expectNew_def = word("new") >>
                           need(integer, "the number of a new vertex")[into(&ExpectNew::index)] >>
                           need("at") >> coordinates(&ExpectNew::x, &ExpectNew::y, "(");
const auto expectFront_def = word("front") >> -(word("only")[setFlag(&ExpectFront::only)]) >>
                             list(expectedChain, append(&ExpectFront::chains), kVertex);
const auto expectElements_def = word("elements") >>
                                need(integer, "a whole number")[into(&ExpectElements::count)];
const auto setComparison = [](auto& context) {
  x3::_val(context).comparison = x3::_attr(context).text;
};
const auto expectScore_def = word("score") >> compareWord[setComparison] >>
                             need(sum, kExpression)[into(&ExpectScore::value)];
const auto expectCondition_def = expr[into(&ExpectCondition::condition)] >> x3::eps;

const auto setOutcome = into(&Expectation::outcome);
const auto setStuck = [](auto& context) { x3::_val(context).outcome = ExpectStuck{}; };
const auto expectation_def =
    word("expect") >> -(word("not")[setFlag(&Expectation::negated)]) >>
    (expectRule[setOutcome] | expectNew[setOutcome] | expectFront[setOutcome] |
     (&(Word("elements") >> integer) >> expectElements[setOutcome]) |
     (Word("stuck") >> &Word(";"))[setStuck] | expectScore[setOutcome] |
     need(expectCondition,
          "rule, new, front, elements, stuck, score or a condition")[setOutcome]) >>
    testClauseEnd;

const auto testClause_def =
    spanned(!word("}") >> !atBlockEnd >>
            (testFront[content] | testPoints[content] | testBase[content] | testLevel[content] |
             testSize[content] | expectation[content] | need(Nothing(), kTestClause)));
const auto test_def =
    spanned(word("test") >> need(string, "the test's title in quotes")[into(&Test::title)] >>
            need("{") >> *testClause[append(&Test::clauses)] >> need("}"));

const auto propertyExpectation_def = word("expect") >>
                                     need(expr, "a condition")[assign] >> testClauseEnd;
const auto property_def = word("property") >>
                          need(string, "the property's title in quotes")[into(&Property::title)] >>
                          need("forall") >> need("match") >> need("of") >>
                          need(string, "a rule's title in quotes")[into(&Property::rule)] >>
                          -(word(",") >> need(name, kName)[into(&Property::variable)] >>
                            need("in") >> need(sum, "a range")[into(&Property::first)] >>
                            need("..") >> need(sum, "a whole number")[into(&Property::last)]) >>
                          need("{") >> *propertyExpectation[append(&Property::expectations)] >>
                          need("}");

BOOST_SPIRIT_DEFINE(testVertex, placedVertex, testChain, testFront, testPoints, testBase, testLevel,
                    testSize, expectedVertex, expectedChain, reasonWords, expectRule, expectNew,
                    expectFront, expectElements, expectCondition, expectScore, binding, expectation,
                    testClause, test, propertyExpectation, property)

// ---- files --------------------------------------------------------------------------------------

AF2_RULE(importItem, Import, "import");
AF2_RULE(useItem, Use, "use");
AF2_RULE(constant, Constant, "const");
AF2_RULE(function, Function, "def");
AF2_RULE(metric, Metric, "metric");
AF2_RULE(fileItem, Item, "an item", : Recovering<SyntaxUnit::Item>);
AF2_RULE(wholeFile, File, "a file");

const auto importItem_def = word("import") >>
                            need(string, "a path in quotes")[into(&Import::path)] >>
                            -(word("as") >> need(name, kName)[into(&Import::alias)]) >> itemEnd;
const auto useItem_def =
    word("use") >> need(name, "the name of an import")[into(&Use::library)] >> need(".") >>
    (word("*") | need(string, "* or a rule's title in quotes")[into(&Use::rule)]) >>
    -(word("except") >> list(string, append(&Use::except), kString)) >> itemEnd;
const auto constant_def = word("const") >> need(name, kName)[into(&Constant::name)] >> need("=") >>
                          need(expr, kExpression)[into(&Constant::value)] >> itemEnd;
const auto function_def = word("def") >> need(name, kName)[into(&Function::name)] >>
                          parameters[into(&Function::parameters)] >> need("=") >>
                          need(corner, kExpression)[into(&Function::value)] >> itemEnd;
const auto metric_def = word("metric") >> need(name, kName)[into(&Metric::name)] >>
                        parameters[into(&Metric::parameters)] >> need("=") >>
                        need(expr, kExpression)[into(&Metric::value)] >> itemEnd;
const auto fileItem_def =
    spanned(!atFileEnd >>
            (importItem[content] | useItem[content] | constant[content] | function[content] |
             metric[content] | ruleSet[content] |
             (&(Word("rule") >> string >> Word("=")) >> instance[content]) | rule[content] |
             templateItem[content] | test[content] | property[content] | need(Nothing(), kItem)));
const auto wholeFile_def = *fileItem[append(&File::items)];

BOOST_SPIRIT_DEFINE(importItem, useItem, constant, function, metric, fileItem, wholeFile)

}  // namespace

const Token* parseItems(const Token* first, const Token* last, SyntaxErrors& errors, File& file) {
  const auto grammar = x3::with<ParsingTag>(std::ref(errors))[wholeFile];
  x3::parse(first, last, grammar, file);
  return first;
}

}  // namespace af2::dsl
