#include "dsl/symbols/word_help.h"

#include <algorithm>
#include <array>

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

constexpr std::array kBuiltins{
    WordHelp{"sqrt", "sqrt(x)", "The square root."},
    WordHelp{"sin", "sin(angle)", "The sine; a bare number stands for radians."},
    WordHelp{"cos", "cos(angle)", "The cosine; a bare number stands for radians."},
    WordHelp{"tan", "tan(angle)", "The tangent; a bare number stands for radians."},
    WordHelp{"atan2", "atan2(y, x)", "The angle of the vector (x, y)."},
    WordHelp{"abs", "abs(x)", "The value without its sign."},
    WordHelp{"min", "min(x, y, ...)", "The smallest."},
    WordHelp{"max", "max(x, y, ...)", "The largest."},
    WordHelp{"clamp", "clamp(x, low, high)", "x, but not below low nor above high."},
    WordHelp{"mid", "mid(p, q)", "The point halfway."},
    WordHelp{"lerp", "lerp(from, to, t)", "from at t = 0, to at t = 1; t may lie outside."},
    WordHelp{"centroid", "centroid(p, q, ...)", "The mean of points."},
    WordHelp{"perp", "perp(v)", "The vector, turned by 90 degrees counter-clockwise."},
    WordHelp{"rot", "rot(v, angle)", "The vector, turned counter-clockwise."},
    WordHelp{"unit", "unit(v)", "The vector at length 1."},
    WordHelp{"len", "len(v)", "The length of a vector."},
    WordHelp{"dist", "dist(p, q)", "The distance of two points."},
    WordHelp{"dot", "dot(u, v)", "The scalar product."},
    WordHelp{"cross", "cross(u, v)", "The z component of the vector product."},
    WordHelp{"foot", "foot(p, q, r)", "The foot of p on the line through q and r."},
    WordHelp{"reflect", "reflect(p, q, r)", "p, reflected in the line through q and r."},
    WordHelp{"cut", "cut(p, u, q, v)",
             "Where the line through p along u meets the one through q along v."},
    WordHelp{"angle", "angle(p, v, q)",
             "Counter-clockwise from v->q to v->p, above 0 and up to 360deg."},
    WordHelp{"bisector", "bisector(p, v, q)", "The unit vector that halves angle(p, v, q)."},
    WordHelp{"ccw", "ccw(p, q, r)", "Whether three points turn left; exact."},
    WordHelp{"convex", "convex(p, q, r, ...)", "Whether corners form a convex polygon; exact."},
    WordHelp{"inside", "inside(p, shape)", "Whether the closed shape holds the point."},
    WordHelp{"poly", "poly(p, q, ...)",
             "A simple polygon, counter-clockwise; arc(via, to) may be a corner."},
    WordHelp{"hull", "hull(p, q, ...)", "The convex hull."},
    WordHelp{"disc", "disc(centre, radius)", "A disc."},
    WordHelp{"left", "left(p, v)", "The half plane to the left of the line through p along v."},
    WordHelp{"sector", "sector(centre, radius, from, to)",
             "Counter-clockwise between two angles from the x axis."},
    WordHelp{"grow", "grow(shape, distance)", "All within a distance of the shape."},
    WordHelp{"arc", "arc(via, to)", "In a poly: along a circle through via."},
    WordHelp{"h", "h(p)", "The wanted edge length at p, in units of that at the base."},
    WordHelp{"turn", "turn(v)", "The free angle at a vertex of a chain."},
    WordHelp{"corner", "corner(v)", "1 end, 2 side, 3 corner, 4 reversal, by the free angle."},
    WordHelp{"layer", "layer(v)", "Layers of elements between v and the boundary."},
    WordHelp{"on_boundary", "on_boundary(v)", "Whether v lies on the boundary."},
    WordHelp{"valence", "valence(v)", "The number of elements at v so far."},
    WordHelp{"loop_size", "loop_size()", "The number of edges of this loop of the front."},
    WordHelp{"dist_front", "dist_front(p)", "The distance to the nearest front edge."},
    WordHelp{"curvature", "curvature(p)", "The surface's curvature times the wanted length."},
    WordHelp{"shape_size", "shape_size(weight)", "Metric: shape and edge lengths of a triangle."},
    WordHelp{"jacobian_badness", "jacobian_badness", "Metric: 0 for the square."},
    WordHelp{"size_error", "size_error", "Metric: 0 where all edges have the wanted length."},
    WordHelp{"aspect_badness", "aspect_badness", "Metric: 0 where all edges are equally long."},
    WordHelp{"scaled_jacobian", "scaled_jacobian(u, v, w, x)",
             "Measure: 1 for the ideal element, 0 for a flat one."},
    WordHelp{"min_angle", "min_angle(u, v, w, x)", "Measure: the smallest corner."},
    WordHelp{"q", "q", "The quality level of the base edge: 1, and one more after each refusal."},
};

const WordHelp* find(std::span<const WordHelp> table, std::string_view word) {
  const auto found = std::ranges::find(table, word, &WordHelp::word);
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::span<const WordHelp> keywordHelp() { return kKeywords; }
std::span<const WordHelp> builtinHelp() { return kBuiltins; }
const WordHelp* helpForKeyword(std::string_view word) { return find(kKeywords, word); }
const WordHelp* helpForBuiltin(std::string_view word) { return find(kBuiltins, word); }

}  // namespace af2::dsl
