// Meshing with zones of other shapes than convex polygons.
#include <gtest/gtest.h>

#include "dsl/shapes/shape.h"
#include "tests/support/meshing.h"

namespace af2::dsl {
namespace {

/// The zone of another definition, put through a combination of shapes that changes nothing.
class DisguisedZoneDef final : public AF2FreeZoneDef {
 public:
  explicit DisguisedZoneDef(std::shared_ptr<const AF2FreeZoneDef> plain)
      : plain_(std::move(plain)) {}

  Made makeFreeZone(const AF2Binding& binding) const override {
    Made made = plain_->makeFreeZone(binding);
    if (!made.zone) return made;
    const auto corners = dynamic_cast<const ConvexPolygonZone&>(*made.zone).corners();
    const Shape shape = Shape::convex({corners.begin(), corners.end()});
    const Box2 box = made.zone->boundingBox();
    // Cut by a diagonal and put together again; the cut is an inner seam.
    const Point2 across = box.high - box.low;
    MadeZone disguised =
        makeZone((shape & Shape::left(box.low, across)) | (shape - Shape::left(box.low, across)));
    return {std::move(disguised.zone), disguised.refusal};
  }

 private:
  std::shared_ptr<const AF2FreeZoneDef> plain_;
};

std::shared_ptr<const RuleSet> disguisedSet() {
  RuleSetDefinition set = testing::triangleSetDefinition();
  for (AF2Rule& rule : set.rules) {
    RuleDefinition definition = rule.definition();
    definition.zone = std::make_shared<DisguisedZoneDef>(definition.zone);
    rule = AF2Rule(std::move(definition));
  }
  return std::make_shared<RuleSet>(std::move(set));
}

TEST(ShapeZones, GiveTheMeshOfTheFastForm) {
  const FrontInput input = testing::discWithHole(0.05);
  const MeshingResult plain = testing::meshFlat(input, 0.05);
  const MeshingResult other =
      AF2Algorithm(disguisedSet()).execute(testing::FlatMaker(), input, UniformSize(0.05));
  testing::expectGoodMesh(plain, input, 0.2);
  testing::expectEqualResults(plain, other);
}

/// Round zones: a disc around each new vertex, and the new element itself.
TEST(ShapeZones, MayBeRound) {
  class RoundZoneDef final : public AF2FreeZoneDef {
   public:
    Made makeFreeZone(const AF2Binding& match) const override {
      const Point2 a = match.vertices[0], b = match.vertices[1];
      const Point2 apex = 0.5 * (a + b) + Point2{0, 0.866};
      MadeZone made = makeZone((Shape::hull({a, b, apex}) | Shape::disc(apex, 0.6 / match.level)) &
                               Shape::left(a, b - a));
      return {std::move(made.zone), made.refusal};
    }
  };
  RuleSetDefinition set = testing::triangleSetDefinition();
  RuleDefinition definition = set.rules[0].definition();
  definition.zone = std::make_shared<RoundZoneDef>();
  set.rules[0] = AF2Rule(std::move(definition));
  const FrontInput input = testing::discWithHole(0.05);
  const MeshingResult result = AF2Algorithm(std::make_shared<RuleSet>(std::move(set)))
                                   .execute(testing::FlatMaker(), input, UniformSize(0.05));
  testing::expectGoodMesh(result, input, 0.1);
}

}  // namespace
}  // namespace af2::dsl
