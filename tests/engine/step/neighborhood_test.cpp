#include "engine/step/neighborhood.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/support/fronts.h"

namespace af2 {
namespace {

using namespace af2::testing;

struct Scene {
  Front front;
  FrontIndex index{{{-10, -10, 0}, {10, 10, 0}}, 1};

  void add(const std::vector<Point2>& polygon) {
    const std::size_t first = front.capacity();
    addPolygon(front, polygon, first);
    for (std::size_t i = first; i < front.capacity(); ++i) index.insert(front, PlaceId(i));
  }
  std::vector<Neighborhood::Edge> gather(const AF2LocalTransform& transform, double unit,
                                         const Window& window) {
    Neighborhood near;
    near.gather(front, index, StepChart(transform, unit), PlaceId(0u), window);
    return {near.edges().begin(), near.edges().end()};
  }
};

std::set<PlaceId> placesOf(const std::vector<Neighborhood::Edge>& edges) {
  std::set<PlaceId> places;
  for (const auto& e : edges) EXPECT_TRUE(places.insert(e.place).second) << "gathered twice";
  return places;
}

TEST(Neighborhood, HoldsEveryEdgeThatMayMeetTheWindow) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-8, 8);
  for (int round = 0; round < 50; ++round) {
    Scene scene;
    for (int k = 0; k < 40; ++k) {
      const Point2 p{coordinate(random), coordinate(random)};
      scene.add({p, p + Point2{.1 * coordinate(random), .2 * coordinate(random)},
                 p + Point2{.3 * coordinate(random), .1 * coordinate(random)}});
    }
    const auto at = [&](PlaceId id) { return scene.front[id].point; };
    const double unit = .7;
    const PlaneChart fast = flatChart(at(PlaceId(0u)).position, at(PlaceId(1u)).position, unit);
    const SlowFlatChart slow(at(PlaceId(0u)), at(PlaceId(1u)), unit);
    const Window window{-1, -.5, 2, 3};
    std::set<PlaceId> expected;
    for (std::size_t i = 0; i < scene.front.capacity(); ++i) {
      const Point2 p = fast.transformFromSurface(at(PlaceId(i))).position;
      const Point2 q = fast.transformFromSurface(at(scene.front.next(PlaceId(i)))).position;
      if (std::max(p.x, q.x) >= window.lowX && std::min(p.x, q.x) <= window.highX &&
          std::max(p.y, q.y) >= window.lowY && std::min(p.y, q.y) <= window.highY)
        expected.insert(PlaceId(i));
    }
    const auto edges = scene.gather(fast, unit, window);
    EXPECT_EQ(placesOf(edges), expected);
    EXPECT_EQ(placesOf(scene.gather(slow, unit, window)), expected);
    for (const auto& e : edges) {
      EXPECT_EQ(e.from, fast.transformFromSurface(at(e.place)).position);
      EXPECT_EQ(e.to, fast.transformFromSurface(at(scene.front.next(e.place))).position);
      EXPECT_EQ(e.view, ChartView::Legal);
    }
  }
}

TEST(Neighborhood, HoldsTheBaseItselfOnTheXAxis) {
  Scene scene;
  scene.add({{1, 1}, {2, 2}, {0, 3}});
  const PlaneChart chart = flatChart({1, 1, 0}, {2, 2, 0}, 2);
  const auto edges = scene.gather(chart, 2, {0, 0, 1, 1});
  const auto base = std::find_if(edges.begin(), edges.end(),
                                 [](const auto& e) { return e.place == PlaceId(0u); });
  ASSERT_NE(base, edges.end());
  EXPECT_EQ(base->from, (Point2{0, 0}));
  EXPECT_NEAR(base->to.x, std::sqrt(.5), 1e-15);
  EXPECT_NEAR(base->to.y, 0, 1e-15);
}

TEST(Neighborhood, HoldsIsolatedVerticesAsEdgesOfLengthZero) {
  Scene scene;
  scene.add({{0, 0}, {1, 0}, {0, 1}});
  const PlaceId id = scene.front.addIsolated(flatCorner(3, {.5, .75}), 1);
  scene.index.insert(scene.front, id);
  const PlaneChart chart = flatChart({0, 0, 0}, {1, 0, 0}, 1);
  for (const auto& e : scene.gather(chart, 1, {0, 0, 1, 1}))
    if (e.place == id) {
      EXPECT_EQ(e.from, (Point2{.5, .75}));
      EXPECT_EQ(e.to, e.from);
      return;
    }
  FAIL() << "the isolated vertex is missing";
}

/// A chart that looks at normals: those that lean too far are obstacles or hidden.
class LeaningChart final : public AF2LocalTransform {
 public:
  explicit LeaningChart(bool isFast) : isFast_(isFast) {
    frame_ = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, .5, 0, 2};
  }
  ChartPoint transformFromSurface(const SurfacePoint& p) const override {
    return frame_.project(p);
  }
  std::optional<SurfacePoint> transformToSurface(Point2) const override { return std::nullopt; }
  const ProjectionFrame* projection() const override { return isFast_ ? &frame_ : nullptr; }

 private:
  bool isFast_;
  ProjectionFrame frame_;
};

TEST(Neighborhood, ShowsObstaclesAndLeavesOutWhatIsHidden) {
  for (bool isFast : {true, false}) {
    Scene scene;
    scene.add({{0, 0}, {1, 0}, {.5, 1}});
    scene.add({{0, .2}, {1, .2}, {.5, .8}});
    scene.add({{0, .3}, {1, .3}, {.5, .7}});
    for (std::size_t i = 3; i < 6; ++i)
      scene.front[PlaceId(i)].point.normal = unit(Point3{0, 2, 1});  // obstacles
    for (std::size_t i = 6; i < 9; ++i)
      scene.front[PlaceId(i)].point.normal = unit(Point3{0, 0, -1});  // another sheet
    const auto edges = scene.gather(LeaningChart(isFast), 1, {0, 0, 1, 1});
    EXPECT_EQ(edges.size(), 6u);
    for (const auto& e : edges)
      EXPECT_EQ(e.view, e.place.value < 3 ? ChartView::Legal : ChartView::Obstacle);
  }
}

}  // namespace
}  // namespace af2
