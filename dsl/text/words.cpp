#include "dsl/text/words.h"

#include <algorithm>

namespace af2::dsl {
namespace {

struct Habit {
  std::string_view written, meaning;
};

constexpr Habit kHabits[]{
    {"mappoints", "matched vertices are written `at c (x, y);`"},
    {"maplines", "front edges of the pattern are written `front a -> b -> c;`"},
    {"newpoints", "a new vertex is written `new c = mid(a, b) + (0, 1);`"},
    {"newlines", "new edges follow from the elements; leave them out"},
    {"freearea", "the free zone is written `zone a, b, ...;`"},
    {"freearea2", "the limiting zone is written after the preferred one: `preferred => limit`"},
    {"orientations", "write `require ccw(a, b, c);`"},
    {"endrule", "a rule ends with '}'"},
    {"triangle", "a triangle is written `tri a b c;`"},
    {"quadrilateral", "a quadrilateral is written `quad a b c d;`"},
    {"point", "a matched vertex is written `at c (x, y);`"},
    {"vertex", "a matched vertex is written `at c (x, y);`"},
    {"edge", "front edges are written `front a -> b;`"},
    {"condition", "conditions are written `require ...;`"},
    {"include", "write `import \"file.af2\";`"},
    {"function", "functions are written `def name(p, q) = ...;`"},
    {"var", "values are written `let m = ...;` in a rule, `const H = ...;` in a file"},
    {"set", "values are written `let m = ...;` in a rule, `const H = ...;` in a file"},
    {"level", "the quality level is q"},
    {"pi", "angles are written in degrees, as in 60deg"},
    {"PI", "angles are written in degrees, as in 60deg"},
    {"distance", "the distance of two points is dist(p, q)"},
    {"length", "the length of a vector is len(v)"},
    {"norm", "the length of a vector is len(v)"},
    {"normalize", "the unit vector is unit(v)"},
    {"normalise", "the unit vector is unit(v)"},
    {"rotate", "a vector is turned by rot(v, angle)"},
    {"midpoint", "the middle of two points is mid(p, q)"},
    {"mix", "a point between two points is lerp(p, q, t)"},
    {"interpolate", "a point between two points is lerp(p, q, t)"},
    {"average", "the centre of points is centroid(p, q, ...)"},
    {"intersect", "the intersection of two lines is cut(p, u, q, v)"},
    {"project", "the nearest point of a line is foot(p, q, r)"},
    {"circle", "a disc is written disc(centre, radius)"},
    {"polygon", "a region with any corners is written poly(p, q, ...)"},
    {"pow", "powers are written x^2"},
    {"atan", "use atan2(y, x), or angle(p, v, q)"},
    {"acos", "use angle(p, v, q), the angle at v"},
    {"degrees", "an angle is written 60deg; as a number it is angle/1deg"},
    {"radians", "in sin, cos and tan a plain number is in radians"},
    {"vec", "a vector is written (x, y), a new vertex `new c = ...;`"},
    {"return", "a function is written `def f(p, q) = mid(p, q);`"},
    {"true", "conditions are comparisons; leave out what always holds"},
    {"false", "conditions are comparisons"},
};

}  // namespace

std::string lowered(std::string_view word) {
  std::string result(word);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string habitOf(std::string_view word) {
  for (const Habit& habit : kHabits)
    if (habit.written == word) return std::string(habit.meaning);
  return {};
}

std::string nearest(std::string_view written, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 64;  // the distance costs the product of the lengths
  if (written.size() > kLongest) return {};
  for (const std::string& word : known)
    if (word != written && lowered(word) == lowered(written)) return word;
  std::string best;
  std::size_t bestDistance = written.size() <= 4 ? 1 : written.size() <= 8 ? 2 : 3;
  ++bestDistance;
  for (const std::string& word : known) {
    if (word.size() > kLongest || word == written) continue;
    const std::size_t distance = editDistance(written, word);
    if (distance < bestDistance && distance < std::max(written.size(), word.size())) {
      best = word;
      bestDistance = distance;
    }
  }
  return best;
}

Help helpAmong(std::string_view written, const std::vector<std::string>& known,
               const std::string& what) {
  constexpr std::size_t kLongest = 120;
  Help guess = didYouMean(written, known);
  if (!guess.empty() || known.empty()) return guess;
  std::string list;
  for (const std::string& word : known) list += (list.empty() ? "" : ", ") + word;
  return list.size() > kLongest ? Help() : Help(what + ": " + list);
}

Help didYouMean(std::string_view written, const std::vector<std::string>& known) {
  const std::string word = nearest(written, known);
  if (word.empty()) return {};
  return Help("did you mean '" + word + "'?",
              Remedy{Remedy::Where::Word, word, std::string(written)});
}

}  // namespace af2::dsl
