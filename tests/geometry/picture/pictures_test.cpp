#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "geometry/picture/caption.h"
#include "geometry/picture/category_colors.h"
#include "geometry/picture/svg_picture.h"
#include "tests/support/small_meshes.h"
#include "tests/support/written.h"

namespace af2::geometry {
namespace {

using testing::written;

std::size_t countOf(std::string_view text, const std::string& file) {
  std::size_t count = 0;
  for (std::size_t at = file.find(text); at != std::string::npos; at = file.find(text, at + 1))
    ++count;
  return count;
}

ModelMesh planarWithFailedFace() {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.segments = {{VertexId(0), VertexId(1), 1, 1}};
  mesh.faces.push_back({2, "", "plane", "", FaceStatus::Failed, 0, 0, 1, "the front got stuck"});
  mesh.faces.back().stuck = {{{1, 0, 0}, {2, 0, 0}, 0, 0, 1, {}}};
  return mesh;
}

TEST(PngPicture, IsAPngFileOfTwelveHundredPixelsAcross) {
  const std::string png = written(cubeMesh(), ".png");
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(16, 4), std::string("\0\0\x04\xb0", 4));
}

TEST(SvgPicture, HasAPathForEachElementOneForOutlinesAndOneForStuckEdges) {
  const std::string svg = written(planarWithFailedFace(), ".svg");
  EXPECT_EQ(countOf("<path", svg), 3u);
  EXPECT_EQ(countOf("M20 500L500 500L20 20Z", svg), 1u);  // twice as wide as high, y down
  EXPECT_EQ(countOf("d=\"M20 500L500 500\"", svg), 1u);
  EXPECT_EQ(countOf("d=\"M500 500L980 500\"", svg), 1u);
}

TEST(SvgPicture, IsRefusedUnlessTheMeshIsPlanar) {
  try {
    written(cubeMesh(), ".svg");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(".html"), std::string::npos) << error.what();
  }
}

TEST(SvgPicture, HasTheColoursItIsGivenAndNoLegendOnAPage) {
  const ModelMesh mesh = planarWithFailedFace();
  const std::string svg = svgPicture(mesh, [](std::size_t) { return Rgb{1, 0, 0}; });
  EXPECT_EQ(countOf("Z\" fill=\"#ff0000\"", svg), 1u);
  EXPECT_EQ(countOf("<text", svg) + countOf("<rect", svg), 0u);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_THROW(svgPicture(cubeMesh(), colorByQuality(mesh)), InputError);
}

TEST(CategoryColors, AreThoseOfThePage) {
  EXPECT_EQ(hexOf(categoryColor(0)), "#4e79a7");
  EXPECT_EQ(hexOf(categoryColor(11)), "#d4a6c8");
  EXPECT_EQ(hexOf(categoryColor(12)), "#467fb9");
  EXPECT_EQ(hexOf(kColorOfNone), "#969ea6");
}

TEST(Captions, CountElementsAndFailedFaces) {
  EXPECT_EQ(captionOf(planarWithFailedFace()), "1 element, lowest quality 0.87, 1 face failed");
  EXPECT_EQ(captionOf({}), "0 elements");
}

}  // namespace
}  // namespace af2::geometry
