#include "cli/meshing/model_formats.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "geometry/faceted/facets.h"
#include "geometry/io/mesh_files.h"
#include "geometry/planar/planar_file.h"

namespace af2::cli {
namespace {

std::string page(const char* name) {
  std::ostringstream text;
  text << std::ifstream(std::string(AF2_SOURCE_DIR "/docs/") + name).rdbuf();
  return text.str();
}

/// A row of the table of models in docs/formats.md.
std::string rowOf(const geometry::FileFormat& format, const std::string& kind) {
  std::string extensions;
  for (const std::string_view extension : format.extensions)
    if (!extension.empty()) extensions += "`" + std::string(extension) + "` ";
  return "| " + std::string(format.name) + " | " + extensions + "| " + kind + " |";
}

TEST(ModelFormats, TellTheKindOfAModelByItsExtension) {
  EXPECT_EQ(modelKindOf("plate.POLY"), ModelKind::Planar);
  EXPECT_EQ(modelKindOf("a.stl/plate.in2d"), ModelKind::Planar);
  EXPECT_EQ(modelKindOf("part.stl"), ModelKind::Faceted);
  EXPECT_EQ(modelKindOf("part.OBJ"), ModelKind::Faceted);
  EXPECT_EQ(modelKindOf("part.step"), ModelKind::Cad);
  EXPECT_EQ(modelKindOf("part.unknown"), ModelKind::Cad);
  EXPECT_EQ(modelKindOf("part"), ModelKind::Cad);
}

TEST(ModelFormats, AreListedInTexts) {
  EXPECT_EQ(formatNames(ModelKind::Faceted, "and"), "STL, OBJ, PLY, OFF, Gmsh, VTK XML and VTK");
  const std::string all = formatNames("or"), others = "VTK XML, VTK, .poly or .in2d";
  EXPECT_TRUE(all.ends_with(others)) << all;
  EXPECT_TRUE(
      modelHelp().ends_with("VTK XML or VTK file (triangles), .poly or .in2d file (planar)"));
}

TEST(ModelFormats, AreAllInTheDocumentation) {
  const std::string text = page("formats.md");
  for (const geometry::FileFormat& format : geometry::planarFormats())
    EXPECT_NE(text.find(rowOf(format, "planar domain")), std::string::npos) << format.name;
  for (const geometry::FileFormat& format : geometry::facetFormats())
    EXPECT_NE(text.find(rowOf(format, "surface of triangles")), std::string::npos) << format.name;
  const std::string cad = formatNames(ModelKind::Cad, "or");
  EXPECT_TRUE(cad.empty() || cad == "STEP, IGES or BREP") << "its row is missing in formats.md";
}

TEST(MeshFormats, AreAllInTheDocumentationWithWhatTheyHold) {
  const std::string text = page("formats.md");
  for (const geometry::MeshFormat& format : geometry::meshFormats()) {
    const std::size_t row = text.find("\n| `" + std::string(format.extension) + "` | ");
    ASSERT_NE(row, std::string::npos) << format.extension;
    const std::string line = text.substr(row + 1, text.find('\n', row + 1) - row);
    EXPECT_EQ(line.find("second order") != std::string::npos, format.holdsSecondOrder) << line;
    EXPECT_EQ(line.find("lines") != std::string::npos, format.holdsLines) << line;
  }
}

}  // namespace
}  // namespace af2::cli
