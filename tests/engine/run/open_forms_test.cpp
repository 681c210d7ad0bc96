// A user's own charts, transforms, zones and orders work exactly like the built-in ones.
#include <gtest/gtest.h>

#include "engine/base/predicates.h"
#include "tests/support/meshing.h"

namespace af2 {
namespace {

using namespace af2::testing;

class UserTransform final : public AF2PointTransform {
 public:
  explicit UserTransform(Transform inner) : inner_(std::move(inner)) {}
  std::optional<Point2> transformPoint(const AF2Binding& binding) const override {
    return inner_->transformPoint(binding);
  }

 private:
  Transform inner_;
};

class UserZone final : public AF2FreeZone {
 public:
  explicit UserZone(std::unique_ptr<const AF2FreeZone> inner) : inner_(std::move(inner)) {}
  Box2 boundingBox() const override { return inner_->boundingBox(); }
  bool contains(Point2 p, ZoneBoundary b) const override { return inner_->contains(p, b); }
  bool meets(Point2 p, Point2 q, ZoneBoundary b) const override { return inner_->meets(p, q, b); }

 private:
  std::unique_ptr<const AF2FreeZone> inner_;
};

class UserZoneDef final : public AF2FreeZoneDef {
 public:
  explicit UserZoneDef(std::shared_ptr<const AF2FreeZoneDef> inner) : inner_(std::move(inner)) {}
  Made makeFreeZone(const AF2Binding& binding) const override {
    Made made = inner_->makeFreeZone(binding);
    if (made.zone) made.zone = std::make_unique<UserZone>(std::move(made.zone));
    return made;
  }

 private:
  std::shared_ptr<const AF2FreeZoneDef> inner_;
};

class UserOrder final : public AF2FrontOrder {
  int keyCount() const override { return 1; }
  double key(int, const FrontEdgeFacts& e) const override { return e.level + e.layerA + e.layerB; }
};

class UserMetric final : public AF2ElementMetric {
  std::optional<double> badness(std::span<const Point2> corners) const override {
    return ShapeSizeMetric(10).badness(corners);
  }
};

class UserAcceptance final : public AF2Acceptance {
  bool accepts(double score, int level) const override { return score < 2 + .5 * level * level; }
};

template <class Wrap>
std::shared_ptr<const RuleSet> wrapped(Wrap wrap) {
  RuleSetDefinition set = triangleSetDefinition();
  std::vector<AF2Rule> rules;
  for (const AF2Rule& rule : set.rules) {
    RuleDefinition definition = rule.definition();
    wrap(definition);
    rules.emplace_back(definition);
  }
  set.rules = std::move(rules);
  return std::make_shared<RuleSet>(set);
}

void wrapPoints(RuleDefinition& rule) {
  for (auto& transform : rule.newVertices) transform = std::make_shared<UserTransform>(transform);
}
void wrapZone(RuleDefinition& rule) { rule.zone = std::make_shared<UserZoneDef>(rule.zone); }

std::vector<std::pair<FrontInput, double>> regions() {
  std::vector<std::pair<FrontInput, double>> result;
  result.emplace_back(square(.05), .05);
  result.emplace_back(discWithHole(.02), .02);
  FrontInput uneven;
  std::vector<Point2> points = divided({{0, 0}, {1, 0}}, .05);
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2), points.end());
  for (Point2 p : divided({{1, 0}, {1, 1}, {0, 1}, {0, 0}}, .2)) points.push_back(p);
  points.resize(points.size() - 5);
  addLoop(uneven, points);
  result.emplace_back(uneven, .1);
  return result;
}

void expectSameMeshes(std::shared_ptr<const RuleSet> set) {
  for (const auto& [input, size] : regions()) {
    const MeshingResult expected = meshFlat(input, size);
    EXPECT_EQ(expected.outcome, Outcome::Complete);
    expectEqualResults(AF2Algorithm(set).execute(FlatMaker(), input, UniformSize(size)), expected);
  }
}

TEST(OpenForms, AVirtualChartGivesTheSameMesh) {
  for (const auto& [input, size] : regions())
    expectEqualResults(
        AF2Algorithm(triangleSet()).execute(SlowFlatMaker(), input, UniformSize(size)),
        meshFlat(input, size));
}

/// Overrides only what has to be overridden.
class AllocatingMaker final : public AF2LocalTransformMaker {
  std::unique_ptr<AF2LocalTransform> makeLocalTransform(const SurfacePoint& from,
                                                        const SurfacePoint& to,
                                                        double unit) const override {
    return PlaneChartMaker().makeLocalTransform(from, to, unit);
  }
};

TEST(OpenForms, AMakerWithoutTheSlotGivesTheSameMesh) {
  for (const auto& [input, size] : regions())
    expectEqualResults(
        AF2Algorithm(triangleSet()).execute(AllocatingMaker(), input, UniformSize(size)),
        meshFlat(input, size));
}

TEST(OpenForms, AUsersTransformsGiveTheSameMesh) { expectSameMeshes(wrapped(wrapPoints)); }

TEST(OpenForms, AUsersZonesGiveTheSameMesh) { expectSameMeshes(wrapped(wrapZone)); }

TEST(OpenForms, TransformsAndZonesOfAUserGiveTheSameMesh) {
  expectSameMeshes(wrapped([](RuleDefinition& rule) {
    wrapPoints(rule);
    wrapZone(rule);
  }));
}

TEST(OpenForms, AUsersOrderMetricAndAcceptanceGiveTheSameMesh) {
  RuleSetDefinition set = triangleSetDefinition();
  set.order = std::make_shared<UserOrder>();
  set.metric = std::make_shared<UserMetric>();
  set.acceptance = std::make_shared<UserAcceptance>();
  expectSameMeshes(std::make_shared<RuleSet>(set));
}

// ---- shapes that the polygon cannot say --------------------------------------------------------

/// The union of two convex polygons.
class TwoPolygons final : public AF2FreeZone {
 public:
  TwoPolygons(std::vector<Point2> one, std::vector<Point2> other)
      : one_(std::move(one)), other_(std::move(other)) {}
  Box2 boundingBox() const override {
    const Box2 p = one_.boundingBox(), q = other_.boundingBox();
    return {{std::min(p.low.x, q.low.x), std::min(p.low.y, q.low.y)},
            {std::max(p.high.x, q.high.x), std::max(p.high.y, q.high.y)}};
  }
  bool contains(Point2 p, ZoneBoundary b) const override {
    return one_.contains(p, b) || other_.contains(p, b);
  }
  bool meets(Point2 p, Point2 q, ZoneBoundary b) const override {
    return one_.meets(p, q, b) || other_.meets(p, q, b);
  }

 private:
  ConvexPolygonZone one_, other_;
};

/// The triangle on the base and a narrow antenna above it: not convex.
class AntennaDef final : public AF2FreeZoneDef {
 public:
  Made makeFreeZone(const AF2Binding& binding) const override {
    const double x = binding.vertices[1].x, m = x / 2;
    return {std::make_unique<TwoPolygons>(
                std::vector<Point2>{{0, 0}, {x, 0}, {m, .9}},
                std::vector<Point2>{{m - .05, .8}, {m + .05, .8}, {m + .05, 1.6}, {m - .05, 1.6}}),
            Refusal::None};
  }
};

TEST(OpenForms, AZoneMayBeNonConvex) {
  RuleSetDefinition set = triangleSetDefinition();
  RuleDefinition rule = freeTriangle().definition();
  rule.zone = std::make_shared<AntennaDef>();
  set.rules[0] = AF2Rule(rule);
  for (const auto& [input, size] : regions())
    expectGoodMesh(
        AF2Algorithm(std::make_shared<RuleSet>(set)).execute(FlatMaker(), input, UniformSize(size)),
        input, .01);
}

TEST(OpenForms, AZoneMayBeLargerThanTheWindow) {
  /// Holds everything ahead of the base for a long way; rules out the free triangle early on.
  class Far final : public AF2FreeZoneDef {
    Made makeFreeZone(const AF2Binding& binding) const override {
      const double x = binding.vertices[1].x;
      const double reach = binding.level < 3 ? 40 : 1.2;
      return {std::make_unique<ConvexPolygonZone>(
                  std::vector<Point2>{{0, 0}, {x, 0}, {x, reach}, {0, reach}}),
              Refusal::None};
    }
  };
  RuleSetDefinition set = triangleSetDefinition();
  RuleDefinition rule = freeTriangle().definition();
  rule.zone = std::make_shared<Far>();
  set.rules[0] = AF2Rule(rule);
  const FrontInput input = square(.05);
  expectGoodMesh(
      AF2Algorithm(std::make_shared<RuleSet>(set)).execute(FlatMaker(), input, UniformSize(.05)),
      input, .02);
}

// ---- quadrilaterals ----------------------------------------------------------------------------

RuleDefinition quadRule(std::string name, std::vector<PatternVertex> more,
                        std::vector<PatternEdge> edges) {
  return ruleWith(std::move(name), 1, std::move(more), std::move(edges));
}

/// Enough to fill a rectangle row by row.
std::shared_ptr<const RuleSet> quadSet() {
  RuleDefinition close =
      quadRule("close", {{"c", {1, 1}}, {"d", {0, 1}}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  close.zone = zone({at(0), at(1), at(2), at(3)});
  close.elements = {{{0, 1, 2, 3}}};

  RuleDefinition channel =
      quadRule("channel", {{"c", {1, 1}}, {"d", {0, 1}}}, {{0, 1}, {1, 2}, {3, 0}});
  channel.zone = zone({at(0), at(1), at(2), at(3)});
  channel.elements = {{{0, 1, 2, 3}}};

  RuleDefinition right = quadRule("corner at b", {{"c", {1, 1}}}, {{0, 1}, {1, 2}});
  const Transform d = combine({}, {{0, 1}, {1, -1}, {2, 1}});
  right.newVertices = {d};
  right.newVertexNames = {"d"};
  right.zone = zone({at(0), at(1), at(2), {d, nullptr}});
  right.elements = {{{0, 1, 2, 3}}};

  RuleDefinition left = quadRule("corner at a", {{"d", {0, 1}}}, {{0, 1}, {2, 0}});
  const Transform c = combine({}, {{0, -1}, {1, 1}, {2, 1}});
  left.newVertices = {c};
  left.newVertexNames = {"c"};
  left.zone = zone({at(0), at(1), {c, nullptr}, at(2)});
  left.elements = {{{0, 1, 3, 2}}};

  RuleSetDefinition set = triangleSetDefinition();
  set.name = "quads";
  set.matchTolerance = byLevel(50, [](double) { return .25; });
  set.rules = {AF2Rule(close), AF2Rule(channel), AF2Rule(right), AF2Rule(left)};
  return std::make_shared<RuleSet>(set);
}

TEST(Quads, FillARectangle) {
  FrontInput input;
  addLoop(input, divided({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, .125));
  const MeshingResult result =
      AF2Algorithm(quadSet()).execute(FlatMaker(), input, UniformSize(.125));
  expectGoodMesh(result, input, 0);
  EXPECT_EQ(result.mesh.elements.size(), 128u);
  for (const Element& e : result.mesh.elements) EXPECT_TRUE(e.isQuad());
}

TEST(Quads, AreStuckOnAnOddBoundary) {
  FrontInput input;
  addLoop(input, {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1.5}, {0, 1}, {-.25, .5}});
  const MeshingResult result = AF2Algorithm(quadSet()).execute(FlatMaker(), input, UniformSize(1));
  EXPECT_EQ(result.outcome, Outcome::Stuck);
  EXPECT_FALSE(result.stuck.empty());
}

TEST(Quads, MayTakeTheBaseForTheUnitOfTheChart) {
  RuleSetDefinition set = quadSet()->definition();
  set.unit = ChartUnit::BaseLength;
  FrontInput input;
  addLoop(input, divided({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, .125));
  const MeshingResult result =
      AF2Algorithm(std::make_shared<RuleSet>(set)).execute(FlatMaker(), input, UniformSize(1));
  expectGoodMesh(result, input, 0);
  EXPECT_EQ(result.mesh.elements.size(), 128u);
}

}  // namespace
}  // namespace af2
