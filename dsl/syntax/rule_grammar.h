// The grammar of rules and their clauses. For grammar.cpp alone.
#pragma once

#include "dsl/syntax/expression_grammar.h"

namespace af2::dsl::parsers {

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
AF2_RULE(nearVertex, NearClause::Vertex, "a vertex with its place");
AF2_RULE(nearClause, NearClause, "near");
AF2_RULE(slopeClause, SlopeClause, "slope");
AF2_RULE(letClause, LetClause, "let");
AF2_RULE(newClause, NewClause, "new");
AF2_RULE(zoneClause, ZoneClause, "zone");
AF2_RULE(corners, std::vector<Name>, "the vertices of an element");
AF2_RULE(elementClause, ElementClause, "an element");
AF2_RULE(weldClause, WeldClause, "weld");
AF2_RULE(farClause, FarClause, "far");
AF2_RULE(pathClause, PathClause, "path");
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
const auto nearVertex_def = name[into(&NearClause::Vertex::name)] >> need("of") >>
                            need(expr, kExpression)[into(&NearClause::Vertex::at)] >>
                            need("within") >>
                            need(expr, kExpression)[into(&NearClause::Vertex::reach)];
const auto nearClause_def = word("near") >> parts(SyntaxUnit::Clause, ListPart::Near, nearVertex,
                                                  append(&NearClause::vertices), kVertex) >>
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
const OneOf elementKind(kElementKinds);
const auto elementClause_def =
    elementKind[into(&ElementClause::kind)] >>
    list(corners, append(&ElementClause::elements), kVertex) >> clauseEnd;
const auto weldClause_def = word("weld") >> need(name, kVertex)[into(&WeldClause::from)] >>
                            need("into") >> need(name, kVertex)[into(&WeldClause::into)] >>
                            need("at") >>
                            need(expr, kExpression)[into(&WeldClause::at)] >> clauseEnd;
const auto farClause_def = word("far") >>
                           need(name, kVertex)[into(&FarClause::vertex)] >> clauseEnd;
const auto pathClause_def = word("path") >> need(name, kVertex)[into(&PathClause::from)] >>
                            need("->") >> need(name, kVertex)[into(&PathClause::to)] >>
                            need("by") >>
                            need(expr, kExpression)[into(&PathClause::segments)] >> clauseEnd;
const auto requireClause_def = word("require") >>
                               parts(SyntaxUnit::Clause, ListPart::Expression, expr,
                                     append(&RequireClause::conditions), "a condition") >>
                               clauseEnd;
const auto costClause_def = word("cost") >>
                            need(expr, kExpression)[into(&CostClause::value)] >> clauseEnd;
const auto priorityClause_def =
    word("priority") >> need(unary, "a whole number")[into(&PriorityClause::value)] >> clauseEnd;

BOOST_SPIRIT_DEFINE(frontClause, atClause, nearVertex, nearClause, slopeClause, letClause,
                    newClause, zoneClause, corners, elementClause, weldClause, farClause,
                    pathClause, requireClause, costClause, priorityClause)

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

const auto clause_def = spanned(
    !word("}") >> !atBlockEnd >>
    (frontClause[content] | atClause[content] | nearClause[content] | slopeClause[content] |
     letClause[content] | newClause[content] | zoneClause[content] | elementClause[content] |
     weldClause[content] | farClause[content] | pathClause[content] | requireClause[content] |
     costClause[content] | priorityClause[content] | meta[content] | mirrorClause[content] |
     need(Nothing(), kClause)));

BOOST_SPIRIT_DEFINE(mirrorVertex, mirrorPart, mirrorClause, clause)

// ---- rules --------------------------------------------------------------------------------------

/// The part before the brace. It is a separate rule so that a fault in it does not hide the
/// clauses.
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

}  // namespace af2::dsl::parsers
