#include "dsl/text/keywords.h"

#include <algorithm>

namespace af2::dsl {
namespace {

constexpr WordList<1> kWhen{"when"};
constexpr WordList<3> kAccepted{"score", "scaled_jacobian", "min_angle"};
constexpr WordList<2> kFromLayer{"from", "layer"};
constexpr WordList<4> kAtRowOrEnd{"row", "smooth", "end", "clean"};

constexpr std::array kKeywords{
    // ---- items of a file ------------------------------------------------------------------------
    Keyword{.block = BlockKind::File,
            .word = "import",
            .form = R"_(import "file.af2" as lib;)_",
            .grammar = R"_("import" string [ "as" name ] ";")_",
            .help = "Brings the constants, functions, metrics and templates of another file.",
            .snippet = R"_(import "${1:file.af2}" as ${2:name};$0)_",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{
        .block = BlockKind::File,
        .word = "use",
        .form = R"_(use lib.* except "title";)_",
        .grammar = R"_("use" name "." ( "*" | string ) [ "except" string { "," string } ] ";")_",
        .help = "Takes over the rules of an imported file.",
        .follows = Follows::Header,
        .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "const",
            .form = "const height = 0.866;",
            .grammar = R"_("const" name "=" expr ";")_",
            .help = "A name for a value that needs no match.",
            .snippet = "const ${1:NAME} = ${0:1};",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "def",
            .form = "def top(p, k) = p + (0, k);",
            .grammar = R"_("def" name "(" name { "," name } ")" "=" expr ";")_",
            .help = "Defines a function.",
            .snippet = "def ${1:name}(${2:p, q}) = ${0:mid(p, q)};",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "metric",
            .form = "metric mine(w, u, v, x) = w * dist(u, v);",
            .grammar = R"_("metric" name "(" name { "," name } ")" "=" expr ";")_",
            .help = "Defines a measure of elements: 0 for the ideal element. The corners are the "
                    "last parameters.",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "extern",
            .form = "extern function heat(point) : number;",
            .otherForm = "extern shape egg(point, point, number);",
            .grammar = R"_("extern" ( "function" | "shape" | "metric" ) name)_"
                       "\n"
                       R"_([ "(" [ type { "," type } ] ")" ] [ ":" type ] ";")_",
            .help = "Declares a function, shape or metric that a program or a plugin registers.",
            .snippet = "extern ${1:function} ${2:name}(${3:point}) : ${0:number};",
            .follows = Follows::Header,
            .words = kExternKinds,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "ruleset",
            .form = R"_(ruleset "name" { elements tri; })_",
            .grammar = R"_("ruleset" string [ "extends" string ] "{" { setting } "}")_",
            .help = "The settings that all rules of a file share.",
            .snippet = "ruleset \"${1:name}\" {\n  elements ${2:tri};$0\n}",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "rule",
            .form = R"_(rule "title" quality 1 { ... })_",
            .grammar =
                R"_("rule" string [ "for" "(" name { "," name } ")" "in" tuple { "," tuple } ])_"
                "\n"
                R"_("quality" expr [ ".." expr ] "{" { clause } "}")_",
            .help = "Where the front looks like the pattern and the free zone is empty, put these "
                    "elements.",
            .snippet =
                "rule \"${1:title}\" quality ${2:1} {\n  new  ${3:c} = ${4:mid(a, b) + (0, 0.866)};"
                "\n  zone a, b, ${3:c};\n  tri  a b ${3:c};$0\n}",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "template",
            .form = R"_(template name(k, h) rule "title {k}" quality k { ... })_",
            .grammar = R"_("template" name "(" name { "," name } ")" rule)_",
            .help = "A rule with parameters.",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "test",
            .form = R"_(test "title" { front p (0, 0) -> r (1, 0); expect rule "..."; })_",
            .grammar = R"_("test" string "{" { testclause ";" } "}")_",
            .help = "A piece of front, and the expected result of a step there.",
            .snippet = "test \"${1:title}\" {\n  front  p (0, 0) -> r (1, 0);\n  expect rule "
                       "\"${2:title}\";$0\n}",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::File,
            .word = "property",
            .form = R"_(property "title" forall match of "rule", q in 1..10 { expect ...; })_",
            .grammar = R"_("property" string "forall" "match" "of" string [ "," name "in" range ])_"
                       "\n"
                       R"_("{" { "expect" expr ";" } "}")_",
            .help = "A claim about all matches of a rule.",
            .snippet = "property \"${1:title}\" forall match of \"${2:rule}\" {\n  expect "
                       "${0:condition};\n}",
            .follows = Follows::Header,
            .isReserved = true},

    // ---- clauses of a rule ----------------------------------------------------------------------
    Keyword{.block = BlockKind::Rule,
            .word = "front",
            .form = "front a -> b -> c, d -> e;",
            .grammar = R"_("front" chain { "," chain } ";")_",
            .help = "Chains of front edges that the rule requires.",
            .follows = Follows::Vertices,
            .defines = NameRole::ChainVertex,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "at",
            .form = "at c (0.5, 0.866) ~ 1, d (1, 1) ~ any;",
            .grammar = R"_("at" place { "," place } ";")_",
            .help = "Where a vertex is expected, relative to a, and how far it may deviate.",
            .follows = Follows::VerticesAndForms,
            .defines = NameRole::PlacedVertex,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "near",
            .form = "near c of b + spoke(b) within 0.9;",
            .grammar = R"_("near" nearby { "," nearby } ";")_",
            .help = "A vertex of the front within a distance of a computed place.",
            .follows = Follows::Header,
            .defines = NameRole::PlacedVertex},
    Keyword{.block = BlockKind::Rule,
            .word = "slope",
            .form = "slope b -> c ~ 1;",
            .grammar = R"_("slope" name "->" name tolerance ";")_",
            .help = "A tolerance on the direction and length of an edge of the pattern, not on its "
                    "position.",
            .follows = Follows::VerticesAndForms,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "let",
            .form = "let m = mid(a, b), n = mid(b, c);",
            .grammar = R"_("let" binding { "," binding } ";")_",
            .help = "Names values, for use in later clauses of the rule.",
            .follows = Follows::Definitions,
            .defines = NameRole::Value,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "new",
            .form = "new c = mid(a, b) + (0, 0.866);",
            .grammar = R"_("new" binding { "," binding } ";")_",
            .help = "New vertices.",
            .follows = Follows::Definitions,
            .defines = NameRole::NewVertex,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "zone",
            .form = "zone a, b, c => mid(a, b) when q > 3;",
            .grammar = "zone",
            .help = "The free zone: must hold no other vertex and no part of another edge of the "
                    "front.",
            .words = kWhen,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "tri",
            .form = "tri a b c, c b d;",
            .grammar = R"_(kind corners { "," corners } ";")_",
            .help = "New triangles, counter-clockwise.",
            .follows = Follows::Vertices,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "quad",
            .form = "quad a b c d;",
            .help = "New quadrilaterals, counter-clockwise.",
            .follows = Follows::Vertices,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "poly",
            .form = "poly a b c d;",
            .help = "New elements by their number of corners; as a shape: a simple polygon.",
            .follows = Follows::Vertices},
    Keyword{.block = BlockKind::Rule,
            .word = "weld",
            .form = "weld c into a at mid(a, c);",
            .grammar = R"_("weld" name "into" name "at" expr ";")_",
            .help = "Joins the far ends of two neighbouring front edges into one vertex, so that "
                    "the edges leave the front.",
            .follows = Follows::Header,
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "far",
            .form = "far c;",
            .grammar = R"_("far" name ";")_",
            .help = "Any vertex of the loop of the base edge, for a path.",
            .follows = Follows::Nothing,
            .defines = NameRole::PlacedVertex},
    Keyword{.block = BlockKind::Rule,
            .word = "path",
            .form = "path a -> c by dist(a, c);",
            .grammar = R"_("path" name "->" name "by" expr ";")_",
            .help = "Where no rule applies: divides the loop by a path of so many edges, or as "
                    "many as leave even loops.",
            .follows = Follows::Header},
    Keyword{.block = BlockKind::Rule,
            .word = "require",
            .form = "require turn(b) < 120deg, dist(b, c) in 0.5..2;",
            .grammar = R"_("require" expr { "," expr } ";")_",
            .help = "Conditions that must hold.",
            .isReserved = true},
    Keyword{.block = BlockKind::Rule,
            .word = "cost",
            .form = "cost 0.1 * q;",
            .grammar = R"_("cost" expr ";")_",
            .help = "A number that is added to the score: more is worse."},
    Keyword{.block = BlockKind::Rule,
            .word = "priority",
            .form = "priority 2;",
            .grammar = R"_("priority" integer ";")_",
            .help = "Among rules of equal score the smaller number wins."},
    Keyword{.block = BlockKind::Rule,
            .word = "meta",
            .form = R"_(meta { author "name"; })_",
            .grammar = "meta",
            .help = "Remarks for tools.",
            .snippet = "meta { ${1:allow} \"$2\"; }$0",
            .follows = Follows::Nothing},
    Keyword{.block = BlockKind::Rule,
            .word = "mirror",
            .form = R"_(mirror "title";)_",
            .otherForm = R"_(mirror "title" { at c ~ 2; })_",
            .grammar = "mirror",
            .help = "Adds the mirror image of the rule, with its own title.",
            .snippet = "mirror \"${1:title}\";$0",
            .follows = Follows::Nothing,
            .isReserved = true},

    // ---- clauses of a mirror image --------------------------------------------------------------
    Keyword{.block = BlockKind::Mirror,
            .word = "at",
            .form = "at c ~ 2, d ~ any;",
            .help = "How far a vertex of the mirror image may deviate.",
            .follows = Follows::VerticesAndForms,
            .isReserved = true},
    Keyword{.block = BlockKind::Mirror,
            .word = "quality",
            .form = "quality 2;",
            .help = "The levels at which a rule is tried; an edge's level rises each time that no "
                    "rule takes it.",
            .isReserved = true},
    Keyword{.block = BlockKind::Mirror,
            .word = "cost",
            .form = "cost 0.1 * q;",
            .help = "A number that is added to the score: more is worse."},

    // ---- settings of a rule set -----------------------------------------------------------------
    Keyword{.block = BlockKind::RuleSet,
            .word = "elements",
            .form = "elements tri, quad;",
            .grammar = R"_("elements" kind { "," kind } ";")_",
            .help = "The kinds of elements that rules may make.",
            .follows = Follows::Words,
            .words = kElementKinds},
    Keyword{.block = BlockKind::RuleSet,
            .word = "match",
            .form = "match 0.5 + 0.3*q;",
            .grammar = R"_("match" expr ";")_",
            .help = "The largest value of a tolerance form, by level."},
    Keyword{.block = BlockKind::RuleSet,
            .word = "fade",
            .form = "fade 1/q;",
            .grammar = R"_("fade" expr ";")_",
            .help = "The weight of the preferred side of `=>`, by level."},
    Keyword{
        .block = BlockKind::RuleSet,
        .word = "score",
        .form = "score max of shape_size(10);",
        .grammar = R"_("score" ( "max" | "sum" | "mean" ) "of" expr ";")_",
        .help = "The score of a candidate: a metric over its new elements; the lowest score wins.",
        .follows = Follows::Header,
        .words = kFolds},
    Keyword{.block = BlockKind::RuleSet,
            .word = "accept",
            .form = "accept score < 2 + 0.5*q^2, scaled_jacobian > 0.2;",
            .grammar = R"_("accept" expr { "," expr } ";")_",
            .help = "Which scores and shapes of new elements are good enough.",
            .words = kAccepted},
    Keyword{.block = BlockKind::RuleSet,
            .word = "clear",
            .form = "clear 0.6 / q;",
            .grammar = R"_("clear" expr ";")_",
            .help = "The distance that new edges keep from front edges that are not matched, by "
                    "level."},
    Keyword{
        .block = BlockKind::RuleSet,
        .word = "front",
        .form = "front by q, len(b - a);",
        .otherForm = "front rows(start: smallest_turn);",
        .grammar = R"_("front" ( "by" expr { "," expr } | "rows" [ "(" name ":" name ")" ] ) ";")_",
        .help = "The order in which the edges of the front are processed.",
        .follows = Follows::Header,
        .words = kFrontOrders,
        .isReserved = true},
    Keyword{.block = BlockKind::RuleSet,
            .word = "at",
            .form = "at row smooth 3;",
            .otherForm = "at end clean 2;",
            .grammar = R"_("at" ( "row" "smooth" | "end" "clean" ) integer ";")_",
            .help =
                "At the end of each row: so many rounds of smoothing of the front. At the end of "
                "the front: how deep the clean-up of quadrilaterals searches.",
            .follows = Follows::Header,
            .words = kAtRowOrEnd,
            .isReserved = true},
    Keyword{.block = BlockKind::RuleSet,
            .word = "classes",
            .form = "classes 1..50;",
            .grammar = R"_("classes" integer ".." integer ";")_",
            .help = "The quality levels of an edge."},
    Keyword{
        .block = BlockKind::RuleSet,
        .word = "scale",
        .form = "scale h;",
        .otherForm = "scale base;",
        .grammar = R"_("scale" ( "h" | "base" ) ";")_",
        .help =
            "The unit of length in the frame: the target size h, or the length of the base edge.",
        .follows = Follows::Words,
        .words = kScaleUnits},
    Keyword{.block = BlockKind::RuleSet,
            .word = "parity",
            .form = "parity even;",
            .otherForm = "parity any;",
            .grammar = R"_("parity" ( "even" | "any" ) ";")_",
            .help = "`even`: no step leaves a loop of the front with an odd number of edges.",
            .follows = Follows::Words,
            .words = kParities},
    Keyword{.block = BlockKind::RuleSet,
            .word = "counts",
            .form = "counts 130deg, 235deg, 315deg;",
            .grammar = R"_("counts" expr "," expr "," expr ";")_",
            .help = "The free angles from which a vertex of the front wants 2, 3 and 4 elements."},
    Keyword{.block = BlockKind::RuleSet,
            .word = "columns",
            .form = "columns 0.7..1.4 from layer 3;",
            .grammar = R"_("columns" sum ".." sum "from" "layer" integer ";")_",
            .help = "Where the edges of a row get shorter or longer than this, in target sizes, a "
                    "vertex wants one element less or more.",
            .words = kFromLayer},
    Keyword{.block = BlockKind::RuleSet,
            .word = "finish",
            .form = "finish shape;",
            .otherForm = "finish score;",
            .grammar = R"_("finish" ( "shape" | "score" | "none" ) ";")_",
            .help =
                "What happens after the front has closed: improve shapes, improve by the metric of "
                "the score, or nothing.",
            .follows = Follows::Words,
            .words = kFinishes},
    Keyword{.block = BlockKind::RuleSet,
            .word = "meta",
            .form = R"_(meta { author "name"; })_",
            .grammar = "meta",
            .help = "Remarks for tools.",
            .snippet = "meta { ${1:allow} \"$2\"; }$0",
            .follows = Follows::Nothing},

    // ---- clauses of a test ----------------------------------------------------------------------
    Keyword{.block = BlockKind::Test,
            .word = "front",
            .form = "front p (0, 0) -> r (1, 0), s (0, 2) -> t (1, 2);",
            .grammar = R"_("front" vertices { "," vertices })_",
            .help = "The front, with places.",
            .follows = Follows::Vertices,
            .defines = NameRole::TestVertex,
            .isReserved = true},
    Keyword{.block = BlockKind::Test,
            .word = "point",
            .form = "point s (0.5, 0.9), t (1, 1);",
            .grammar = R"_("point" vertex { "," vertex })_",
            .help = "Vertices of the front without an edge.",
            .follows = Follows::Nothing,
            .defines = NameRole::TestVertex},
    Keyword{.block = BlockKind::Test,
            .word = "colours",
            .form = "colours p 0, w 1;",
            .grammar = R"_("colours" name integer { "," name integer })_",
            .help = "Colours of vertices, 0 or 1. The chains of these vertices are parts of one "
                    "loop.",
            .follows = Follows::Vertices},
    Keyword{.block = BlockKind::Test,
            .word = "base",
            .form = "base p -> r;",
            .grammar = R"_("base" name "->" name)_",
            .help = "The base edge; without it, the first edge.",
            .follows = Follows::Vertices},
    Keyword{.block = BlockKind::Test,
            .word = "class",
            .form = "class 2;",
            .grammar = R"_("class" integer)_",
            .help = "In tests: the level of the base edge; in rules the same as q.",
            .follows = Follows::Nothing},
    Keyword{.block = BlockKind::Test,
            .word = "size",
            .form = "size 0.5;",
            .grammar = R"_("size" expr)_",
            .help = "The target size."},
    Keyword{.block = BlockKind::Test,
            .word = "expect",
            .form = R"_(expect not rule "title" because zone hit by edge u -> v;)_",
            .grammar = R"_("expect" [ "not" ] outcome)_",
            .help = "The expected result.",
            .follows = Follows::Header,
            .words = kOutcomes,
            .isReserved = true},

    Keyword{.block = BlockKind::Property,
            .word = "expect",
            .form = "expect dist(a, b) > 0;",
            .help = "A condition that must hold at every match.",
            .isReserved = true},
};

/// Reserved words that begin no clause.
constexpr WordList<10> kInnerWords{"for",  "and",  "or",   "not", "if",
                                   "then", "else", "when", "in",  "quality"};

/// A list of words without duplicates, with room for one word per row of the table.
struct Words {
  std::array<std::string_view, kKeywords.size() + kInnerWords.size()> list{};
  std::size_t size = 0;

  constexpr void add(std::string_view word) {
    if (std::find(list.begin(), list.begin() + size, word) == list.begin() + size)
      list[size++] = word;
  }
  constexpr std::span<const std::string_view> all() const { return std::span(list).first(size); }
};

template <BlockKind block>
constexpr Words kWordsOf = [] {
  Words words;
  for (const Keyword& keyword : kKeywords)
    if (keyword.block == block) words.add(keyword.word);
  return words;
}();

constexpr Words kReserved = [] {
  Words words;
  for (const Keyword& keyword : kKeywords)
    if (keyword.isReserved) words.add(keyword.word);
  for (const std::string_view word : kInnerWords) words.add(word);
  return words;
}();

bool holds(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::span<const Keyword> keywords() { return kKeywords; }

const Keyword* findKeyword(BlockKind block, std::string_view word) {
  const auto found = std::ranges::find_if(
      kKeywords, [&](const Keyword& k) { return k.block == block && k.word == word; });
  return found == kKeywords.end() ? nullptr : &*found;
}

std::span<const std::string_view> keywordsOf(BlockKind block) {
  switch (block) {
    case BlockKind::File:
      return kWordsOf<BlockKind::File>.all();
    case BlockKind::Rule:
      return kWordsOf<BlockKind::Rule>.all();
    case BlockKind::RuleSet:
      return kWordsOf<BlockKind::RuleSet>.all();
    case BlockKind::Test:
      return kWordsOf<BlockKind::Test>.all();
    case BlockKind::Property:
      return kWordsOf<BlockKind::Property>.all();
    case BlockKind::Mirror:
      return kWordsOf<BlockKind::Mirror>.all();
    case BlockKind::Meta:
      return kMetaKeys;
  }
  return {};
}

std::string shownForm(const Keyword& keyword) {
  const std::string form = "`" + std::string(keyword.form) + "`";
  if (keyword.otherForm.empty()) return form;
  return form + " or `" + std::string(keyword.otherForm) + "`";
}

bool isClauseWord(std::string_view word) {
  for (const BlockKind block :
       {BlockKind::File, BlockKind::Rule, BlockKind::RuleSet, BlockKind::Test})
    if (holds(keywordsOf(block), word)) return true;
  return false;
}

std::span<const std::string_view> reservedWords() { return kReserved.all(); }

bool isReserved(std::string_view word) { return holds(kReserved.all(), word); }

}  // namespace af2::dsl
