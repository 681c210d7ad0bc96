#include "dsl/syntax/items.h"
#include "dsl/syntax/rule_grammar.h"
#include "dsl/syntax/test_grammar.h"

// The grammar reads words (lexer.h), not characters: it needs no skipper, its types stay small, and
// every position is a word. Semantic actions build the attributes: `into` sets a member of the
// attribute of the rule, `append` adds to a list in it. `need` is a required part; without it the
// clause is broken.

namespace af2::dsl {
namespace {

using namespace parsers;

// ---- rule sets ----------------------------------------------------------------------------------

AF2_RULE(elementsSetting, ElementsSetting, "elements");
AF2_RULE(matchSetting, MatchSetting, "match");
AF2_RULE(fadeSetting, FadeSetting, "fade");
AF2_RULE(scoreSetting, ScoreSetting, "score");
AF2_RULE(acceptSetting, AcceptSetting, "accept");
AF2_RULE(clearSetting, ClearSetting, "clear");
AF2_RULE(countsSetting, CountsSetting, "counts");
AF2_RULE(columnsSetting, ColumnsSetting, "columns");
AF2_RULE(rowEndSetting, RowEndSetting, "at row");
AF2_RULE(endSetting, EndSetting, "at end");
AF2_RULE(orderSetting, OrderSetting, "front by");
AF2_RULE(rowsArgument, MetaEntry, "an argument");
AF2_RULE(rowsSetting, RowsSetting, "front rows");
AF2_RULE(classesSetting, ClassesSetting, "classes");
AF2_RULE(scaleSetting, ScaleSetting, "scale");
AF2_RULE(paritySetting, ParitySetting, "parity");
AF2_RULE(finishSetting, FinishSetting, "finish");
AF2_RULE(setting, Setting, "a setting", : Recovering<SyntaxUnit::Setting>);
AF2_RULE(ruleSet, RuleSetBlock, "a rule set");

const auto elementsSetting_def =
    word("elements") >>
    list(elementKind, append(&ElementsSetting::kinds), "tri, quad or poly") >> settingEnd;
const auto matchSetting_def = word("match") >>
                              need(expr, kExpression)[into(&MatchSetting::value)] >> settingEnd;
const auto fadeSetting_def = word("fade") >>
                             need(expr, kExpression)[into(&FadeSetting::value)] >> settingEnd;
const OneOf foldWord(kFolds);
const auto scoreSetting_def = word("score") >>
                              need(foldWord, "max, sum or mean")[into(&ScoreSetting::fold)] >>
                              need("of") >>
                              need(expr, "a metric")[into(&ScoreSetting::metric)] >> settingEnd;
const auto acceptSetting_def = word("accept") >>
                               parts(SyntaxUnit::Setting, ListPart::Expression, expr,
                                     append(&AcceptSetting::conditions), "a condition") >>
                               settingEnd;
const auto clearSetting_def = word("clear") >>
                              need(expr, kExpression)[into(&ClearSetting::value)] >> settingEnd;
const auto countsSetting_def = word("counts") >>
                               parts(SyntaxUnit::Setting, ListPart::Expression, expr,
                                     append(&CountsSetting::bounds), "an angle") >>
                               settingEnd;
const auto columnsSetting_def =
    word("columns") >> need(sum, "a range such as 0.7..1.4")[into(&ColumnsSetting::low)] >>
    need("..") >> need(sum, kExpression)[into(&ColumnsSetting::high)] >> need("from") >>
    need("layer") >> need(expr, "a whole number")[into(&ColumnsSetting::layer)] >> settingEnd;
const auto rowEndSetting_def = word("at") >> word("row") >> need("smooth") >>
                               need(expr, "a whole number")[into(&RowEndSetting::rounds)] >>
                               settingEnd;
const auto endSetting_def = word("at") >> need("end", "'row' or 'end'") >> need("clean") >>
                            need(expr, "a whole number")[into(&EndSetting::depth)] >> settingEnd;
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
    word("scale") >> need(OneOf(kScaleUnits), "h or base")[into(&ScaleSetting::unit)] >> settingEnd;
const auto paritySetting_def =
    word("parity") >>
    need(OneOf(kParities), "even or any")[into(&ParitySetting::parity)] >> settingEnd;
const auto finishSetting_def =
    word("finish") >>
    need(OneOf(kFinishes), "shape, score or none")[into(&FinishSetting::finish)] >> settingEnd;
const auto setting_def =
    spanned(!word("}") >> !atBlockEnd >>
            (elementsSetting[content] | matchSetting[content] | fadeSetting[content] |
             scoreSetting[content] | acceptSetting[content] | clearSetting[content] |
             orderSetting[content] | rowsSetting[content] | rowEndSetting[content] |
             endSetting[content] | classesSetting[content] | scaleSetting[content] |
             paritySetting[content] | countsSetting[content] | columnsSetting[content] |
             finishSetting[content] | meta[content] | need(Nothing(), kSetting)));
const auto ruleSet_def =
    word("ruleset") >> need(string, "the rule set's name in quotes")[into(&RuleSetBlock::name)] >>
    -(word("extends") >> need(string, "a rule set's name in quotes")[into(&RuleSetBlock::base)]) >>
    need("{") >> *setting[append(&RuleSetBlock::settings)] >> need("}");

BOOST_SPIRIT_DEFINE(elementsSetting, matchSetting, fadeSetting, scoreSetting, acceptSetting,
                    clearSetting, countsSetting, columnsSetting, rowEndSetting, endSetting,
                    orderSetting, rowsArgument, rowsSetting, classesSetting, scaleSetting,
                    paritySetting, finishSetting, setting, ruleSet)

// ---- files --------------------------------------------------------------------------------------

constexpr const char* kArgumentType = "number, angle, point or vector";

AF2_RULE(importItem, Import, "import");
AF2_RULE(useItem, Use, "use");
AF2_RULE(constant, Constant, "const");
AF2_RULE(function, Function, "def");
AF2_RULE(metric, Metric, "metric");
AF2_RULE(externTypes, std::vector<Name>, "the types of arguments");
AF2_RULE(externItem, Extern, "extern");
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
const auto externTypes_def = -(OneOf(kArgumentTypes)[push] >>
                               *(word(",") >> need(OneOf(kArgumentTypes), kArgumentType)[push])) >>
                             need(")", kArgumentType);
const auto externItem_def =
    word("extern") >> need(OneOf(kExternKinds), "function, shape or metric")[into(&Extern::kind)] >>
    need(name, kName)[into(&Extern::name)] >>
    -(word("(")[setFlag(&Extern::hasList)] >> externTypes[into(&Extern::parameters)]) >>
    -(word(":") >> need(OneOf(kResultTypes), "number, angle or truth")[into(&Extern::result)]) >>
    itemEnd;
const auto fileItem_def =
    spanned(!atFileEnd >>
            (importItem[content] | useItem[content] | constant[content] | function[content] |
             metric[content] | externItem[content] | ruleSet[content] |
             (&(Word("rule") >> string >> Word("=")) >> instance[content]) | rule[content] |
             templateItem[content] | test[content] | property[content] | need(Nothing(), kItem)));
const auto wholeFile_def = *fileItem[append(&File::items)];

BOOST_SPIRIT_DEFINE(importItem, useItem, constant, function, metric, externTypes, externItem,
                    fileItem, wholeFile)

}  // namespace

const Token* parseItems(const Token* first, const Token* last, SyntaxErrors& errors, File& file) {
  const auto grammar = x3::with<ParsingTag>(std::ref(errors))[wholeFile];
  x3::parse(first, last, grammar, file);
  return first;
}

}  // namespace af2::dsl
