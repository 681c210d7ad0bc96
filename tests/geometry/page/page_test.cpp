#include <gtest/gtest.h>

#include "geometry/page/page_parts.h"
#include "tests/support/small_meshes.h"
#include "tests/support/written.h"

namespace af2::geometry {
namespace {

using testing::written;

bool contains(const std::string& page, std::string_view text) {
  return page.find(text) != std::string::npos;
}

TEST(Page, HasAllItsPartsInsteadOfTheirNames) {
  const std::string page = written(cubeMesh(), ".html");
  for (const char* part : {"page.css", "three/three.min.js", "shape.js", "main.js"}) {
    EXPECT_TRUE(contains(page, pagePart(part))) << part;
    EXPECT_FALSE(contains(page, "@" + std::string(part) + "@")) << part;
  }
  EXPECT_TRUE(contains(page, "three.js 0.187.0, MIT licence"));
  EXPECT_FALSE(contains(page, "@data@"));
}

TEST(Page, HoldsCornersInBase64) {
  const std::string page = written(oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), ".html");
  EXPECT_TRUE(
      contains(page, "id=\"array-corners\" data-type=\"Uint32\">AAAAAAEAAAACAAAA</script>"));
  EXPECT_TRUE(contains(page, "\"cornersPerElement\":3"));
}

TEST(Page, MarksTheFourthCornerOfATriangleAmongQuadrilaterals) {
  ModelMesh mesh = cubeMesh();
  std::swap(mesh.elements.front(), mesh.elements.back());
  mesh.elements.resize(2);
  mesh.face.resize(2);
  mesh.origins.resize(2);
  // 4, 5, 6, 7 and then 0, 2, 1 and the largest number
  EXPECT_TRUE(
      contains(written(mesh, ".html"), ">BAAAAAUAAAAGAAAABwAAAAAAAAACAAAAAQAAAP////8=</script>"));
}

TEST(Page, HasScoresOnlyIfTheMeshHas) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_FALSE(contains(written(mesh, ".html"), "id=\"array-score\""));
  mesh.scores = {0.5F};
  EXPECT_TRUE(
      contains(written(mesh, ".html"), "id=\"array-score\" data-type=\"Float32\">AAAAPw=="));
}

TEST(Page, NamesTheMeshAndWhereItsRulesAreWritten) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.name = "part.step";
  mesh.ruleTexts = {{"tri/even.af2", 48, "rule \"only\" {}"}};
  const std::string page = written(mesh, ".html");
  EXPECT_TRUE(contains(page, "\"title\":\"part.step\""));
  EXPECT_TRUE(contains(
      page, R"({"name":"only","file":"tri/even.af2","line":48,"text":"rule \"only\" {}"})"));
}

TEST(Page, LetsNoNameEndItsData) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.faces[0].name = "</script><b>";
  const std::string page = written(mesh, ".html");
  EXPECT_FALSE(contains(page, "</script><b>"));
  EXPECT_TRUE(contains(page, "\\u003c/script>\\u003cb>"));
}

TEST(Page, ListsWhereTheFrontsOfFailedFacesGotStuck) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.faces.push_back({2, "", "sphere", "", FaceStatus::Failed, 0, 0, 1, "the front got stuck"});
  mesh.faces.back().stuck = {{{1, 2, 3}, {4, 5, 6}, 0, 0, 7, {{0, Refusal::ZoneHitByEdge}}}};
  EXPECT_TRUE(contains(
      written(mesh, ".html"),
      R"({"from":[1.0,2.0,3.0],"to":[4.0,5.0,6.0],"level":7,"refused":[[0,"zone hit by edge"]]})"));
}

}  // namespace
}  // namespace af2::geometry
