// Files of triangles as people have them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "engine/base/error.h"
#include "geometry/domain/domain_defects.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/faceted/patches.h"
#include "tests/support/model_mesh.h"
#include "tests/support/test_folder.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

const std::string kBoxVertices =
    "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n";
const std::string kBoxFaces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

Facets read(const std::string& text) {
  return readFacets(testing::TestFile("model.obj", text).path());
}

DomainModel modelOf(const Facets& facets, double size) {
  MeshingOptions options;
  options.sizes.size = size;
  return facetedModel(facets, options);
}

ModelMesh mesh(const Facets& facets, const MeshingOptions& options) {
  static const AF2Algorithm algorithm(testing::triangleSet());
  ModelMesh result = meshFaceted(facets, algorithm, options);
  testing::expectComplete(result);
  return result;
}

void expectABox(const Facets& facets) {
  MeshingOptions options;
  options.sizes.size = 0.5;
  const ModelMesh result = mesh(facets, options);
  EXPECT_EQ(result.faces.size(), 6u);
  EXPECT_NEAR(testing::volumeOf(result), 8, 1e-3);
  EXPECT_EQ(testing::eulerNumber(result), 2) << "closed";
}

TEST(FacetFaults, OfASoundFileAreNone) {
  EXPECT_TRUE(read(kBoxVertices + kBoxFaces).notes.empty());
}

TEST(FacetFaults, TrianglesWithoutAreaAreNotSplitAtTheirOwnCorners) {
  const Facets facets = read(kBoxVertices + kBoxFaces + "v 5 0 0\nv 7 0 0\nv 6 0 0\nf 9 10 11\n");
  for (const auto& t : facets.triangles)
    EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) << t[0] << t[1] << t[2];
}

TEST(FacetFaults, VerticesThatNoTriangleUsesDoNotCountHoweverFarAway) {
  const Facets facets = read("v 1e9 0 0\n" + kBoxVertices + "f 2 5 4 3\nf 6 7 8 9\nf 2 3 7 6\n" +
                             "f 3 4 8 7\nf 4 5 9 8\nf 5 2 6 9\n");
  EXPECT_EQ(facets.vertices.size(), 8u);
  EXPECT_TRUE(facets.notes.empty());
  expectABox(facets);
}

TEST(FacetFaults, WhereTheyLeaveNoTriangleAreRefused) {
  try {
    read("v 0 0 0\nv 1 0 0\nv 1 1e-9 0\nf 1 2 3\n");
    FAIL() << "a file without a surface was read";
  } catch (const InputError& error) {
    const std::string told = error.what();
    EXPECT_NE(told.find("no triangle is left"), std::string::npos) << told;
    EXPECT_NE(told.find("edges without length"), std::string::npos) << told;
  }
}

TEST(FacetFaults, ThatLeaveASurfaceWithoutAreaAreRefused) {
  try {
    read("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 4 0 0\nf 1 2 3 4\n");
    FAIL() << "a line was read as a surface";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no area"), std::string::npos) << error.what();
  }
}

std::string refusalOf(Facets facets) {
  try {
    repairedFacets(std::move(facets));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A box of side 2 whose triangles share no vertices, as in an STL file; the lid is a part.
Facets looseBox() {
  const Facets sound = read(kBoxVertices + kBoxFaces);
  Facets facets;
  facets.groupNames = {"walls", "lid"};
  for (const auto& triangle : sound.triangles) {
    const auto first = static_cast<std::uint32_t>(facets.vertices.size());
    facets.triangles.push_back({first, first + 1, first + 2});
    bool isLid = true;
    for (const std::uint32_t corner : triangle) {
      facets.vertices.push_back(sound.vertices[corner]);
      isLid = isLid && sound.vertices[corner].z == 2;
    }
    facets.group.push_back(isLid ? 1 : 0);
  }
  return facets;
}

TEST(FacetFaults, OfTrianglesInMemoryAreRepairedToo) {
  Facets loose = looseBox();
  loose.triangles.push_back({loose.triangles[0][0], loose.triangles[0][2], loose.triangles[0][1]});
  loose.triangles.push_back({5, 5, 7});
  loose.group.insert(loose.group.end(), 2, 0);
  const Facets facets = repairedFacets(loose);
  EXPECT_EQ(facets.vertices.size(), 8u);
  EXPECT_EQ(facets.triangles.size(), 12u);
  EXPECT_EQ(facets.notes.size(), 1u);
  expectABox(facets);
  MeshingOptions options;
  options.sizes.size = 0.5;
  const ModelMesh result = mesh(facets, options);
  ASSERT_EQ(result.groups.size(), 2u);
  EXPECT_EQ(result.groups[1].name, "lid");
  EXPECT_EQ(result.groups[1].faces.size(), 1u);
}

TEST(FacetFaults, OfTrianglesInMemoryThatCannotBeRepairedAreToldWithTheirPlace) {
  Facets facets = looseBox();
  facets.triangles[2][1] = 99;
  EXPECT_EQ(refusalOf(facets),
            "the facets: triangle 2 has vertex 99, but there are only 36, counted from 0");
  facets = looseBox();
  facets.vertices[3].y = std::nan("");
  EXPECT_EQ(refusalOf(facets), "the facets: vertex 3 has a coordinate that is not a number");
  facets = looseBox();
  facets.group.pop_back();
  EXPECT_EQ(refusalOf(facets), "the facets: there are parts for 11 triangles, but 12 triangles");
  facets = looseBox();
  facets.groupNames.pop_back();
  EXPECT_NE(refusalOf(facets).find("is in part 1, but there are names of only 1 parts"),
            std::string::npos);
  EXPECT_EQ(refusalOf({}), "the facets: contains no triangle");
}

TEST(FacetFaults, LikeTrianglesThatAreThereTwiceAreLeftOut) {
  const Facets facets = read(kBoxVertices + kBoxFaces + "f 5 6 7\nf 3 4 1\n");
  EXPECT_EQ(facets.triangles.size(), 12u);
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_NE(facets.notes[0].find("2 triangles had the same corners"), std::string::npos);
  expectABox(facets);
}

TEST(FacetFaults, LikeFlapsWithoutAreaAreLeftOut) {
  // From both sides: between the middle of an edge of the lid and its ends.
  const std::string lid = "v 1 0 2\nf 5 9 8\nf 9 7 8\nf 9 6 7\n";
  const std::string others =
      "f 1 4 3 2\nf 1 2 6\nf 1 6 9\nf 1 9 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const Facets facets = read(kBoxVertices + lid + others + "f 5 9 6\nf 6 9 5\n");
  EXPECT_EQ(facets.triangles.size(), 14u);
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_NE(facets.notes[0].find("2 triangles had the same corners"), std::string::npos);
  expectABox(facets);
}

TEST(FacetFaults, LikeFlapsWithAreaAreKept) {
  const Facets facets = read(kBoxVertices + kBoxFaces + "v 1 0 3\nf 5 9 6\nf 6 9 5\n");
  EXPECT_EQ(facets.triangles.size(), 13u);  // once, as a fin
}

TEST(FacetFaults, LikeEdgesWithoutLengthAreCollapsed) {
  // The middle of the lid is two vertices, with two needles between them.
  const Facets facets = read(kBoxVertices +
                             "v 1 1 2\nv 1 1.0000001 2\n"
                             "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
                             "f 5 6 9\nf 6 10 9\nf 6 7 10\nf 7 8 10\nf 8 9 10\nf 8 5 9\n");
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_NE(facets.notes[0].find("1 edges without length"), std::string::npos);
  EXPECT_EQ(facets.triangles.size(), 14u);
  expectABox(facets);
}

TEST(FacetFaults, LikeTurnedTrianglesAreTurnedBack) {
  std::string faces = kBoxFaces;
  faces.replace(faces.find("f 5 6 7 8"), 9, "f 8 7 6 5");
  const Facets facets = read(kBoxVertices + faces);
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_NE(facets.notes[0].find("2 triangles were reversed"), std::string::npos);
  expectABox(facets);
}

TEST(FacetFaults, LikeCracksAreJoined) {
  // The lid has corners of its own, a little beside those of the walls.
  const Facets facets =
      read(kBoxVertices + "v 0 1e-6 2\nv 2 0 2.000001\nv 2 2 2\nv 1e-6 2 2\n" +
           "f 1 4 3 2\nf 9 10 11 12\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_NE(facets.notes[0].find("3 vertices at gaps"), std::string::npos);
  expectABox(facets);
}

TEST(FacetFaults, LikeVerticesOnlyOneSideOfAnEdgeHasAreGivenToBoth) {
  const Facets facets = read(kBoxVertices + "v 0.5 0 0\nv 1.5 0 0\n" +
                             "f 1 4 9\nf 9 4 10\nf 10 4 3\nf 10 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 "
                             "6\nf 3 4 8 7\nf 4 1 5 8\n");
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_NE(facets.notes[0].find("1 triangles were split"), std::string::npos) << facets.notes[0];
  expectABox(facets);
}

TEST(FacetFaults, LikeHolesAreTold) {
  std::string open = kBoxFaces;
  open.erase(open.find("f 5 6 7 8\n"), 10);
  const Facets facets = read(kBoxVertices + open);
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_EQ(facets.notes[0].find("4 edges have only one triangle"), 0u);
  const std::vector<Defect> defects = findDefects(modelOf(facets, 0.5), 0.5);
  ASSERT_EQ(defects.size(), 4u);
  for (const Defect& defect : defects) {
    EXPECT_EQ(defect.kind, DefectKind::FreeEdge);
    EXPECT_EQ(defect.place.z, 2);
  }
  const std::vector<Defect> tiny = findDefects(modelOf(read(kBoxVertices + kBoxFaces), 50), 50);
  EXPECT_EQ(std::ranges::count(tiny, DefectKind::TinyEdge, &Defect::kind), 12);
}

TEST(FacetFaults, LikeASurfaceThatLooksInwardsAreTold) {
  MeshingOptions options;
  options.sizes.size = 0.5;
  EXPECT_TRUE(mesh(read(kBoxVertices + kBoxFaces), options).notes.empty());
  Facets facets = read(kBoxVertices + kBoxFaces);
  for (auto& triangle : facets.triangles) std::swap(triangle[1], triangle[2]);
  const ModelMesh inwards = mesh(facets, options);
  EXPECT_LT(testing::volumeOf(inwards), 0);
  ASSERT_EQ(inwards.notes.size(), 1u);
  EXPECT_NE(inwards.notes[0].find("faces inwards"), std::string::npos);
}

TEST(FacetFaults, LikeAWallThatTwoBoxesHaveTwiceMakeOneFace) {
  const Facets facets =
      read(kBoxVertices + "v 4 0 0\nv 4 2 0\nv 4 0 2\nv 4 2 2\n" + kBoxFaces +
           "f 2 3 10 9\nf 6 11 12 7\nf 2 9 11 6\nf 9 10 12 11\nf 10 3 7 12\nf 7 3 2 6\n");
  MeshingOptions options;
  options.sizes.size = 0.5;
  const ModelMesh result = mesh(facets, options);
  EXPECT_EQ(result.faces.size(), 11u);
}

/// A box by two corners, as lines of an OBJ file; `before` vertices came before.
std::string boxAt(const Point3& low, const Point3& high, int before) {
  std::ostringstream text;
  for (const double z : {low.z, high.z})
    for (const auto& [x, y] : {std::pair(low.x, low.y), std::pair(high.x, low.y),
                               std::pair(high.x, high.y), std::pair(low.x, high.y)})
      text << "v " << x << ' ' << y << ' ' << z << '\n';
  for (const auto& face : {std::array{1, 4, 3, 2},
                           {5, 6, 7, 8},
                           {1, 2, 6, 5},
                           {2, 3, 7, 6},
                           {3, 4, 8, 7},
                           {4, 1, 5, 8}}) {
    text << 'f';
    for (const int v : face) text << ' ' << v + before;
    text << '\n';
  }
  return text.str();
}

/// Volume and number of pieces must be those of two boxes that are apart.
void expectTwoBoxes(const std::string& other, double volume) {
  const Facets facets = read(boxAt({0, 0, 0}, {2, 2, 2}, 0) + other);
  ASSERT_EQ(facets.notes.size(), 1u);
  EXPECT_NE(facets.notes[0].find("2 parts that touch"), std::string::npos) << facets.notes[0];
  MeshingOptions options;
  options.sizes.size = 0.5;
  const ModelMesh result = mesh(facets, options);
  EXPECT_EQ(result.faces.size(), 12u);
  EXPECT_NEAR(testing::volumeOf(result), volume, 1e-9);
  EXPECT_EQ(testing::eulerNumber(result), 4) << "two closed surfaces";
}

TEST(FacetParts, ThatTouchAtAnEdgeAreTakenApart) {
  expectTwoBoxes(boxAt({2, 2, 0}, {4, 4, 2}, 8), 16);
}

TEST(FacetParts, ThatTouchAtAVertexAreTakenApart) {
  expectTwoBoxes(boxAt({2, 2, 2}, {4, 4, 4}, 8), 16);
}

TEST(FacetParts, WithPartOfAWallInCommonAreTakenApart) {
  expectTwoBoxes(boxAt({2, 0, 0}, {3, 2, 1}, 8), 10);
}

/// As CAD systems write a part that an assembly holds several times in the same place.
TEST(FacetParts, InTheSamePlaceAreTakenApart) {
  std::string text = kBoxVertices;
  for (int copy = 0; copy < 3; ++copy) text += kBoxFaces;
  const Facets facets = read(text);
  EXPECT_EQ(facets.triangles.size(), 36u);
  MeshingOptions options;
  options.sizes.size = 0.5;
  const ModelMesh result = mesh(facets, options);
  EXPECT_EQ(result.faces.size(), 18u);
  EXPECT_EQ(testing::eulerNumber(result), 6) << "three closed surfaces";
}

TEST(FacetParts, ThatAreOpenStayWithWhatTheyTouch) {
  // A sheet that goes on from the edge of a box.
  const Facets facets = read(kBoxVertices + "v 4 0 0\nv 4 2 0\n" + kBoxFaces + "f 2 3 10 9\n");
  EXPECT_EQ(facets.vertices.size(), 10u);
}

TEST(FacetParts, AreGroupsWithSizesOfTheirOwn) {
  const Facets facets = read(kBoxVertices + "g bottom\nf 1 4 3 2\ng top lid\nf 5 6 7 8\ng walls\n" +
                             "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  MeshingOptions options;
  options.sizes.size = 1;
  options.sizes.partSizes = {{"top*", 0.1}};
  const ModelMesh result = mesh(facets, options);
  ASSERT_EQ(result.groups.size(), 3u);
  EXPECT_EQ(result.groups[1], (FaceGroup{"top lid", GroupKind::Part, {2}}));
  EXPECT_EQ(result.groups[2].faces.size(), 4u);
  EXPECT_GT(result.faces[1].elements, 700u);
  EXPECT_LT(result.faces[0].elements, 60u);
  options.sizes.partSizes = {{"none", 0.1}};
  EXPECT_THROW(mesh(facets, options), InputError);
}

TEST(FacetParts, AreApartWhereTheSurfaceDoesNotTurn) {
  const Facets sheet = read(
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\ng a\nf 1 2 5 4\ng b\nf 2 3 6 5\n");
  const PatchedFacets patched = findPatches(sheet, {pi / 4});
  EXPECT_EQ(patched.patches.size(), 2u);
}

TEST(FacetedMeshing, KeepsADivisionThatIsGiven) {
  const Facets facets = read(kBoxVertices + kBoxFaces);
  MeshingOptions options;
  options.sizes.size = 1;
  const DomainModel model = modelOf(facets, 1);
  const DomainCurve& edge = model.curves[2];
  const double end = edge.knots.back();
  const std::vector<Point3> given{edge.pointAt(0.9 * end), edge.pointAt(0.3 * end)};
  options.edgePoints[edge.id] = given;
  const ModelMesh result = mesh(facets, options);
  for (const Point3& p : given) EXPECT_EQ(std::ranges::count(result.vertices, p), 1);
  EXPECT_EQ(std::ranges::count(result.segments, edge.id, &EdgeSegment::edge), 3);
  options.edgePoints[edge.id].push_back({5, 5, 5});
  EXPECT_THROW(mesh(facets, options), InputError);
  options.edgePoints = {{99, {}}};
  EXPECT_THROW(mesh(facets, options), InputError);
}

TEST(FacetedMeshing, GivesFacesAndEdgesSizesOfTheirOwn) {
  const Facets facets = read(kBoxVertices + kBoxFaces);
  MeshingOptions options;
  options.sizes.size = 1;
  options.sizes.faceSizes[3] = 0.2;
  options.sizes.edgeSizes[1] = 0.05;
  const ModelMesh result = mesh(facets, options);
  EXPECT_EQ(std::ranges::count(result.segments, 1, &EdgeSegment::edge), 40);
  EXPECT_GT(result.faces[2].elements, 150u);
  options.faces = {3};
  EXPECT_EQ(mesh(facets, options).faces.size(), 1u);
  options.faces = {7};
  EXPECT_THROW(mesh(facets, options), InputError);
}

TEST(Patches, DoNotKeepCreasesThatEndAmidASmoothSurface) {
  // A plate with a small step in its middle: two edges that turn by 60 degrees and end nowhere.
  std::string text;
  constexpr int kCells = 10;
  for (int i = 0; i <= kCells; ++i)
    for (int k = 0; k <= kCells; ++k)
      text +=
          "v " + std::to_string(i) + " " + std::to_string(k) + (i == 5 && k == 5 ? " 1\n" : " 0\n");
  const auto at = [](int i, int k) { return std::to_string(i * (kCells + 1) + k + 1); };
  for (int i = 0; i < kCells; ++i)
    for (int k = 0; k < kCells; ++k)
      text +=
          "f " + at(i, k) + " " + at(i + 1, k) + " " + at(i + 1, k + 1) + " " + at(i, k + 1) + "\n";
  const Facets facets = read(text);
  const auto loops = [&](double looseEnd) {
    return findPatches(facets, {pi / 4, looseEnd}).patches.at(0).loops.size();
  };
  EXPECT_GT(loops(0), 1u);
  EXPECT_EQ(loops(5), 1u);
}

}  // namespace
}  // namespace af2::geometry
