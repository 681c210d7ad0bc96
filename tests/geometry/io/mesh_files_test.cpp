#include "geometry/io/mesh_files.h"

#include <gtest/gtest.h>

#include <cstring>

#include "engine/base/error.h"
#include "tests/support/small_meshes.h"
#include "tests/support/written.h"

namespace af2::geometry {
namespace {

using testing::written;

TEST(MeshFiles, GoByTheExtensionInAnyCase) {
  EXPECT_EQ(meshFormatOf("a.b/mesh.VTU").name, "VTK XML unstructured grid");
  EXPECT_EQ(meshFormatOf("mesh.msh").name, "Gmsh 4.1");
}

TEST(MeshFiles, RefuseAnUnknownExtensionAndNameTheKnownOnes) {
  try {
    meshFormatOf("mesh.xyz");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "cannot write 'mesh.xyz': its extension is not that of a mesh format; use .vtu "
                 ".vtk .msh .msh2 .stl "
                 ".obj .ply .smesh .vol .inp .bdf .nas .med .exo .cgns .glb .html .png .svg");
  }
  EXPECT_THROW(meshFormatOf("mesh"), InputError);
}

TEST(MeshFiles, AreTheSameBytesForTheSameMesh) {
  for (const MeshFormat& format : meshFormats()) {
    if (!isAvailable(format)) continue;
    const ModelMesh mesh =
        format.isOnlyPlanar ? oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) : cubeMesh();
    EXPECT_EQ(written(mesh, format.extension), written(mesh, format.extension)) << format.name;
  }
}

TEST(MeshFiles, CanHoldAnEmptyMesh) {
  for (const MeshFormat& format : meshFormats()) {
    if (!isAvailable(format)) continue;
    EXPECT_FALSE(written({}, format.extension).empty()) << format.name;
  }
}

TEST(MeshFiles, StlSplitsAQuadAlongItsShorterDiagonal) {
  // 84 bytes of head and 50 for each triangle; the first corner follows the normal.
  const std::string bytes =
      written(oneElement({{0, 0, 0}, {3, 0, 0}, {4, 2, 0}, {1, 2, 0}}), ".stl");
  ASSERT_EQ(bytes.size(), 84u + 2 * 50);
  float corner[9];
  std::memcpy(corner, bytes.data() + 84 + 50 + 12, sizeof corner);
  EXPECT_EQ(corner[0], 3);  // second triangle: b, c, d
  EXPECT_EQ(corner[3], 4);
  EXPECT_EQ(corner[6], 1);
}

TEST(MeshFiles, StlIsRefusedWhereSinglePrecisionWouldLoseTriangles) {
  const double far = 1e6, small = 1e-3;
  const auto at = [&](double x, double y) { return Point3{far + x, y, 0}; };
  EXPECT_THROW(written(oneElement({at(0, 0), at(small, 0), at(0, small)}), ".stl"), InputError);
  EXPECT_NO_THROW(written(oneElement({at(0, 0), at(1, 0), at(0, 1)}), ".stl"));
}

TEST(MeshFiles, MshCutsLongNamesBetweenCharacters) {
  ModelMesh mesh = cubeMesh();
  mesh.faces[0].name = std::string(99, 'a') + "\u00e4" + "b";
  mesh.faces[1].name = std::string(100, 'a') + "b";
  const std::string text = written(mesh, ".msh");
  EXPECT_NE(text.find("\"" + std::string(99, 'a') + "\""), std::string::npos);
  EXPECT_NE(text.find("\"" + std::string(100, 'a') + "\""), std::string::npos);
}

TEST(MeshFiles, ObjIsReadable) {
  EXPECT_EQ(written(oneElement({{0, 0, 0.1}, {1, 0, 0}, {0, 1e-300, 0}}), ".obj"),
            "# surface mesh by AF2\nv 0 0 0.1\nv 1 0 0\nv 0 1e-300 0\ng face_1\nf 1 2 3\n");
}

TEST(MeshFiles, VtuEscapesTheNamesOfRules) {
  EXPECT_NE(written(cubeMesh(), ".vtu").find("rule: free &quot;triangle&quot; &lt;a &amp; b&gt;"),
            std::string::npos);
}

}  // namespace
}  // namespace af2::geometry
