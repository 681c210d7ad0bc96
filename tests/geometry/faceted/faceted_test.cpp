// A surface of triangles as geometry.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>

#include "engine/base/error.h"
#include "geometry/check/model_check.h"
#include "geometry/faceted/half_edges.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/faceted/patches.h"
#include "geometry/mesh/quality.h"
#include "geometry/mesh/second_order.h"
#include "tests/geometry/faceted/faceted_mesh.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

/// An OBJ file of a box, all faces turned outwards.
const std::string kBox =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

Facets read(const std::string& name, const std::string& text) {
  return readFacets(testing::TestFile(name, text).path());
}

/// A grid of (u, v) in [0, 1)^2 that closes in both directions.
template <class Position>
Facets torusLike(std::uint32_t n, std::uint32_t m, Position position) {
  Facets facets;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j)
      facets.vertices.push_back(position(2 * pi * i / n, 2 * pi * j / m));
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const std::uint32_t a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m,
                          d = i * m + (j + 1) % m;
      facets.triangles.push_back({a, b, c});
      facets.triangles.push_back({a, c, d});
    }
  return facets;
}

Facets thickTorus() {
  return torusLike(48, 24, [](double u, double v) {
    const double r = 3 + std::cos(v);
    return Point3{r * std::cos(u), r * std::sin(u), std::sin(v)};
  });
}

TEST(Faceted, RefusesSizesThatAskForTooManyElements) {
  MeshingOptions options;
  options.sizes.size = 1e-5;
  const AF2Algorithm algorithm(testing::triangleSet());
  EXPECT_THROW(meshFaceted(read("box.obj", kBox), algorithm, options), InputError);
}

TEST(Faceted, RefusesGrowthThatAFrontCannotFollow) {
  MeshingOptions options;
  options.sizes.size = 1;
  options.sizes.growth = 1000;
  const AF2Algorithm algorithm(testing::triangleSet());
  EXPECT_THROW(meshFaceted(read("box.obj", kBox), algorithm, options), InputError);
  options.sizes.growth = 10;
  testing::completeMesh(read("box.obj", kBox), options);
}

TEST(Faceted, GetsEvenLoops) {
  const std::string prism =
      "v 0 0 0\nv 2 0 0\nv 0 1.7 0\nv 0 0 1.3\nv 2 0 1.3\nv 0 1.7 1.3\n"
      "f 1 3 2\nf 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n";
  MeshingOptions options;
  int odd = 0;
  for (const double size : {0.15, 0.19, 0.23, 0.3}) {
    options.sizes.size = size;
    options.evenLoops = false;
    for (const FaceReport& face : testing::completeMesh(read("prism.obj", prism), options).faces)
      odd += static_cast<int>(face.oddLoops.size());
    options.evenLoops = true;
    for (const FaceReport& face : testing::completeMesh(read("prism.obj", prism), options).faces)
      EXPECT_TRUE(face.oddLoops.empty()) << size;
  }
  EXPECT_GT(odd, 0);
}

TEST(Facets, OfAnObjFileShareTheirVertices) {
  const Facets box = read("box.obj", kBox);
  EXPECT_EQ(box.vertices.size(), 8u);
  EXPECT_EQ(box.triangles.size(), 12u);
}

TEST(Facets, OfAnObjFileMayBeConcavePolygonsOverSeveralLines) {
  const std::string ell = "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n";
  for (const char* face : {"f 1 2 3 4 5 6\n", "f 3 4 5 6 1 2\n", "f 6 1 2 \\\n3 4 5\n",
                           "f 2 1 6 5 4 3\n", "f 5 6 1 2 3\\\r\n 4\r\n"}) {
    const Facets facets = read("ell.obj", ell + face);
    ASSERT_EQ(facets.triangles.size(), 4u) << face;
    const bool isTurned = std::string(face) == "f 2 1 6 5 4 3\n";
    double area = 0;
    for (const auto& t : facets.triangles) {
      const Point3& a = facets.vertices[t[0]];
      const double z = cross(facets.vertices[t[1]] - a, facets.vertices[t[2]] - a).z / 2;
      EXPECT_GT(isTurned ? -z : z, 0) << face;
      area += std::abs(z);
    }
    EXPECT_DOUBLE_EQ(area, 3) << face;
  }
}

TEST(Facets, OfTextAndBinaryStlFilesAreTheSame) {
  const std::string text =
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid x\n";
  const Facets fromText = read("a.stl", text);
  std::string binary(80, 's');
  const auto put = [&](auto value) {
    binary.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(std::uint32_t{2});
  for (const auto& triangle : fromText.triangles) {
    for (int i = 0; i < 3; ++i) put(0.0f);
    for (const std::uint32_t v : triangle) {
      const Point3& p = fromText.vertices[v];
      for (const double x : {p.x, p.y, p.z}) put(static_cast<float>(x));
    }
    put(std::uint16_t{0});
  }
  const Facets fromBinary = read("b.stl", binary);
  EXPECT_EQ(fromText.vertices.size(), 4u);
  EXPECT_EQ(fromText.vertices, fromBinary.vertices);
  EXPECT_EQ(fromText.triangles, fromBinary.triangles);
  const Facets andMore = read("c.stl", binary + "more");
  EXPECT_EQ(fromText.triangles, andMore.triangles);
  EXPECT_EQ(andMore.notes.front().find("4 bytes after the last of 2 triangles"), 0u);
  EXPECT_THROW(read("d.stl", binary.substr(0, binary.size() - 1)), InputError);
}

TEST(Facets, TellWhatIsWrongWithAFile) {
  const auto faultOf = [](const std::string& name, const std::string& text) -> std::string {
    try {
      read(name, text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(faultOf("a.obj", "v 0 0 0\nf 1 2 3\n").find("a.obj:2: there is no vertex 2"),
            std::string::npos);
  EXPECT_NE(faultOf("a.obj", "v 0 0 x\n").find(":1: 'x' is not a number"), std::string::npos);
  EXPECT_NE(faultOf("a.obj", "v 0 0 0\n").find("contains no triangle"), std::string::npos);
  EXPECT_NE(faultOf("a.stl", "solid empty\nendsolid empty\n").find("contains no triangle"),
            std::string::npos);
  EXPECT_NE(faultOf("a.stl", "nothing").find("is not an STL file"), std::string::npos);
  EXPECT_NE(faultOf("a.stl", "facet normal 0 0 1 outer loop\nouter loop\nvortex 0 0 0").find(":3:"),
            std::string::npos);
}

TEST(Faceted, TellsWhenTheMeshEnclosesAnotherVolume) {
  const auto tellsOfVolume = [](const ModelMesh& mesh) {
    return std::ranges::any_of(
        mesh.notes, [](const std::string& note) { return note.starts_with("the mesh encloses "); });
  };
  const Facets torus = thickTorus();
  const ModelMesh coarse = testing::completeMesh(torus, 1),
                  fine = testing::completeMesh(torus, 0.2);
  EXPECT_LT(testing::volumeOf(coarse), 0.98 * testing::volumeOf(fine));
  EXPECT_TRUE(tellsOfVolume(coarse));
  EXPECT_FALSE(tellsOfVolume(fine));
}

TEST(Patches, AreBetweenFeatureEdges) {
  const PatchedFacets box = findPatches(read("box.obj", kBox), {pi / 4});
  EXPECT_EQ(box.patches.size(), 6u);
  EXPECT_EQ(box.curves.size(), 12u);
  for (const Patch& patch : box.patches) {
    ASSERT_EQ(patch.loops.size(), 1u);
    EXPECT_EQ(patch.loops[0].size(), 4u);
  }
}

/// Rounding leaves triangles along an edge that look nowhere, such as two beside the upper front
/// edge of the box.
TEST(Patches, WithoutWidthArePartOfThoseBesideThem) {
  const std::string sliver =
      "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
      "v 0.5 -0.00001 1.99999\nv 1.5 -0.00001 1.99999\n"
      "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 10 9 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
      "f 6 5 9\nf 6 9 10\n";
  const Facets facets = read("sliver.obj", sliver);
  EXPECT_EQ(findPatches(facets, {40 * pi / 180, 0.1, 0}).patches.size(), 7u);
  EXPECT_EQ(findPatches(facets, {40 * pi / 180, 0.1, 0.02}).patches.size(), 6u);
  EXPECT_NEAR(testing::areaOf(testing::completeMesh(facets, 0.4)), 24, 1e-4);
}

TEST(Patches, OfAClosedSmoothSurfaceAreCutUntilTheyHaveBoundaryEnough) {
  const PatchedFacets tubes = findPatches(thickTorus(), {pi / 4});
  EXPECT_EQ(tubes.patches.size(), 2u);
  for (const Patch& patch : tubes.patches) EXPECT_EQ(patch.loops.size(), 2u);
}

/// The plane that cuts a sphere with a flat top in two goes through the top as well.
TEST(Patches, ThatAreCutKeepTheSurfaceClosed) {
  Facets sphere;
  constexpr std::uint32_t kAround = 40, kUp = 20;
  for (std::uint32_t k = 0; k <= kUp; ++k) {
    const double latitude = -1.5 + 2.5 * k / kUp;  // a crease at the top only
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double longitude = 2 * pi * i / kAround;
      sphere.vertices.push_back({std::cos(latitude) * std::cos(longitude),
                                 std::cos(latitude) * std::sin(longitude), std::sin(latitude)});
    }
  }
  const auto at = [&](std::uint32_t k, std::uint32_t i) { return k * kAround + i % kAround; };
  for (std::uint32_t k = 0; k < kUp; ++k)
    for (std::uint32_t i = 0; i < kAround; ++i) {
      sphere.triangles.push_back({at(k, i), at(k, i + 1), at(k + 1, i + 1)});
      sphere.triangles.push_back({at(k, i), at(k + 1, i + 1), at(k + 1, i)});
    }
  for (std::uint32_t i = 1; i + 1 < kAround; ++i) {
    sphere.triangles.push_back({at(0, 0), at(0, i + 1), at(0, i)});
    sphere.triangles.push_back({at(kUp, 0), at(kUp, i), at(kUp, i + 1)});
  }
  ASSERT_TRUE(HalfEdges(sphere.triangles).boundary().empty());
  const PatchedFacets patched = findPatches(sphere, {25 * pi / 180});
  EXPECT_GT(patched.facets.triangles.size(), sphere.triangles.size());
  EXPECT_TRUE(HalfEdges(patched.facets.triangles).boundary().empty());
  EXPECT_EQ(measureQuality(testing::completeMesh(sphere, 0.2)).freeEdges, 0u);
}

/// An edge that runs to and fro by far less than the elements are long has no corners in between.
TEST(Patches, HaveNoCornersWhereTheirEdgesAreJagged) {
  // A strip whose upper border has teeth of 0.01 amid the middle third.
  std::string text;
  constexpr int kPoints = 90;
  for (int i = 0; i <= kPoints; ++i) {
    const bool isTooth = i > kPoints / 3 && i < 2 * kPoints / 3 && i % 2 == 1;
    text += "v " + std::to_string(i * 0.01) + " 0 0\nv " + std::to_string(i * 0.01) + " " +
            (isTooth ? "0.51" : "0.5") + " 0\n";
  }
  for (int i = 0; i < kPoints; ++i) {
    const auto number = [&](int k) { return " " + std::to_string(2 * i + k); };
    text += "f" + number(1) + number(3) + number(4) + number(2) + "\n";
  }
  const Facets facets = read("jagged.obj", text);
  EXPECT_GT(findPatches(facets, {40 * pi / 180, 0.5, 0}).curves.size(), 25u);
  EXPECT_LT(findPatches(facets, {40 * pi / 180, 0.5, 0.05}).curves.size(), 8u);
}

TEST(FacetedMeshing, MeshesABoxExactly) {
  const ModelMesh result = testing::completeMesh(read("box.obj", kBox), 0.4);
  EXPECT_NEAR(testing::volumeOf(result), 8, 1e-12);
  EXPECT_EQ(testing::eulerNumber(result), 2);
  EXPECT_EQ(result.faces.size(), 6u);
}

TEST(FacetedMeshing, MeshesATorusOnItsTriangles) {
  const ModelMesh result = testing::completeMesh(thickTorus(), 0.4);
  EXPECT_EQ(testing::eulerNumber(result), 0);
  EXPECT_NEAR(testing::volumeOf(result), 2 * pi * pi * 3, 0.06 * 2 * pi * pi * 3);
  for (const Point3& p : result.vertices) {
    const double r = std::hypot(std::hypot(p.x, p.y) - 3, p.z);
    EXPECT_NEAR(r, 1, 0.03) << "so far the triangles lie beside the torus";
  }
}

TEST(FacetedMeshing, PutsElementsAcrossWhatIsNarrow) {
  std::string plate = kBox;
  for (std::size_t i = plate.find(" 2\nv"); i != std::string::npos; i = plate.find(" 2\nv", i + 1))
    plate.replace(i, 2, " 0.2");
  plate.replace(plate.find(" 2\nf"), 2, " 0.2");
  MeshingOptions options;
  options.sizes.size = 0.5;
  const std::size_t before = testing::completeMesh(read("box.obj", plate), options).elements.size();
  options.sizes.elementsAcross = 2;
  EXPECT_GT(testing::completeMesh(read("box.obj", plate), options).elements.size(), 8 * before);
}

TEST(FacetedMeshing, PutsMiddlesOfSidesOnTheTriangles) {
  MeshingOptions options;
  options.sizes.size = 0.5;
  options.order = 2;
  const ModelMesh result = testing::completeMesh(thickTorus(), options);
  ASSERT_EQ(result.midsides.size(), result.elements.size());
  EXPECT_TRUE(result.straightened.empty());
  for (const Point3& p : result.vertices)
    EXPECT_NEAR(std::hypot(std::hypot(p.x, p.y) - 3, p.z), 1, 0.03);
  for (std::size_t e = 0; e < result.elements.size(); ++e) EXPECT_GT(scaledJacobian(result, e), 0);
}

TEST(FacetedMeshing, IsTheSameEachTime) {
  const ModelMesh one = testing::completeMesh(thickTorus(), 0.5),
                  two = testing::completeMesh(thickTorus(), 0.5);
  EXPECT_EQ(one.vertices, two.vertices);
  EXPECT_EQ(one.elements, two.elements);
}

}  // namespace
}  // namespace af2::geometry
