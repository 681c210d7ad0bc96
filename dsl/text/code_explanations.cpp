#include "dsl/text/code_explanations.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace af2::dsl {
namespace {

const std::array kExplanations{
    CodeExplanation{"A1", "a sum of points is neither a point nor a vector",
                    "The weights of the points in a sum must add up to 1 for a point and to 0 for "
                    "a vector; then it\n"
                    "moves with the front wherever the front lies. `2*c - a` has weight 1, `2*c + "
                    "a - b` has 2.\n\n"
                    "Way out: mid, lerp and centroid always have the right weights. Weights must "
                    "be constants; to\n"
                    "move from p to q by a share that varies write lerp(p, q, t)."},
    CodeExplanation{"A2", "a value is not used, or hides another one",
                    "A `let` that nothing uses is often a slip: another name was meant where it "
                    "should stand. A name\n"
                    "of a rule that is also the name of a constant makes the constant unreachable "
                    "in the rule.\n\n"
                    "Way out: remove the value, or rename it."},
    CodeExplanation{
        "D1", "a clause can never act",
        "A condition that is proven to hold for every match or for none, an empty range, a zone\n"
        "behind the last alternative, a cost or priority of 0, a slope that lets everything pass,\n"
        "`=>` between equal sides: the clause changes nothing, or the rule never applies.\n\n"
        "Way out: remove it, or let it depend on what it was meant to test."},
    CodeExplanation{"D2", "a rule's quality levels are never reached",
                    "A rule is tried from its first level on. Levels end where `classes` ends; an "
                    "edge that no rule\n"
                    "takes there is stuck.\n\n"
                    "Way out: lower the rule's level, or raise the end of `classes`."},
    CodeExplanation{
        "D3", "a rule is never chosen",
        "In all situations that were tried another rule matched as well, consumed the same edges "
        "and\n"
        "scored no worse.\n\n"
        "Way out: remove the rule, or give it a smaller `cost` or `priority` where it should win."},
    CodeExplanation{"F1", "a rule makes no progress",
                    "The advance ends because every step takes area away from what is left to be "
                    "meshed. A rule\n"
                    "without an element does not.\n\n"
                    "Way out: give it an element on its base edge."},
    CodeExplanation{"G1", "an element is not positive at the reference match",
                    "With all matched vertices at their reference positions the element runs "
                    "clockwise, has no area,\n"
                    "or is a quadrilateral with a corner of 180 degrees or more.\n\n"
                    "Way out: name its corners counter-clockwise, or correct the places."},
    CodeExplanation{"G2", "an element is not positive at some match",
                    "There are positions within the tolerances, passing `require`, for which the "
                    "element turns over.\n"
                    "The engine refuses such a match, but a rule that often fails so costs time "
                    "and leaves gaps.\n\n"
                    "Way out: tighten a tolerance, or add `require convex(...)`."},
    CodeExplanation{"I1", "a rule file of Netgen cannot be read here",
                    "Such a file is a list of `rule \"name\" ... endrule`. A clause is a keyword "
                    "and its parts, each\n"
                    "closed by ';': points `(x, y) { 0.5 X2 } { 0.5 Y2 };`, lines `(1, 2) del;`, "
                    "elements `(1, 2, 3);`."},
    CodeExplanation{"I2", "a rule of Netgen contradicts itself or asks too much",
                    "A number of a point that there is not, a front that branches, no elements, "
                    "more points than a\n"
                    "rule can have."},
    CodeExplanation{"I3", "a rule for volumes",
                    "freeset, flags, tolfak and the like belong to rules that fill volumes with "
                    "tetrahedra. They look\n"
                    "like rules for surfaces, but AF2 meshes surfaces only."},
    CodeExplanation{"I4", "text outside of the rules",
                    "What stands between `endrule` and the next `rule` is passed over without a "
                    "word by the program that\n"
                    "such files are made for. A rule whose first word is misspelt gets lost that "
                    "way."},
    CodeExplanation{"I5", "a part of a rule that does nothing",
                    "A tolerance on an end of the base edge, `del` on a point, a term that follows "
                    "a point that there\n"
                    "is not: they change nothing where the file comes from, and nothing here."},
    CodeExplanation{"I6", "parts of a rule that do not fit together",
                    "Which edges leave the front and which join it follows from the elements; "
                    "`del`, `newlines`, the\n"
                    "areas and the orientations are held against that. A rule that is nearly the "
                    "mirror image of another\n"
                    "is told as well."},
    CodeExplanation{"I7", "a rule that is switched off",
                    "Levels of such files end at 200; a larger `quality` is the usual way to "
                    "switch a rule off."},
    CodeExplanation{"I8", "a rule was renamed or turned",
                    "Titles are unique here, and the base edge runs from a to b."},
    CodeExplanation{"I9", "an imported rule that will be refused",
                    "The rule is written out as its numbers say, but the checks of rule files find "
                    "an error in it.\n\n"
                    "Way out: mend it in either file; `af2 check` tells more."},
    CodeExplanation{"L1", "an unknown character",
                    "Outside of strings and comments a rule file is plain ASCII, written in UTF-8. "
                    "Names hold letters,\n"
                    "digits and '_'. Typographic quotes, dashes and arrows, brackets [ ] and the "
                    "comments of other\n"
                    "languages are read as what they mean, but are errors all the same."},
    CodeExplanation{"L2", "a number is malformed",
                    "Numbers are 12, 1.5, .5, 2e-3; angles 60deg; ranges 1..30. There is no 1., no "
                    "1.2.3, no 0x10."},
    CodeExplanation{"L3", "a string is not closed",
                    "A string ends with \" on the line on which it began."},
    CodeExplanation{"L4", "an unknown escape in a string",
                    "In a string only \\\" and \\\\ have a meaning after a backslash."},
    CodeExplanation{
        "M1", "a rule has no mirror image",
        "What the front looks like on the right it will look like on the left. A rule without its "
        "twin\n"
        "makes meshes lean to one side.\n\n"
        "Way out: add `mirror \"title\";` to the rule instead of writing the twin by hand."},
    CodeExplanation{
        "M2", "a rule is its own mirror image",
        "The rule is symmetric; a `mirror` clause makes a second rule that does the same.\n\n"
        "Way out: remove the clause."},
    CodeExplanation{"N1", "a situation that no rule takes",
                    "For these angles and lengths at the base no rule was accepted up to the level "
                    "that was asked for.\n\n"
                    "Way out: add a rule for the situation, or widen one that is near."},
    CodeExplanation{"P1", "a rule breaks parity",
                    "In a set with `parity even` the number of front edges must stay even, so that "
                    "loops can close\n"
                    "with quadrilaterals. New less consumed edges must be even.\n\n"
                    "Way out: use quadrilaterals, or pairs of triangles."},
    CodeExplanation{
        "R1", "a name is unknown here, or used above its definition",
        "Everything is defined above its use. A rule knows its vertices (a, b, those of `at` and "
        "`new`),\n"
        "its `let` values, its parameters, and the constants and functions of the file."},
    CodeExplanation{"R2", "a name is given twice",
                    "A name has one meaning in its scope: a file, a rule with its a and b, a test. "
                    "Functions of the\n"
                    "language cannot be defined anew."},
    CodeExplanation{
        "R3", "a file cannot be read",
        "Imports are looked for in the folder of the importing file, then on the search path."},
    CodeExplanation{"R4", "imports or rule sets run in a circle",
                    "A file cannot import itself, directly or through others; nor can a rule set "
                    "extend itself.\n\n"
                    "Way out: move what both need into a third file."},
    CodeExplanation{"R5", "the file has not exactly one rule set",
                    "The file that is run has one `ruleset`, and at least one rule."},
    CodeExplanation{"S1", "something else is expected here",
                    "The message says what; the language reference has the form of each clause."},
    CodeExplanation{"S2", "a ';' is missing",
                    "Every clause ends with ';', except where it ends in a brace."},
    CodeExplanation{"S3", "an expression is missing",
                    "An operator, a comma or '=' must be followed by a value."},
    CodeExplanation{"S4", "an unknown clause",
                    "A clause begins with one of the words that belong in this block; the nearest "
                    "one is shown."},
    CodeExplanation{"S5", "a block is not closed", "Each '{' needs its '}'."},
    CodeExplanation{
        "S6", "too much at once",
        "Files, brackets within brackets and single expressions have limits, so that no input can "
        "exhaust\n"
        "time or memory.\n\nWay out: name parts with `let`, `const` or `def`, or split the file."},
    CodeExplanation{"S7", "the version is missing",
                    "A rule file begins with `af2 1;`. What begins with nothing of the kind is not "
                    "read further; rule\n"
                    "files of Netgen are rewritten by `af2 import`."},
    CodeExplanation{
        "S8", "'=>' does not chain",
        "A corner or shape fades once, from its preferred to its limiting form: `p => l`."},
    CodeExplanation{"S9", "a word of the language as a name",
                    "Words such as zone, rule, new cannot be names."},
    CodeExplanation{"S10", "a test without front or expectation",
                    "A test needs a `front` and at least one `expect`."},
    CodeExplanation{"T1", "elements and pattern do not close up",
                    "The new elements must fit together like a jigsaw: neighbours use their common "
                    "edge in opposite\n"
                    "directions, front edges are used in their own direction, no front edge "
                    "between corners of new\n"
                    "elements is left over, and there is no hole."},
    CodeExplanation{"T2", "chains, vertices or elements are not as they should be",
                    "Chains do not branch and name matched vertices; an element has three or four "
                    "different corners;\n"
                    "the base edge a -> b is consumed; every new vertex is used."},
    CodeExplanation{"Y1", "a value of another type is needed",
                    "Numbers, truth values, angles, points, vectors, shapes and vertices are kept "
                    "apart, because a slip\n"
                    "between them is nearly always a mistake in the geometry."},
    CodeExplanation{"Y2", "an operator does not work on these types",
                    "Angles are added to and compared with angles only, points are not multiplied "
                    "with each other, and\n"
                    "`then` and `else` give the same type."},
    CodeExplanation{"Y3", "a constant of a certain kind is needed",
                    "Levels and priorities are known before the front is, and are whole numbers. "
                    "Reference positions and\n"
                    "tolerances may go by the quality level, but know nothing else of the match."},
    CodeExplanation{"Y4", "an expression never has a value",
                    "It divides by zero, takes a root of a negative number or the like: whatever "
                    "the match, or\n"
                    "whatever happens at the level that is named."},
    CodeExplanation{"Y5", "this cannot be asked here",
                    "turn(v) needs a vertex of a chain, which has neighbours; layer, valence and "
                    "the like need a front,\n"
                    "so they belong in rules."},
    CodeExplanation{"Y6", "a wrong number of arguments",
                    "The message shows how the call is written."},
    CodeExplanation{"Y7", "shapes that do not go together",
                    "Two shapes fade into each other if they are built by the same constructors; "
                    "'=>' belongs in zones,\n"
                    "arc(via, to) in the path of a poly."},
    CodeExplanation{"Z1", "an element leaves the zone at some match",
                    "Where an element sticks out of the free zone an obstacle is not seen.\n\nWay "
                    "out: widen the zone."},
    CodeExplanation{
        "Z2", "the zone has no valid shape",
        "A list of corners must be convex and a path must not cross itself, else the match is "
        "refused.\n\n"
        "Way out: write poly(...) where the zone may be non-convex, or bend its corners less."},
    CodeExplanation{"Z3", "the zone grows with the level",
                    "The limiting zone should lie inside of the preferred one, so that later "
                    "levels ask for less room."},
    CodeExplanation{"Z4", "the zone is unbounded, or a size is negative",
                    "Half planes must be cut by something bounded: `left(p, v) & disc(p, 2)`."},
    CodeExplanation{"Z5", "the zone runs clockwise",
                    "Corners and paths run counter-clockwise, beginning with a, b."},
    CodeExplanation{"Z6", "a rule without a zone",
                    "Without a free zone nothing keeps the new elements from lying over others."},
};

}  // namespace

std::span<const CodeExplanation> codeExplanations() { return kExplanations; }

const CodeExplanation* findCodeExplanation(std::string_view code) {
  std::string wanted(code);
  std::transform(wanted.begin(), wanted.end(), wanted.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  if (wanted.starts_with("AF2-")) wanted = wanted.substr(4);
  for (const CodeExplanation& e : kExplanations)
    if (e.code == wanted) return &e;
  return nullptr;
}

}  // namespace af2::dsl
