#include "dsl/symbols/word_help.h"

#include <algorithm>
#include <array>

#include "dsl/program/builtins.h"

namespace af2::dsl {
namespace {

constexpr std::array kKeywords{
    WordHelp{"import", "import \"file.af2\" as name;",
             "Brings the constants, functions, metrics and templates of another file."},
    WordHelp{"use", "use name.* except \"title\";", "Takes over the rules of an imported file."},
    WordHelp{"const", "const H = sqrt(3) / 2;", "A name for a value that needs no match."},
    WordHelp{"def", "def f(p, q) = mid(p, q);", "A function of one's own."},
    WordHelp{"metric", "metric m(weight, u, v, w) = ...;",
             "A measure of elements: 0 for the ideal one; the corners come last."},
    WordHelp{"ruleset", "ruleset \"name\" { ... }", "The settings that all rules of a file share."},
    WordHelp{"rule", "rule \"title\" quality 1 { ... }",
             "Where the front looks like the pattern and the free zone is empty, put these "
             "elements."},
    WordHelp{"template", "template name(x, y) rule \"title\" quality 1 { ... }",
             "A rule with parameters."},
    WordHelp{"test", "test \"title\" { ... }", "A piece of front and what should happen there."},
    WordHelp{"property", "property \"title\" forall match of \"rule\", q in 1..5 { expect ...; }",
             "A claim about all matches of a rule."},
    WordHelp{"front", "front a -> b -> c;",
             "In rules: chains of front edges that the rule wants. In rule sets: `front by ...` "
             "says which edge is next. In tests: the front, with places."},
    WordHelp{"at", "at c (0.5, 0.866) ~ 1;",
             "Where a vertex is expected, relative to a, and how far it may deviate."},
    WordHelp{"slope", "slope c -> d ~ 2;",
             "Measures the deviation of an edge of the pattern, whatever its place."},
    WordHelp{"let", "let m = mid(a, b);", "Names for values, for later clauses of the rule."},
    WordHelp{"new", "new c = mid(a, b) + (0, 0.866);", "New vertices."},
    WordHelp{"zone", "zone a, b, limit => c;",
             "The free zone: must hold no other vertex and no part of another edge of the front."},
    WordHelp{"tri", "tri a b c;", "New triangles, counter-clockwise."},
    WordHelp{"quad", "quad a b c d;", "New quadrilaterals, counter-clockwise."},
    WordHelp{"poly", "poly a b c d;",
             "New elements by their number of corners; as a shape: a simple polygon."},
    WordHelp{"require", "require turn(b) < 90deg;", "Conditions that must hold."},
    WordHelp{"cost", "cost 0.5;", "A number that is added to the score: more is worse."},
    WordHelp{"priority", "priority 1;", "Among rules of equal score the smaller number wins."},
    WordHelp{"meta", "meta { allow \"Z1\"; }", "Remarks for tools."},
    WordHelp{"mirror", "mirror \"title\";",
             "The mirror image of the rule, under a title of its own."},
    WordHelp{"quality", "quality 1..4",
             "The levels at which a rule is tried; an edge's level rises each time that no rule "
             "takes it."},
    WordHelp{"elements", "elements tri, quad;", "What rules may make."},
    WordHelp{"match", "match 0.5 + 0.3*q;", "The largest value of a tolerance form, by level."},
    WordHelp{"fade", "fade 1 / q;", "The weight of the preferred side of `=>`, by level."},
    WordHelp{"score", "score max of shape_size(10);",
             "How good a candidate is: a metric over its new elements; the lowest wins."},
    WordHelp{"accept", "accept score < 2 + 0.5*q^2;", "Which scores are good enough."},
    WordHelp{"classes", "classes 1..50;", "The quality levels of an edge."},
    WordHelp{"scale", "scale h;",
             "The unit of the frame: the wanted length h, or that of the base edge."},
    WordHelp{"parity", "parity even;",
             "`even`: every rule changes the number of front edges by an even number."},
    WordHelp{"point", "point s (1, 2);", "Vertices of the front without an edge."},
    WordHelp{"base", "base p -> r;", "The base edge; without it, the first edge."},
    WordHelp{"class", "class 2;", "In tests: the level of the base edge; in rules the same as q."},
    WordHelp{"size", "size 2;", "The wanted length."},
    WordHelp{"expect", "expect rule \"title\";", "What should happen."},
};

struct Meaning {
  std::string_view word, meaning;
};

constexpr std::array kBuiltins{
    Meaning{"sqrt", "The square root."},
    Meaning{"sin", "The sine; a bare number stands for radians."},
    Meaning{"cos", "The cosine; a bare number stands for radians."},
    Meaning{"tan", "The tangent; a bare number stands for radians."},
    Meaning{"atan2", "The angle of the vector (x, y)."},
    Meaning{"abs", "The value without its sign."},
    Meaning{"min", "The smallest."},
    Meaning{"max", "The largest."},
    Meaning{"clamp", "x, but not below low nor above high."},
    Meaning{"mid", "The point halfway."},
    Meaning{"lerp", "from at t = 0, to at t = 1; t may lie outside."},
    Meaning{"centroid", "The mean of points."},
    Meaning{"perp", "The vector, turned by 90 degrees counter-clockwise."},
    Meaning{"rot", "The vector, turned counter-clockwise."},
    Meaning{"unit", "The vector at length 1."},
    Meaning{"len", "The length of a vector."},
    Meaning{"dist", "The distance of two points."},
    Meaning{"dot", "The scalar product."},
    Meaning{"cross", "The z component of the vector product."},
    Meaning{"foot", "The foot of p on the line through q and r."},
    Meaning{"reflect", "p, reflected in the line through q and r."},
    Meaning{"cut", "Where the line through p along u meets the one through q along v."},
    Meaning{"angle", "Counter-clockwise from v->q to v->p, above 0 and up to 360deg."},
    Meaning{"bisector", "The unit vector that halves angle(p, v, q)."},
    Meaning{"ccw", "Whether three points turn left; exact."},
    Meaning{"convex", "Whether corners form a convex polygon; exact."},
    Meaning{"inside", "Whether the closed shape holds the point."},
    Meaning{"poly", "A simple polygon, counter-clockwise; arc(via, to) may be a corner."},
    Meaning{"hull", "The convex hull."},
    Meaning{"disc", "A disc."},
    Meaning{"left", "The half plane to the left of the line through p along v."},
    Meaning{"sector", "Counter-clockwise between two angles from the x axis."},
    Meaning{"grow", "All within a distance of the shape."},
    Meaning{"arc", "In a poly: along a circle through via."},
    Meaning{"h", "The wanted edge length at p, in units of that at the base."},
    Meaning{"turn", "The free angle at a vertex of a chain."},
    Meaning{"corner", "1 end, 2 side, 3 corner, 4 reversal, by the free angle."},
    Meaning{"layer", "Layers of elements between v and the boundary."},
    Meaning{"on_boundary", "Whether v lies on the boundary."},
    Meaning{"valence", "The number of elements at v so far."},
    Meaning{"loop_size", "The number of edges of this loop of the front."},
    Meaning{"dist_front", "The distance to the nearest front edge."},
    Meaning{"curvature", "The surface's curvature times the wanted length."},
    Meaning{"shape_size", "Metric: shape and edge lengths of a triangle."},
    Meaning{"jacobian_badness", "Metric: 0 for the square."},
    Meaning{"size_error", "Metric: 0 where all edges have the wanted length."},
    Meaning{"aspect_badness", "Metric: 0 where all edges are equally long."},
    Meaning{"scaled_jacobian", "Measure: 1 for the ideal element, 0 for a flat one."},
    Meaning{"min_angle", "Measure: the smallest corner."},
    Meaning{"q", "The quality level of the base edge: 1, and one more after each refusal."},
};

WordHelp helpOf(const Meaning& builtin) {
  return {builtin.word, usageOf(builtin.word), builtin.meaning};
}

}  // namespace

std::span<const WordHelp> keywordHelp() { return kKeywords; }

std::vector<WordHelp> builtinHelp() {
  std::vector<WordHelp> all;
  for (const Meaning& builtin : kBuiltins) all.push_back(helpOf(builtin));
  return all;
}

const WordHelp* helpForKeyword(std::string_view word) {
  const auto found = std::ranges::find(kKeywords, word, &WordHelp::word);
  return found == kKeywords.end() ? nullptr : &*found;
}

std::optional<WordHelp> helpForBuiltin(std::string_view word) {
  const auto found = std::ranges::find(kBuiltins, word, &Meaning::word);
  return found == kBuiltins.end() ? std::nullopt : std::optional(helpOf(*found));
}

}  // namespace af2::dsl
