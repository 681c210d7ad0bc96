#include "dsl/picture/rule_picture.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "dsl/picture/coverage_picture.h"
#include "sample_rules.h"

namespace af2::dsl {
namespace {

/// Set AF2_PICTURES to a folder to look at what the tests draw.
void keep(const std::string& name, const std::string& bytes) {
  if (const char* folder = std::getenv("AF2_PICTURES"))
    std::ofstream(std::string(folder) + "/" + name, std::ios::binary) << bytes;
}

bool isPng(const std::string& bytes) {
  return bytes.rfind("\x89PNG", 0) == 0 && bytes.find("IEND") != std::string::npos;
}

bool isSvg(const std::string& bytes) {
  return bytes.rfind("<?xml", 0) == 0 && bytes.find("</svg>") != std::string::npos;
}

TEST(RulePicture, IsAFileOfTheFormatAskedFor) {
  const RuleSet rules = test::sampleRules();
  for (const AF2Rule& rule : rules.rules()) {
    const std::string png = drawRule(rules, rule, PictureFormat::Png);
    const std::string svg = drawRule(rules, rule, PictureFormat::Svg);
    EXPECT_TRUE(isPng(png));
    EXPECT_TRUE(isSvg(svg));
    keep(rule.name() + ".png", png);
    keep(rule.name() + ".svg", svg);
  }
}

TEST(RulePicture, IsTheSameEveryTime) {
  const RuleSet rules = test::sampleRules();
  for (const PictureFormat format : {PictureFormat::Svg, PictureFormat::Png})
    EXPECT_EQ(drawRuleSet(rules, format), drawRuleSet(rules, format));
}

TEST(RulePicture, ShowsAllRulesOnOneSheet) {
  const RuleSet rules = test::sampleRules();
  const std::string png = drawRuleSet(rules, PictureFormat::Png);
  EXPECT_TRUE(isPng(png));
  keep("sheet.png", png);
  keep("sheet.svg", drawRuleSet(rules, PictureFormat::Svg));
}

TEST(RulePicture, ChangesWithTheLevelsAskedFor) {
  const RuleSet rules = test::sampleRules();
  const AF2Rule& rule = rules.rules().front();
  EXPECT_NE(drawRule(rules, rule, PictureFormat::Svg, {.levels = {1}}),
            drawRule(rules, rule, PictureFormat::Svg, {.levels = {1, 3}}));
}

TEST(RulePicture, ShowsWhereAVertexMoves) {
  RuleDefinition definition = test::sampleRules().rules()[1].definition();
  const auto drawn = [&](ReferenceByLevel reference) {
    definition.vertices[2].reference = std::move(reference);
    const AF2Rule rule(definition);
    const std::string png = drawRule(test::sampleRules(), rule, PictureFormat::Png);
    keep("moving.png", png);
    return png;
  };
  const std::string still = drawn({0.5, 0.866});
  EXPECT_NE(drawn(ReferenceByLevel(std::vector<Point2>{{0.5, 0.866}, {0.6, 0.7}, {0.8, 0.4}})),
            still);
}

TEST(RulePicture, ShowsAMatchWithItsFaults) {
  const RuleSet rules = test::sampleRules();
  const DrawnMatch match{{{0, 0}, {1.2, 0}, {0.2, 0.9}}, 1, {{0.4, 1.0}}, "a corner pokes out"};
  const std::string png = drawMatch(rules, rules.rules()[1], match, PictureFormat::Png);
  EXPECT_TRUE(isPng(png));
  keep("match.png", png);
}

TEST(RulePicture, SaysWhenThereIsNoZone) {
  const RuleSet rules = test::sampleRules();
  const DrawnMatch match{{{0, 0}, {1, 0}, {1, 1}, {0.6, -1}}, 1, {}, ""};
  const std::string png = drawMatch(rules, rules.rules()[4], match, PictureFormat::Png);
  EXPECT_TRUE(isPng(png));
  keep("no zone.png", png);
}

TEST(CoveragePicture, ShowsTheThreeMaps) {
  const RuleSet rules = test::sampleRules();
  const Coverage coverage = measureCoverage(rules, 5);
  const std::string png = drawCoverage(coverage, rules.name(), PictureFormat::Png);
  EXPECT_TRUE(isPng(png));
  EXPECT_TRUE(isSvg(drawCoverage(coverage, rules.name(), PictureFormat::Svg)));
  keep("coverage.png", png);
}

}  // namespace
}  // namespace af2::dsl
