// Imports the classical rules and holds what they do against the numbers they were made from.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <random>

#include "dsl/load/rule_file.h"
#include "dsl/netgen/rls_import.h"
#include "tests/dsl/netgen/linear_sums.h"

namespace af2::dsl {
namespace {

constexpr double kTolerance = 1e-12;

ImportedRules import(std::span<const RuleNumbers> rules) {
  std::string text;
  for (const RuleNumbers& rule : rules) text += rlsText(rule);
  return importRls("classic.rls", text);
}

std::shared_ptr<const RuleSet> load(const ImportedRules& imported) {
  EXPECT_FALSE(hasErrors(imported.diagnostics)) << toPretty(imported.diagnostics);
  const LoadedRules loaded = loadRulesFromText("classic.af2", imported.text);
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics) << imported.text;
  return loaded.rules;
}

const RuleDefinition* find(const RuleSet& set, std::string_view name) {
  for (const AF2Rule& rule : set.rules())
    if (rule.name() == name) return &rule.definition();
  return nullptr;
}

/// For each vertex of the imported rule its number in the file, from 0: by where it stands.
std::vector<std::size_t> fileNumbers(const RuleDefinition& rule,
                                     const std::vector<Point2>& references) {
  std::vector<std::size_t> numbers;
  for (const PatternVertex& vertex : rule.vertices) {
    const Point2 q = vertex.reference.at(rule.firstLevel);
    const auto found = std::ranges::find_if(references, [&](Point2 p) {
      return std::abs(p.x - q.x) + std::abs(p.y - q.y) < kTolerance;
    });
    EXPECT_NE(found, references.end()) << rule.name << ": " << vertex.name;
    numbers.push_back(static_cast<std::size_t>(found - references.begin()));
  }
  return numbers;
}

/// Random places for all but a, which is the origin, and b, which is on the x axis.
std::vector<Point2> randomMatch(const std::vector<Point2>& references, std::mt19937& random) {
  std::uniform_real_distribution<double> deviation(-0.5, 0.5);
  std::vector<Point2> match = references;
  match[1].x += deviation(random);
  for (std::size_t i = 2; i < match.size(); ++i)
    match[i] = match[i] + Point2{deviation(random), deviation(random)};
  return match;
}

void expectNear(Point2 value, Point2 expected, const std::string& what) {
  EXPECT_NEAR(value.x, expected.x, kTolerance) << what;
  EXPECT_NEAR(value.y, expected.y, kTolerance) << what;
}

/// Some order of the new vertices and a turn of the zone's corners fit; both are free.
class Comparison {
 public:
  Comparison(const RuleNumbers& numbers, const RuleDefinition& rule)
      : numbers_(numbers), rule_(rule), references_(references(numbers)) {
    numberOf_ = fileNumbers(rule, references_);
  }

  void compareAt(const std::vector<Point2>& fileMatch) {
    std::vector<Point2> match;  // without the new vertices, whose numbers come later
    for (std::size_t i = 0; i < fileMatch.size(); ++i) match.push_back(fileMatch[numberOf_[i]]);
    compareNewVertices(match, fileMatch);
    compareZone(match, fileMatch);
  }

  void compareElements() {
    EXPECT_EQ(rule_.firstLevel, numbers_.quality) << rule_.name;
    std::vector<std::vector<int>> own, expected = readTuples(numbers_.elements);
    for (const RuleElement& element : rule_.elements) {
      std::vector<int> corners;
      for (int i = 0; i < element.size(); ++i)
        corners.push_back(static_cast<int>(numberOf_.at(static_cast<std::size_t>(
                              element.corners[static_cast<std::size_t>(i)]))) +
                          1);
      own.push_back(corners);
    }
    for (auto* elements : {&own, &expected}) {
      for (auto& e : *elements) std::ranges::rotate(e, std::ranges::min_element(e));
      std::ranges::sort(*elements);
    }
    EXPECT_EQ(own, expected) << rule_.name;
  }

 private:
  void compareNewVertices(const std::vector<Point2>& match, const std::vector<Point2>& fileMatch) {
    const std::vector<SumPoint> sums = readSums(numbers_.added);
    ASSERT_EQ(rule_.newVertices.size(), sums.size()) << rule_.name;
    numberOf_.resize(rule_.vertices.size());
    std::vector<bool> isUsed(sums.size());
    for (const auto& vertex : rule_.newVertices) {
      const auto place = vertex->transformPoint({match, 1, nullptr});
      ASSERT_TRUE(place);
      std::size_t nearest = sums.size();
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const Point2 p = sums[i].at(fileMatch);
        const bool fits = std::abs(p.x - place->x) + std::abs(p.y - place->y) < kTolerance;
        if (fits && !isUsed[i]) nearest = i;
      }
      ASSERT_LT(nearest, sums.size()) << rule_.name << ": a new vertex is elsewhere";
      isUsed[nearest] = true;
      numberOf_.push_back(references_.size() + nearest);
    }
  }

  void compareZone(const std::vector<Point2>& match, const std::vector<Point2>& fileMatch) {
    const auto* zone = dynamic_cast<const ConvexPolygonZoneDef*>(rule_.zone.get());
    ASSERT_TRUE(zone) << rule_.name;
    const std::vector<SumPoint> preferred = readSums(numbers_.zone);
    const std::vector<SumPoint> limiting =
        numbers_.limit.empty() ? preferred : readSums(numbers_.limit);
    const auto corners = zone->corners();
    ASSERT_EQ(corners.size(), preferred.size()) << rule_.name;
    const AF2Binding binding{match, 1, nullptr};
    // A mirrored list begins at another corner: the one that is file corner 0, a itself.
    std::size_t turn = 0;
    while (turn < corners.size() && corners[turn].preferred->transformPoint(binding) != match[0])
      ++turn;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& corner = corners[(turn + i) % corners.size()];
      const auto& limit = corner.limiting ? corner.limiting : corner.preferred;
      const std::string what = rule_.name + ", corner " + std::to_string(i + 1);
      expectNear(*corner.preferred->transformPoint(binding), preferred[i].at(fileMatch), what);
      expectNear(*limit->transformPoint(binding), limiting[i].at(fileMatch), what + ", limit");
    }
    for (int level : {1, 3, 7}) EXPECT_NEAR(zone->fade(level), 1.0 / level, kTolerance);
  }

  const RuleNumbers& numbers_;
  const RuleDefinition& rule_;
  std::vector<Point2> references_;
  std::vector<std::size_t> numberOf_;  // by vertex of the imported rule: in the file, from 0
};

void compareAll(std::span<const RuleNumbers> rules) {
  const ImportedRules imported = import(rules);
  const auto set = load(imported);
  ASSERT_TRUE(set);
  ASSERT_EQ(set->rules().size(), rules.size()) << imported.text;
  EXPECT_EQ(set->maxLevel(), 200);
  std::mt19937 random(20);
  for (const RuleNumbers& numbers : rules) {
    const RuleDefinition* rule = find(*set, numbers.name);
    ASSERT_TRUE(rule) << numbers.name;
    Comparison comparison(numbers, *rule);
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i)
      comparison.compareAt(randomMatch(references(numbers), random));
    comparison.compareElements();
  }
}

TEST(ImportedClassicRules, TrianglesDoWhatTheirNumbersSay) { compareAll(kTriangles); }

TEST(ImportedClassicRules, QuadsDoWhatTheirNumbersSay) { compareAll(kQuads); }

/// Random rules in the form of the tables: positions are sums with random weights, and constants
/// that put them where the rule is sound.
class RandomRules {
 public:
  explicit RandomRules(unsigned seed) : random_(seed) {}

  std::vector<RuleNumbers> make(int count) {
    std::vector<RuleNumbers> rules;
    for (int i = 0; i < count; ++i) rules.push_back(one(i));
    return rules;
  }

 private:
  std::string_view keep(std::string text) { return texts_.emplace_back(std::move(text)); }
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  static std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", x);
    return text;
  }

  /// One that has the value `at` where all points stand at their references.
  std::string sum(double at, char axis, const std::vector<Point2>& references) {
    std::string terms;
    for (std::size_t i = 1; i < references.size(); ++i) {
      if (pick(2) == 0) continue;
      const bool isCrossed = pick(5) == 0;
      const bool isX = (axis == 'x') != isCrossed;
      const double weight = 0.125 * (pick(25) - 12);
      if (weight == 0 || (i == 1 && !isX)) continue;
      at -= weight * (isX ? references[i].x : references[i].y);
      terms += (weight > 0 ? "+" : "") + number(weight) + "*" + (isX ? "x" : "y") +
               std::to_string(i + 1);
    }
    return number(at) + terms;
  }
  std::string point(Point2 at, const std::vector<Point2>& references) {
    return "(" + sum(at.x, 'x', references) + ", " + sum(at.y, 'y', references) + ") ";
  }
  double near(double x) { return x + 0.001 * (pick(201) - 100); }

  RuleNumbers one(int i) {
    std::vector<Point2> references{{0, 0}, {1, 0}};
    const int shape = pick(3);  // a free triangle, one beside a vertex, a corner of two triangles
    if (shape > 0) references.push_back({near(1.5), near(0.9)});
    std::string points = "(0,0) (1,0)";
    if (shape > 0) points += " (" + number(references[2].x) + "," + number(references[2].y) + ")";
    const Point2 apex{near(0.5), near(0.9)};
    const auto area = [&] {
      std::string text = "(0, 0) (x2, 0) ";
      if (shape == 2) text += "(x3, y3) ";
      return text + point({near(1), near(1.6)}, references) +
             point({near(0), near(1.4)}, references);
    };
    RuleNumbers rule{};
    rule.name = keep("random " + std::to_string(i));
    rule.quality = 1 + pick(30);
    rule.points = keep(points);
    rule.edges = shape == 2 ? "1-2 2-3" : "1-2";
    rule.added = keep(point(apex, references));
    rule.zone = keep(area());
    if (pick(2) == 0) rule.limit = keep(area());
    const std::string_view beside = pick(2) == 0 ? "1-2-4" : "2-4-1";
    rule.elements = shape == 0 ? "1-2-3" : shape == 1 ? beside : "1-2-4 2-3-4";
    rule.newLines = shape == 0 ? "1-3 3-2" : shape == 1 ? "1-4 4-2" : "1-4 4-3";
    return rule;
  }

  std::mt19937 random_;
  std::deque<std::string> texts_;
};

TEST(ImportedRules, OfAnyKindDoWhatTheirNumbersSay) {
  for (unsigned seed = 1; seed <= 6 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomRules random(seed);
    compareAll(random.make(20));
  }
}

TEST(ImportedClassicRules, TolerancesAreThoseOfTheFile) {
  const auto set = load(import(kTriangles));
  ASSERT_TRUE(set);
  const RuleDefinition* right = find(*set, "Right 60 (1)");
  ASSERT_TRUE(right);
  EXPECT_EQ(right->vertices[2].tolerance, (ToleranceForm{0.6, 0, 0.8}));
  EXPECT_EQ(find(*set, "Left 60 (1)")->vertices[2].tolerance, ToleranceForm{});
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(ImportedClassicRules, ReadAsGeometry) {
  const std::string text = import(kTriangles).text;
  for (const char* part : {"c = mid(a, b) + (0, 0.866)", "mid(a, b) + (1, 0.7) => c",
                           "lerp(b, mid(a, c), 1.5) => mid(a, c)", "d = a + (c - b)", "2*d - b",
                           "e = centroid(a, b, c, d)", "mirror \"Left 60 (1)\" { at c ~ 1; }",
                           "mirror \"Left 120 (1)\";",
                           "for (k, s, t) in (5, 0.5, 0.7), (10, 0.3, 0.5), (20, 0.1, 0.2)",
                           "front c -> a -> b -> d;", "front a -> b, c -> d;"})
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
}

TEST(ImportedClassicRules, WhatIsOddInThemIsTold) {
  std::string told;
  for (const Diagnostic& d : import(kQuads).diagnostics) {
    EXPECT_EQ(d.severity, Severity::Warning);
    told += d.rule + ": " + d.message + "; " + d.help + "\n";
  }
  for (const char* part :
       {"quality 1000 switches this rule off", "quality 3000 switches this rule off",
        "Left 120 (1): this element does not run counter-clockwise", "with (1, 4, 3) instead",
        "a tolerance on an end of the base edge has no effect",
        "the mirror image of \"Left Quad (1)\", but for the new points"})
    EXPECT_TRUE(contains(told, part)) << part << "\n" << told;
}

}  // namespace
}  // namespace af2::dsl
