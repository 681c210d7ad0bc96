// Where a vertex between triangles moves.
#include "engine/optimize/triangle_star.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/mesh/element_shape.h"
#include "engine/surface/plane_chart.h"

namespace af2 {
namespace {

/// A vertex and those around it, at distances and angles that vary by `unevenness`; out of the
/// plane by up to `height`.
struct Star {
  std::vector<SurfacePoint> around;
  SurfacePoint here{{0, 0, 0}, {0, 0, 1}};

  Star(std::size_t count, double unevenness, double height = 0, unsigned seed = 1) {
    std::mt19937 random(seed);
    const auto vary = [&](double by) {
      return by * (2 * static_cast<double>(random()) / static_cast<double>(random.max()) - 1);
    };
    for (std::size_t i = 0; i < count; ++i) {
      const double turn = 2 * std::numbers::pi / static_cast<double>(count);
      const double angle = turn * (static_cast<double>(i) + vary(0.4 * unevenness));
      const double radius = 1 + vary(0.5 * unevenness);
      around.push_back({{radius * std::cos(angle), radius * std::sin(angle), vary(height)},
                        unit({vary(height), vary(height), 1})});
    }
  }

  std::vector<const SurfacePoint*> ring() const {
    std::vector<const SurfacePoint*> all;
    for (const SurfacePoint& p : around) all.push_back(&p);
    return all;
  }

  /// Moves the vertex by a step in the plane.
  void move() {
    const PlaneChart chart(here, {here.position + Point3{1, 0, 0}, here.normal}, {0, 0, 1}, 1);
    const auto all = ring();
    TriangleStar star;
    ASSERT_TRUE(star.draw(here, all, {chart, 1}));
    here = *chart.transformToSurface(star.improvedPosition(1));
  }

  double distortionAt(std::size_t i) const {
    return triangleDistortion(here, around[i], around[(i + 1) % around.size()]);
  }
  double energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < around.size(); ++i) sum += distortionAt(i) * distortionAt(i);
    return sum;
  }
  bool isPlainlyBelow(double limit) const {
    const PlaneChart chart(here, around[0], {0, 0, 1}, 1);
    const auto all = ring();
    TriangleStar star;
    EXPECT_TRUE(star.draw(here, all, {chart, 1}));
    return star.isPlainlyBelow(limit, here);
  }
};

TEST(TriangleStar, MovesToTheCentreOfARegularPolygon) {
  for (std::size_t count = 3; count <= TriangleStar::kMost; ++count) {
    Star star(count, 0);
    star.here.position = {0.2, 0.1, 0};
    for (int i = 0; i < 10; ++i) star.move();
    EXPECT_LT(length(star.here.position), 1e-6) << count;
  }
}

TEST(TriangleStar, MovesToWhereTheSumOfSquaredDistortionsIsLeast) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Star star(4 + seed % 6, 0.6, 0, seed);
    double before = star.energy();
    for (int i = 0; i < 20; ++i) {
      star.move();
      EXPECT_LE(star.energy(), before * (1 + 1e-12)) << seed;
      before = star.energy();
    }
    const Point3 best = star.here.position;
    for (const Point3& away : {Point3{1e-3, 0, 0}, {-1e-3, 0, 0}, {0, 1e-3, 0}, {0, -1e-3, 0}}) {
      star.here.position = best + away;
      EXPECT_GT(star.energy(), before) << seed;
    }
  }
}

TEST(TriangleStar, StaysWhereATriangleIsInverted) {
  for (const std::size_t count : {5u, 6u}) {
    Star star(count, 0);
    star.here.position = {1.5, 0, 0};
    star.move();
    EXPECT_EQ(star.here.position, (Point3{1.5, 0, 0}));
  }
}

TEST(TriangleStar, IsPlainlyBelowALimitIfEachTriangleIs) {
  int good = 0, tried = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Star star(5 + seed % 3, 0.5, 0.5, seed);
    for (const double limit : {1.05, 1.2, 1.5, 2.}) {
      bool isEach = true;
      for (std::size_t i = 0; i < star.around.size(); ++i)
        isEach &= isPlainlyBelow(limit, star.here, star.around[i],
                                 star.around[(i + 1) % star.around.size()]);
      EXPECT_EQ(star.isPlainlyBelow(limit), isEach) << seed << ' ' << limit;
      good += isEach;
      ++tried;
    }
  }
  EXPECT_GT(good, tried / 4);
  EXPECT_LT(good, 3 * tried / 4);
}

TEST(TriangleStar, IsNotPlainlyBelowALimitIfAVertexHasNoNormalOrFacesAway) {
  for (std::size_t i = 0; i < 5; ++i)
    for (const Point3& normal : {Point3{}, Point3{0, 0, -1}}) {
      Star star(5, 0);
      EXPECT_TRUE(star.isPlainlyBelow(1.2));
      star.around[i].normal = normal;
      EXPECT_FALSE(star.isPlainlyBelow(1.2));
    }
}

/// A chart that leans, so that edges along x look shorter than they are.
struct LeaningChart final : AF2LocalTransform {
  ChartPoint transformFromSurface(const SurfacePoint& point) const override {
    return {{0.5 * point.position.x, point.position.y}, view};
  }
  std::optional<SurfacePoint> transformToSurface(Point2) const override { return std::nullopt; }
  ChartView view = ChartView::Legal;
};

TEST(TriangleStar, DrawsEdgesAsLongAsTheyAreInSpace) {
  const Star star(4, 0);
  const auto all = star.ring();
  LeaningChart leaning;
  TriangleStar drawn;
  ASSERT_TRUE(drawn.draw(star.here, all, {leaning, 1}));
  EXPECT_NEAR(drawn.reach(), 1, 1e-12);
  EXPECT_LT(length(drawn.improvedPosition(1)), 1e-12);

  leaning.view = ChartView::Hidden;
  EXPECT_FALSE(drawn.draw(star.here, all, {leaning, 1}));
}

}  // namespace
}  // namespace af2
