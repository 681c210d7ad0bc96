#include "geometry/occ/run/mesh_model.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pln.hxx>

#include <algorithm>

#include <numbers>
#include <ranges>
#include <set>

#include "engine/base/error.h"
#include "geometry/mesh/fingerprint.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

using testing::eulerNumber;
using testing::expectComplete;
using testing::mesh;
using testing::volumeOf;

ModelMesh meshOfFaces(const Model& model, double size, const std::vector<int>& faces) {
  MeshingOptions options = testing::ofSize(size);
  options.faces = faces;
  return mesh(model, options);
}

/// Closed, oriented outwards, of the right volume up to what chords cut off.
void expectSolid(const ModelMesh& mesh, double volume, int euler, double tolerance) {
  expectComplete(mesh);
  EXPECT_EQ(eulerNumber(mesh), euler);
  EXPECT_NEAR(volumeOf(mesh), volume, tolerance * volume);
}

TEST(ModelMeshing, MeshesABoxExactly) {
  expectSolid(mesh(testing::box(1, 2, 3), 0.3), 6, 2, 1e-12);
}

TEST(ModelMeshing, MeshesACylinderAcrossItsSeam) {
  expectSolid(mesh(testing::cylinder(1, 3), 0.2), 3 * pi, 2, 0.01);
}

TEST(ModelMeshing, MeshesASphereOverItsPoles) {
  const ModelMesh result = mesh(testing::sphere(1), 0.2);
  expectSolid(result, 4 * pi / 3, 2, 0.02);
  for (const Point3& p : result.vertices) EXPECT_NEAR(length(p), 1, 1e-12);
}

TEST(ModelMeshing, MeshesALargeSphereInPieces) {
  MeshingOptions options;
  options.sizes.size = 0.018;  // enough elements for a cut
  options.threads = 1;
  const Model sphere = testing::sphere(1);
  const ModelMesh result = mesh(sphere, options);
  expectComplete(result);
  EXPECT_EQ(2 * result.vertices.size(),
            result.elements.size() + 4);  // that of Euler, all triangles
  // Pieces come one after the other: the first eighth of the elements lies on one side.
  const std::size_t few = result.elements.size() / 8;
  const auto [south, north] = std::ranges::minmax(
      std::views::iota(std::size_t{0}, few) | std::views::transform([&](std::size_t e) {
        return result.vertices[result.elements[e].corners[0].value].z;
      }));
  EXPECT_TRUE(south > -0.5 || north < 0.5) << south << " to " << north;
  options.threads = 2;
  EXPECT_EQ(fingerprint(mesh(sphere, options)), fingerprint(result));
}

TEST(ModelMeshing, MeshesATorus) {
  const ModelMesh result = mesh(testing::torus(3, 1), 0.3);
  expectSolid(result, 2 * pi * pi * 3, 0, 0.02);
  for (const Point3& p : result.vertices) {
    const double r = std::sqrt(p.x * p.x + p.y * p.y) - 3;
    EXPECT_NEAR(std::sqrt(r * r + p.z * p.z), 1, 1e-12);
  }
}

TEST(ModelMeshing, MeshesFacesWithoutAnyBoundary) {
  const gp_Ax3 frame;
  for (const Handle(Geom_Surface) & surface :
       {Handle(Geom_Surface)(new Geom_SphericalSurface(frame, 1)),
        Handle(Geom_Surface)(new Geom_ToroidalSurface(frame, 3, 1))}) {
    TopoDS_Face face;
    BRep_Builder().MakeFace(face, surface, 1e-7);
    const Model model = testing::modelOf(face);
    EXPECT_EQ(model.notes().size(), 1u);
    expectComplete(mesh(model, 0.3));
  }
}

TEST(ModelMeshing, RefusesASizeThatAsksForMoreElementsThanCanBeNumbered) {
  EXPECT_THROW(mesh(testing::box(1, 1, 1), 1e-5), InputError);
}

TEST(ModelMeshing, MeshesAConeWithItsTip) {
  expectSolid(mesh(testing::cone(1, 0, 2), 0.2), 2 * pi / 3, 2, 0.02);
}

TEST(ModelMeshing, MeshesACutOffCone) {
  expectSolid(mesh(testing::cone(1, 2, 2), 0.3), 2 * pi * 7 / 3, 2, 0.02);
}

TEST(ModelMeshing, MeshesABoxWithARoundHole) {
  const TopoDS_Shape cut = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, 0), 4, 4, 1).Shape(),
                                           BRepPrimAPI_MakeCylinder(0.5, 1).Shape());
  expectSolid(mesh(testing::modelOf(cut), 0.25), 16 - pi / 4, 0, 0.01);
}

TEST(ModelMeshing, StaysSoundAtSizesFarTooLarge) {
  expectComplete(mesh(testing::box(1, 2, 3), 100));
  expectComplete(mesh(testing::cylinder(1, 3), 100));
  expectComplete(mesh(testing::sphere(1), 100));
  expectComplete(mesh(testing::torus(3, 1), 100));
}

TEST(ModelMeshing, TurnsInsideOutWithTheModel) {
  const Model inside = testing::modelOf(BRepPrimAPI_MakeSphere(1).Shape().Reversed());
  const ModelMesh result = mesh(inside, 0.3);
  expectComplete(result);
  EXPECT_LT(volumeOf(result), -3);
}

TEST(ModelMeshing, MeshesOnlyTheFacesAskedFor) {
  const Model model = testing::box(1, 2, 3);
  const ModelMesh result = meshOfFaces(model, 0.3, {5, 2});
  expectComplete(result);
  ASSERT_EQ(result.faces.size(), 2u);
  EXPECT_EQ(result.faces[0].id, 2);
  EXPECT_EQ(result.faces[1].id, 5);
  EXPECT_THROW(meshOfFaces(model, 0.3, {7}), InputError);
}

TEST(ModelMeshing, DividesEdgesAlikeForOneFaceAndForAll) {
  const Model model = testing::cylinder(1, 2);
  std::set<std::tuple<double, double, double>> all;
  for (const Point3& p : mesh(model, 0.3).vertices) all.insert({p.x, p.y, p.z});
  const ModelMesh one = meshOfFaces(model, 0.3, {2});
  for (const EdgeSegment& segment : one.segments) {
    const Point3& p = one.vertices[segment.from.value];
    EXPECT_TRUE(all.contains({p.x, p.y, p.z}));
  }
}

TEST(ModelMeshing, DoesNotDependOnTheNumberOfThreads) {
  const Model model = testing::cone(1, 2, 2);
  MeshingOptions options;
  options.sizes.size = 0.2;
  options.threads = 1;
  const ModelMesh one = mesh(model, options);
  options.threads = 4;
  const ModelMesh four = mesh(model, options);
  EXPECT_EQ(one.vertices, four.vertices);
  EXPECT_EQ(one.elements, four.elements);
  EXPECT_EQ(one.face, four.face);
  EXPECT_EQ(one.origins, four.origins);
  EXPECT_EQ(one.segments, four.segments);
}

TEST(ModelMeshing, TakesSizesByFace) {
  MeshingOptions options;
  options.sizes.size = 1;
  options.sizes.faceSizes[3] = 0.1;
  const ModelMesh result = mesh(testing::box(1, 1, 1), options);
  expectComplete(result);
  EXPECT_GT(result.faces[2].elements, 200u);
  options.sizes.faceSizes[9] = 0.1;
  EXPECT_THROW(mesh(testing::box(1, 1, 1), options), InputError);
}

TEST(ModelMeshing, TakesSizesFromAFunction) {
  MeshingOptions options;
  options.sizes.size = 1;
  options.sizes.function = [](const Point3& p) { return 0.05 + 0.2 * p.z; };
  const ModelMesh result = mesh(testing::box(1, 1, 2), options);
  expectComplete(result);
  double low = 0, high = 0;
  for (const Point3& p : result.vertices) (p.z < 1 ? low : high) += 1;
  EXPECT_GT(low, 4 * high);
  options.sizes.function = [](const Point3&) { return 0.0; };
  EXPECT_THROW(mesh(testing::box(1, 1, 2), options), InputError);
}

TEST(ModelMeshing, NumbersVerticesOfTheModelThenOfEdgesThenOfFaces) {
  const ModelMesh result = mesh(testing::box(1, 1, 1), 0.25);
  for (std::size_t i = 0; i < 8; ++i) {
    const Point3& p = result.vertices[i];
    for (const double x : {p.x, p.y, p.z}) EXPECT_TRUE(x == 0 || x == 1);
  }
  std::uint32_t last = 0;
  for (const EdgeSegment& segment : result.segments) last = std::max(last, segment.to.value);
  EXPECT_EQ(last, 8u + 12 * 3 - 1);
}

TEST(ModelMeshing, TellsItsProgress) {
  MeshingOptions options;
  options.sizes.size = 0.1;
  options.threads = 2;
  ModelProgress last;
  options.progress = [&](const ModelProgress& progress) {
    EXPECT_GE(progress.workDone, last.workDone - 1e-9);
    last = progress;
  };
  const ModelMesh result = mesh(testing::box(1, 2, 3), options);
  EXPECT_NEAR(last.workDone, last.workTotal, 1e-6 * last.workTotal);
  EXPECT_EQ(last.facesDone, 6);
  EXPECT_EQ(last.elements, result.elements.size());
}

TEST(ModelMeshing, StopsWhenAskedAndSaysSo) {
  std::stop_source source;
  source.request_stop();
  MeshingOptions options;
  options.sizes.size = 0.01;
  options.stop = source.get_token();
  const ModelMesh result = mesh(testing::box(1, 2, 3), options);
  ASSERT_EQ(result.faces.size(), 6u);
  for (const FaceReport& face : result.faces) EXPECT_EQ(face.status, FaceStatus::Cancelled);
}

TEST(ModelMeshing, RefusesASizeThatIsNotPositive) {
  EXPECT_THROW(mesh(testing::box(1, 1, 1), 0), InputError);
  EXPECT_THROW(mesh(testing::box(1, 1, 1), std::nan("")), InputError);
}

TEST(MeshModel, UsesAVertexInsideAFaceThatTheFileGivesNoParametersFor) {
  const BRep_Builder builder;
  TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 4, 0, 4).Face();
  TopoDS_Vertex vertex;
  builder.MakeVertex(vertex, gp_Pnt(1.7, 2.2, 0), 1e-7);
  builder.Add(face, vertex.Oriented(TopAbs_INTERNAL));
  const ModelMesh result = mesh(testing::modelOf(face), .5);
  expectComplete(result);
  const Point3 wanted{1.7, 2.2, 0};
  EXPECT_EQ(std::count(result.vertices.begin(), result.vertices.end(), wanted), 1);
}

}  // namespace
}  // namespace af2::geometry
