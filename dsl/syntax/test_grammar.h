// The grammar of tests and properties. For grammar.cpp alone.
#pragma once

#include "dsl/syntax/rule_grammar.h"

namespace af2::dsl::parsers {

AF2_RULE(testVertex, TestVertex, "a vertex");
AF2_RULE(placedVertex, TestVertex, "a vertex with its place");
AF2_RULE(testChain, TestChain, "a chain of vertices");
AF2_RULE(testFront, TestFront, "front");
AF2_RULE(testPoints, TestPoints, "point");
AF2_RULE(vertexColour, VertexColour, "a vertex and its colour");
AF2_RULE(testColours, TestColours, "colours");
AF2_RULE(testBase, TestBase, "base");
AF2_RULE(testLevel, TestLevel, "class");
AF2_RULE(testSize, TestSize, "size");
AF2_RULE(expectedVertex, ExpectedVertex, "a vertex");
AF2_RULE(expectedChain, std::vector<ExpectedVertex>, "a chain of vertices");
AF2_RULE(reasonWords, ExpectedReason, "a reason");
AF2_RULE(expectRule, ExpectRule, "rule");
AF2_RULE(expectNew, ExpectNew, "new");
AF2_RULE(expectFront, ExpectFront, "front");
AF2_RULE(expectElements, ExpectElements, "elements");
AF2_RULE(expectWeld, ExpectWeld, "weld");
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
const auto setColour = [](auto& context) { x3::_val(context).colour = x3::_attr(context); };
const auto vertexColour_def = name[into(&VertexColour::vertex)] >>
                              need(integer, "a colour, 0 or 1")[setColour];
const auto testColours_def =
    word("colours") >> list(vertexColour, append(&TestColours::colours), kVertex) >> testClauseEnd;
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
  return [reason](auto& context) { x3::_val(context).words = reason; };
};
const auto addVertex = append(&ExpectedReason::vertices);
const OneOf simpleReason(kReasons);
const auto takeReason = [](auto& context) { x3::_val(context).words = x3::_attr(context).text; };
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
const auto addReason = append(&ExpectRule::reasons);
const char* const kReason = "a reason such as 'zone hit by edge u -> v', 'pattern', 'score'";
const auto expectRule_def = word("rule") >>
                            need(string, "a rule's title in quotes")[into(&ExpectRule::title)] >>
                            -(word("with") >> list(binding, addBinding, "c = vertex")) >>
                            -(word("because") >> need(reasonWords, kReason)[addReason] >>
                              *(word("or") >> need(reasonWords, kReason)[addReason]));
const auto expectNew_def = word("new") >>
                           need(integer, "the number of a new vertex")[into(&ExpectNew::index)] >>
                           need("at") >> coordinates(&ExpectNew::x, &ExpectNew::y, "(");
const auto expectFront_def = word("front") >> -(word("only")[setFlag(&ExpectFront::only)]) >>
                             list(expectedChain, append(&ExpectFront::chains), kVertex);
const auto expectElements_def = word("elements") >>
                                need(integer, "a whole number")[into(&ExpectElements::count)];
const auto expectWeld_def = word("weld") >> need(name, kVertex)[into(&ExpectWeld::from)] >>
                            need("into") >> need(name, kVertex)[into(&ExpectWeld::into)];
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
     (&(Word("elements") >> integer) >> expectElements[setOutcome]) | expectWeld[setOutcome] |
     (Word("stuck") >> &Word(";"))[setStuck] | expectScore[setOutcome] |
     need(expectCondition,
          "rule, new, front, elements, weld, stuck, score or a condition")[setOutcome]) >>
    testClauseEnd;

const auto testClause_def = spanned(
    !word("}") >> !atBlockEnd >>
    (testFront[content] | testPoints[content] | testColours[content] | testBase[content] |
     testLevel[content] | testSize[content] | expectation[content] | need(Nothing(), kTestClause)));
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

BOOST_SPIRIT_DEFINE(testVertex, placedVertex, testChain, testFront, testPoints, vertexColour,
                    testColours, testBase, testLevel, testSize, expectedVertex, expectedChain,
                    reasonWords, expectRule, expectNew, expectFront, expectElements, expectWeld,
                    expectCondition, expectScore, binding, expectation, testClause, test,
                    propertyExpectation, property)

}  // namespace af2::dsl::parsers
