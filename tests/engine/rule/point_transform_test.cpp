// Numbers marked "reference" are those of MeshKit's tests of its linear point transform
// (test/algs/AdvFront/pntTrnsfrmLnr2D.cpp).
#include "engine/rule/point_transform.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "engine/base/error.h"

namespace af2 {
namespace {

using Term = AffinePointTransform::Term;
using Points = std::vector<Point2>;

const AF2Surroundings kNoSurroundings;

Point2 place(const AffinePointTransform& transform, const Points& bound) {
  const auto point = transform.transformPoint({bound, 1, &kNoSurroundings});
  EXPECT_TRUE(point);
  return point.value_or(Point2{});
}

void expectPoint(Point2 actual, Point2 expected, double tolerance = 1e-14) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
}

struct DeviationCase {
  const char* name;
  Points reference, bound;
  std::vector<double> x, y;
  Point2 point, expected;
};

class DeviationForm : public ::testing::TestWithParam<DeviationCase> {};

TEST_P(DeviationForm, GivesTheReferenceValue) {
  const DeviationCase& c = GetParam();
  expectPoint(place(AffinePointTransform::fromDeviations(c.point, c.reference, c.x, c.y), c.bound),
              c.expected);
}

INSTANTIATE_TEST_SUITE_P(
    PointTransform, DeviationForm,
    ::testing::Values(
        DeviationCase{
            "XOnly", {{0, 0}}, {{.75, .25}}, {1, 0}, {0, 0}, {.5, .5}, {1.25, .5}},  // line 206
        DeviationCase{
            "YOnly", {{1, 1}}, {{1.75, 1.25}}, {0, 0}, {0, 1}, {.5, .5}, {.5, .75}},  // line 238
        DeviationCase{
            "Full", {{0, 0}}, {{1, 10}}, {1, -2}, {-3, 4}, {0, 0}, {-19, 37}},  // line 270
        DeviationCase{"TwoVertices",
                      {{0, 0}, {1, 0}},
                      {{.125, .25}, {1.5, .0625}},
                      {1, 0, 0, 3},
                      {0, 5, 1, 0},
                      {0, 0},
                      {.3125, 1.75}}),  // line 302
    [](const auto& c) { return c.param.name; });

TEST(PointTransform, RejectsCoefficientListsThatAreNotTwiceAsLongAsTheReference) {
  const Points reference{{0, 0}, {1, 0}};
  const std::vector<double> fits(4, 1.0);
  const auto make = [&](const std::vector<double>& x, const std::vector<double>& y) {
    return AffinePointTransform::fromDeviations({0, 0}, reference, x, y);
  };
  EXPECT_NO_THROW(make(fits, fits));
  for (std::size_t length : {0u, 1u, 2u, 3u, 5u, 6u}) {
    const std::vector<double> wrong(length, 1.0);
    EXPECT_THROW(make(wrong, fits), InputError) << length;
    EXPECT_THROW(make(fits, wrong), InputError) << length;
  }
}

TEST(PointTransform, SaysWhichListIsWrong) {
  const Points reference{{0, 0}};
  const std::vector<double> two(2, 1.0), three(3, 1.0);
  try {
    AffinePointTransform::fromDeviations({0, 0}, reference, two, three);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "affine transform: 3 y coefficients for 1 reference vertices; give two for each");
  }
}

TEST(PointTransform, RejectsABindingWithoutTheVerticesItNeeds) {
  const AffinePointTransform transform({0, 0}, {{2, 1, 0, 0, 1}});
  const Points two{{0, 0}, {1, 0}};
  EXPECT_THROW(transform.transformPoint({two, 1, &kNoSurroundings}), InputError);
  EXPECT_THROW(transform.transformPoint({Points{}, 1, &kNoSurroundings}), InputError);
}

TEST(PointTransform, NeedsEveryReferenceVertexThatItUses) {
  // Reference: a reference vertex without a bound value is an error at evaluation (line 169).
  const Points reference{{0, 0}, {1, 0}};
  const std::vector<double> ones(4, 1.0);
  const auto transform = AffinePointTransform::fromDeviations({0, 0}, reference, ones, ones);
  const Points one{{0, 0}};
  EXPECT_THROW(transform.transformPoint({one, 1, &kNoSurroundings}), InputError);
}

TEST(PointTransform, RejectsNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(AffinePointTransform({nan, 0}, {}), InputError);
  EXPECT_THROW(AffinePointTransform({0, inf}, {}), InputError);
  EXPECT_THROW(AffinePointTransform({0, 0}, {{0, nan, 0, 0, 1}}), InputError);
  EXPECT_THROW(AffinePointTransform({0, 0}, {{0, 1, 0, -inf, 1}}), InputError);
}

TEST(PointTransform, RejectsSumsOfTermsThatAreNotFinite) {
  const double large = std::numeric_limits<double>::max();
  EXPECT_THROW(AffinePointTransform({0, 0}, {{0, large, 0, 0, 1}, {0, large, 0, 0, 1}}),
               InputError);
}

TEST(PointTransform, RejectsANegativeVertex) {
  EXPECT_THROW(AffinePointTransform({0, 0}, {{-1, 1, 0, 0, 1}}), InputError);
}

TEST(PointTransform, VertexIsTheMatchedVertexToTheLastBit) {
  const Points bound{{0, 0}, {.1, 0}, {0.1 + 0.2, -1e-17}};
  EXPECT_EQ(place(AffinePointTransform::vertex(2), bound), bound[2]);
}

TEST(PointTransform, KeepsTermsInOrderAddsThoseOfOneVertexAndDropsZeros) {
  const AffinePointTransform transform({0, 0}, {{3, 1, 0, 0, 1},
                                                {1, .5, 0, 0, .5},
                                                {3, 1, 2, 0, 1},
                                                {2, 1, 0, 0, 1},
                                                {2, -1, 0, 0, -1},
                                                {4, 0, 0, 0, 0}});
  const std::vector<Term> expected{{1, .5, 0, 0, .5}, {3, 2, 2, 0, 2}};
  EXPECT_EQ(std::vector<Term>(transform.terms().begin(), transform.terms().end()), expected);
  EXPECT_EQ(transform.vertexCount(), 4);
}

TEST(PointTransform, BlendMeansTheWeightedMeanOfThePoints) {
  const AffinePointTransform p({1, 2}, {{0, 1, 2, 3, 4}, {2, 1, 0, 0, 1}});
  const AffinePointTransform q({-1, 0}, {{1, .5, -1, 2, .25}});
  const Points bound{{.3, .4}, {1.25, 0}, {-.5, .75}};
  for (double t : {0.0, .02, .25, 1.0}) {
    const Point2 mean = t * place(p, bound) + (1 - t) * place(q, bound);
    expectPoint(place(p.blend(q, t), bound), mean);
  }
  EXPECT_EQ(p.blend(q, 1), p);
  EXPECT_EQ(p.blend(q, 0), q);
}

TEST(PointTransform, AgreesWithItsDeviationFormOnRandomValues) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int n = 0; n < 500; ++n) {
    const auto point = [&] { return Point2{number(random), number(random)}; };
    const Points reference{point(), point(), point()}, bound{point(), point(), point()};
    std::vector<double> x(6), y(6);
    for (int i = 0; i < 6; ++i) {
      x[static_cast<std::size_t>(i)] = number(random);
      y[static_cast<std::size_t>(i)] = number(random);
    }
    const Point2 origin = point();
    Point2 expected = origin;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 d = bound[i] - reference[i];
      expected.x += x[2 * i] * d.x + x[2 * i + 1] * d.y;
      expected.y += y[2 * i] * d.x + y[2 * i + 1] * d.y;
    }
    expectPoint(place(AffinePointTransform::fromDeviations(origin, reference, x, y), bound),
                expected, 1e-13);
  }
}

}  // namespace
}  // namespace af2
