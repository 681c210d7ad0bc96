#include "dsl/picture/piece_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dsl/load/rule_file.h"
#include "dsl/picture/piece_scene.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

constexpr const char* kApexAndCorner = R"(
af2 1;
ruleset "two rules" {
  elements tri;
  match    0.1*q;
  score    max of shape_size(10);
  accept   score < 1 + q;
  front    by q;
}
rule "apex" quality 1 {
  new  d = mid(a, b) + (0, 0.866);
  zone a, b, d + (0.5, 0), d + (0, 0.5), d - (0.5, 0);
  tri  a b d;
}
rule "corner" quality 1 {
  front a -> b -> c;
  at    c (0.5, 0.866);
  zone  a, b, c;
  tri   a b c;
}
)";

/// A front p -> r -> s, with vertices that stand alone, and the step at p -> r.
class PiecePicture : public ::testing::Test {
 protected:
  PiecePicture() {
    LoadOptions options;
    options.allowed = {Code::MissingMirror};
    rules = loadRulesFromText("two.af2", kApexAndCorner, options).rules;
  }

  void setUp(Point2 s, const std::vector<Point2>& points) {
    piece.vertices = {{2, 1}, {2, 2}, Point2{2, 1} + Point2{-s.y, s.x}};
    piece.chains = {{0, 1, 2}};
    piece.base = {0, 1};
    names = {"p", "r", "s"};
    for (const Point2 at : points) {
      names.push_back("o" + std::to_string(names.size()));
      piece.isolated.push_back(piece.vertices.size());
      piece.vertices.push_back(Point2{2, 1} + Point2{-at.y, at.x});
    }
    SingleStepper stepper(*rules);
    explained = explainStep(*rules, stepper, piece, names, true);
  }

  picture::PieceScene scene(const std::string& rule = {}) const {
    return picture::sceneOf(*rules, piece, names, explained, rule);
  }

  std::shared_ptr<const RuleSet> rules;
  FrontPiece piece;
  std::vector<std::string> names;
  StepExplanation explained;
};

bool hasVertex(const picture::PieceScene& scene, const std::string& name) {
  return std::ranges::count(scene.vertices, name, &picture::PieceScene::Vertex::name) == 1;
}

TEST_F(PiecePicture, ShowsTheElementsOfTheRuleThatWasAppliedInTheFrameOfTheBaseEdge) {
  setUp({2, -1}, {});
  const picture::PieceScene drawn = scene();
  ASSERT_EQ(drawn.elements.size(), 1u);
  EXPECT_NEAR(distance(drawn.elements[0][2], {0.5, 0.866}), 0, 1e-12);
  EXPECT_EQ(drawn.newFront.size(), 2u);
  EXPECT_TRUE(drawn.culprits.empty());
  EXPECT_TRUE(hasVertex(drawn, "p = a"));
  EXPECT_TRUE(hasVertex(drawn, "s"));
  EXPECT_TRUE(hasVertex(drawn, "d"));
  EXPECT_TRUE(drawn.reason.starts_with("Rule \"apex\": applied; score")) << drawn.reason;
}

TEST_F(PiecePicture, MarksTheVertexInTheZone) {
  setUp({2, -1}, {{3, 3}, {0.5, 0.9}});
  const picture::PieceScene drawn = scene();
  EXPECT_TRUE(drawn.elements.empty());
  EXPECT_EQ(drawn.culprits, std::vector<std::size_t>{4});
  EXPECT_TRUE(drawn.vertices[4].isCulprit);
  EXPECT_FALSE(drawn.vertices[3].isCulprit);
  EXPECT_FALSE(drawn.zones.empty());
  EXPECT_NE(drawn.reason.find("vertex o4 at (0.5, 0.9) lies in the zone"), std::string::npos)
      << drawn.reason;
}

TEST_F(PiecePicture, ShowsWhereARuleThatWasNotAppliedWantsItsVertices) {
  setUp({2, -1}, {});
  const picture::PieceScene drawn = scene("corner");
  ASSERT_EQ(drawn.deviations.size(), 1u);
  EXPECT_EQ(drawn.deviations[0].first, (Point2{0.5, 0.866}));
  EXPECT_TRUE(hasVertex(drawn, "s = c"));
  EXPECT_TRUE(drawn.reason.ends_with("Rule \"apex\" was applied instead.")) << drawn.reason;
}

TEST_F(PiecePicture, IsTheSameFileEveryTimeAndChangesWithTheFront) {
  setUp({2, -1}, {{0.5, 0.9}});
  const PieceCaption caption{"a title", {"The test fails."}, ""};
  const auto draw = [&](PictureFormat format) {
    return drawPiece(*rules, piece, names, explained, caption, format);
  };
  const std::string svg = draw(PictureFormat::Svg);
  EXPECT_TRUE(svg.starts_with("<?xml"));
  EXPECT_EQ(svg, draw(PictureFormat::Svg));
  EXPECT_TRUE(draw(PictureFormat::Png).starts_with("\x89PNG"));
  piece.isolated.clear();
  piece.vertices.clear();
  setUp({2, -1}, {});
  EXPECT_NE(svg, draw(PictureFormat::Svg));
}

TEST_F(PiecePicture, NamesARuleThatIsNotThere) {
  setUp({2, -1}, {});
  EXPECT_THROW(scene("cornr"), InputError);
}

}  // namespace
}  // namespace af2::dsl
