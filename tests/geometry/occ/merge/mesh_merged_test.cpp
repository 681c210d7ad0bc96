// Meshes that cross edges which only the CAD has.
#include "geometry/occ/merge/mesh_merged.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>
#include <numbers>
#include <vector>

#include "engine/base/error.h"
#include "geometry/mesh/fingerprint.h"
#include "geometry/mesh/quality.h"
#include "geometry/occ/inspect/measures.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

ModelMesh merged(const Model& model, const MeshingOptions& options,
                 const MergeRequest& request = {}) {
  static const AF2Algorithm algorithm(testing::triangleSet());
  ModelMesh mesh = meshMerged(model, algorithm, options, request);
  testing::expectComplete(mesh);
  EXPECT_TRUE(mesh.findings.empty());
  EXPECT_TRUE(mesh.merging.has_value());
  return mesh;
}

ModelMesh merged(const Model& model, double size, const MergeRequest& request = {}) {
  return merged(model, testing::ofSize(size), request);
}

/// Boxes side by side along x, of equal breadth, made one solid: faces and edges between them stay.
Model boxes(const std::vector<double>& ends, const std::vector<double>& heights) {
  TopoDS_Shape shape;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const TopoDS_Shape box =
        BRepPrimAPI_MakeBox(gp_Pnt(ends[i], 0, 0), gp_Pnt(ends[i + 1], 6, heights[i])).Shape();
    shape = i == 0 ? box : TopoDS_Shape(BRepAlgoAPI_Fuse(shape, box).Shape());
  }
  return testing::modelOf(shape);
}

Model roundedBox(double radius) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 8, 6).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next())
    fillet.Add(radius, TopoDS::Edge(it.Current()));
  return testing::modelOf(fillet.Shape());
}

double shortestEdge(const ModelMesh& mesh) {
  double shortest = 1e300;
  for (const Element& element : mesh.elements) {
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < corners.size(); ++i)
      shortest =
          std::min(shortest, distance(mesh.vertices[corners[i].value],
                                      mesh.vertices[corners[(i + 1) % corners.size()].value]));
  }
  return shortest;
}

double farthestVertex(const Model& model, const ModelMesh& mesh) {
  double farthest = 0;
  for (const Point3& p : mesh.vertices) {
    const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x, p.y, p.z));
    farthest = std::max(farthest, BRepExtrema_DistShapeShape(vertex, model.shape().shape).Value());
  }
  return farthest;
}

std::size_t mergedFaces(const ModelMesh& mesh) {
  std::size_t faces = 0;
  for (const MergedGroup& group : mesh.merging->groups) faces += group.faces.size();
  return faces;
}

/// Each face has about as much area in the mesh as in the model.
void expectAreas(const Model& model, const ModelMesh& mesh, double share) {
  for (const auto& face : measuresOfFaces(model))
    EXPECT_NEAR(testing::areaOf(mesh, face->id), face->area, share * face->area)
        << "face " << face->id;
}

TEST(MeshMerged, CrossesEdgesWithinPlanes) {
  const Model model = boxes({0, 5, 10}, {2, 2});
  const ModelMesh mesh = merged(model, 1);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  ASSERT_EQ(mesh.merging->groups.size(), 4u);
  EXPECT_EQ(mesh.merging->vertices.size(), 4u);
  for (const MergedGroup& group : mesh.merging->groups) {
    EXPECT_EQ(group.faces.size(), 2u);
    EXPECT_EQ(group.smoothEdges.size(), 1u);
    EXPECT_LT(group.deviation, 1e-9);
  }
  EXPECT_NEAR(testing::volumeOf(mesh), 120, 1e-9);
}

TEST(MeshMerged, TakesNoMeshOfCongruentFacesOverWithinAPlane) {
  const ModelMesh mesh = merged(boxes({0, 3, 6, 9}, {3, 3, 3}), 0.9);
  std::vector<int> together;
  for (const MergedGroup& group : mesh.merging->groups)
    together.insert(together.end(), group.faces.begin(), group.faces.end());
  EXPECT_GE(together.size(), 12u);
  for (const FaceReport& face : mesh.faces)
    if (std::ranges::find(together, face.id) != together.end()) {
      EXPECT_EQ(face.congruentTo, 0) << face.id;
    }
  EXPECT_NEAR(testing::areaOf(mesh), 2 * (9 * 6 + 9 * 3 + 6 * 3), 1e-9);
  EXPECT_NEAR(testing::volumeOf(mesh), 9 * 6 * 3, 1e-9);
}

TEST(MeshMerged, LeavesOutSliversAndTinyEdges) {
  const Model model = boxes({0, 5, 5.01, 10}, {2, 2, 2});
  const ModelMesh plain = testing::mesh(model, 1);
  const ModelMesh mesh = merged(model, 1);
  EXPECT_LT(shortestEdge(plain), 0.02);
  EXPECT_GT(shortestEdge(mesh), 0.4);
  EXPECT_GT(measureQuality(mesh).minAngle, 30);
  EXPECT_LT(mesh.elements.size(), plain.elements.size());
}

TEST(MeshMerged, LeavesOutStepsBelowTheSize) {
  const Model model = boxes({0, 5, 10}, {2, 2.03});
  const ModelMesh mesh = merged(model, 1);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  EXPECT_GT(shortestEdge(mesh), 0.3);
  EXPECT_GT(measureQuality(mesh).minAngle, 20);
  const auto narrow = std::ranges::find_if(
      mesh.merging->groups, [](const MergedGroup& group) { return !group.narrowEdges.empty(); });
  ASSERT_NE(narrow, mesh.merging->groups.end());
  EXPECT_LT(narrow->deviation, 0.1);
  EXPECT_NEAR(testing::volumeOf(mesh), 120.9, 1);
}

TEST(MeshMerged, KeepsStepsIfNarrowFacesCount) {
  const Model model = boxes({0, 5, 10}, {2, 2.03});
  MergeRequest request;
  request.narrow = 0;
  EXPECT_LT(shortestEdge(merged(model, 1, request)), 0.05);
}

TEST(MeshMerged, KeepsSharpEdges) {
  const Model model = boxes({0, 5, 10}, {2, 2});
  const ModelMesh mesh = merged(model, 1);
  for (const Point3 corner : {Point3{0, 0, 0}, Point3{10, 6, 2}, Point3{10, 0, 2}})
    EXPECT_TRUE(std::ranges::any_of(mesh.vertices,
                                    [&](const Point3& p) { return distance(p, corner) < 1e-9; }));
  double length = 0;
  for (const EdgeSegment& segment : mesh.segments)
    length += distance(mesh.vertices[segment.from.value], mesh.vertices[segment.to.value]);
  EXPECT_NEAR(length, 4 * (10 + 6 + 2), 1e-9);
}

TEST(MeshMerged, FollowsRoundings) {
  const Model model = roundedBox(1.5);
  const ModelMesh mesh = merged(model, 1);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  EXPECT_GT(mergedFaces(mesh), 20u);
  EXPECT_GT(measureQuality(mesh).minAngle, 20);
  EXPECT_LT(farthestVertex(model, mesh), 1e-6);
  expectAreas(model, mesh, 0.35);
  for (const MergedGroup& group : mesh.merging->groups) EXPECT_LT(group.deviation, 0.25);
}

TEST(MeshMerged, KeepsEdgesAlongTightRoundings) {
  const Model model = roundedBox(0.3);
  const ModelMesh mesh = merged(model, 1);
  for (const MergedGroup& group : mesh.merging->groups)
    EXPECT_TRUE(std::ranges::none_of(group.faces,
                                     [&](int face) { return model.surfaceType(face) == "plane"; }));
}

TEST(MeshMerged, MeshesClosedSurfacesThatMeetSmoothlyEverywhere) {
  const double turn = 2 * std::numbers::pi;
  TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(3, turn / 2).Shape(), torus;
  gp_Trsf around;
  around.SetRotation(gp::OZ(), turn / 2);
  sphere = BRepAlgoAPI_Fuse(sphere, sphere.Moved(around)).Shape();
  for (int i = 0; i < 4; ++i) {
    around.SetRotation(gp::OZ(), i * turn / 4);
    const TopoDS_Shape quarter = BRepPrimAPI_MakeTorus(5, 2, turn / 4).Shape().Moved(around);
    torus = i == 0 ? quarter : TopoDS_Shape(BRepAlgoAPI_Fuse(torus, quarter).Shape());
  }
  for (const TopoDS_Shape& shape : {sphere, torus}) {
    const Model model = testing::modelOf(shape);
    const ModelMesh mesh = merged(model, 1);
    EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
    EXPECT_LT(farthestVertex(model, mesh), 1e-6);
  }
}

TEST(MeshMerged, MergesHalvesOfCylinders) {
  const TopoDS_Shape half = BRepPrimAPI_MakeCylinder(2, 6, std::numbers::pi).Shape();
  gp_Trsf around;
  around.SetRotation(gp::OZ(), std::numbers::pi);
  const Model model = testing::modelOf(BRepAlgoAPI_Fuse(half, half.Moved(around)).Shape());
  const ModelMesh mesh = merged(model, 0.8);
  EXPECT_EQ(mesh.merging->groups.size(), 3u);  // the side and both ends
  // Of the two at each rim one stays; the axis has one at each end.
  EXPECT_EQ(mesh.merging->vertices.size(), 4u);
  EXPECT_EQ(mesh.merging->chains.size(), 2u);
  EXPECT_LT(farthestVertex(model, mesh), 1e-6);
  expectAreas(model, mesh, 0.1);
}

TEST(MeshMerged, KeepsWhatTheUserNames) {
  const Model model = boxes({0, 5, 10}, {2, 2});
  const int inner = merged(model, 1).merging->groups.front().smoothEdges.front();
  MergeRequest request;
  request.keptEdges = {inner};
  const ModelMesh mesh = merged(model, 1, request);
  EXPECT_EQ(mesh.merging->groups.size(), 3u);
  EXPECT_GT(std::ranges::count(mesh.segments, inner, &EdgeSegment::edge), 1);

  MeshingOptions sized = testing::ofSize(1);
  sized.sizes.edgeSizes[inner] = 0.5;
  EXPECT_EQ(merged(model, sized).merging->groups.size(), 3u);
  MeshingOptions parts = testing::ofSize(1);
  parts.sizes.faceSizes[1] = 0.5;
  EXPECT_LE(merged(model, parts).merging->groups.size(), 4u);
}

TEST(MeshMerged, MeshesOnlyTheFacesThatAreAskedFor) {
  const Model model = boxes({0, 5, 10}, {2, 2});
  const std::vector<int> pair = merged(model, 1).merging->groups.front().faces;
  MeshingOptions options = testing::ofSize(1);
  options.faces = {pair.front()};
  const ModelMesh mesh = merged(model, options);
  EXPECT_EQ(mesh.faces.size(), 1u);
  EXPECT_TRUE(mesh.merging->groups.empty());
}

TEST(MeshMerged, GivesTheSameMeshForAnyNumberOfThreads) {
  const Model model = roundedBox(1.5);
  MeshingOptions many = testing::ofSize(0.8);
  many.threads = 4;
  EXPECT_EQ(fingerprint(merged(model, 0.8)), fingerprint(merged(model, many)));
}

TEST(MeshMerged, MakesLoopsEven) {
  MeshingOptions options = testing::ofSize(1);
  options.evenLoops = true;
  const ModelMesh mesh = merged(boxes({0, 3.3, 3.31, 10}, {2, 2, 2}), options);
  for (const FaceReport& face : mesh.faces)
    EXPECT_TRUE(face.oddLoops.empty()) << "face " << face.id;
}

TEST(MeshMerged, PutsMiddlesOfSidesOnTheFaces) {
  const Model model = roundedBox(2);
  MeshingOptions options = testing::ofSize(1.2);
  options.order = 2;
  const ModelMesh mesh = merged(model, options);
  EXPECT_EQ(mesh.midsides.size(), mesh.elements.size());
  EXPECT_LT(farthestVertex(model, mesh), 0.02);
}

TEST(MeshMerged, KeepsABoundOnTheDistance) {
  MeshingOptions options = testing::ofSize(1.5);
  options.sizes.chords.everywhere.value = 0.02;
  const ModelMesh mesh = merged(roundedBox(2), options);
  ASSERT_TRUE(mesh.deviation.has_value());
  EXPECT_LE(mesh.deviation->largest, 0.02);
}

/// Sizes of curved faces are known on the plane ones beside them, as at edges.
TEST(MeshMerged, KeepsABoundWithoutManyMoreElementsThanThePlainMesh) {
  const Model model = roundedBox(2);
  MeshingOptions options = testing::ofSize(1.5);
  for (const double bound : {0.02, 0.01, 0.005}) {
    SCOPED_TRACE(bound);
    options.sizes.chords.everywhere.value = bound;
    const ModelMesh plain = testing::mesh(model, options), mesh = merged(model, options);
    ASSERT_GT(mesh.merging->groups.size(), 0u);
    ASSERT_TRUE(mesh.deviation.has_value());
    EXPECT_LE(mesh.deviation->largest, bound);
    EXPECT_LT(mesh.elements.size(), 1.6 * plain.elements.size());
  }
}

// They stand in faces of their own; the other three pairs of faces are merged as ever.
TEST(MeshMerged, KeepsTheEdgesOfFacesWithLayers) {
  const Model model = boxes({0, 5, 10}, {2, 2});
  const ModelMesh plain = merged(model, 1);
  ASSERT_EQ(plain.merging->groups.size(), 4u);
  const int face = plain.merging->groups.front().faces.front();
  MeshingOptions options = testing::ofSize(1);
  options.layers = {{.faces = {face}, .first = 0.1, .count = 3}};
  const ModelMesh mesh = merged(model, options);
  EXPECT_EQ(mesh.merging->groups.size(), 3u);
  std::size_t quads = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    quads += mesh.elements[e].isQuad();
    EXPECT_TRUE(!mesh.elements[e].isQuad() || mesh.face[e] == face);
  }
  EXPECT_GE(quads, 30u);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  EXPECT_NEAR(testing::volumeOf(mesh), 120, 1e-9);
}

TEST(MeshMerged, SaysBeforehandWhatItMerges) {
  const Model model = boxes({0, 5, 5.01, 10}, {2, 2, 2});
  Merging planned = mergingOf(model, testing::ofSize(1), {});
  Merging done = *merged(model, 1).merging;
  for (MergedGroup& group : done.groups) group.deviation = 0;
  EXPECT_EQ(planned, done);
}

TEST(MeshMerged, RefusesWhatMakesNoSense) {
  const Model model = testing::box(1, 2, 3);
  const auto refuses = [&](const MergeRequest& request, MeshingOptions options) {
    EXPECT_THROW(mergingOf(model, options, request), InputError);
  };
  const MeshingOptions usual = testing::ofSize(1);
  refuses({.angle = 0}, usual);
  refuses({.angle = 90}, usual);
  refuses({.narrow = -0.1}, usual);
  refuses({.narrow = 0.7}, usual);
  refuses({.keptEdges = {13}}, usual);
  refuses({.keptAround = {"inlet"}}, usual);
  MeshingOptions fewest = usual;
  fewest.fewest = true;
  refuses({}, fewest);
}

}  // namespace
}  // namespace af2::geometry
