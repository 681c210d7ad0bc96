#include <gtest/gtest.h>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Lin.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/mesh/fingerprint.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

/// A motion with nothing round in it.
gp_Trsf turnedAway() {
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1({1, 2, 3}, gp_Dir(1, 2, 0.5)), 0.7);
  shift.SetTranslation(gp_Vec(12, -3, 4.5));
  return shift * turn;
}

gp_Trsf mirrored() {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2({-3, 0, 0}, gp_Dir(1, 0.2, 0.1)));
  return mirror;
}

gp_Trsf shifted(double x) {
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(x, 0, 0));
  return shift;
}

/// A block, with copies of it.
Model copiesOf(const TopoDS_Shape& shape, const std::vector<gp_Trsf>& motions) {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  builder.Add(all, shape);
  for (const gp_Trsf& motion : motions)
    builder.Add(all, BRepBuilderAPI_Transform(shape, motion, true).Shape());
  return testing::modelOf(all);
}

/// Of faces that have the mesh of another one, by id: that of the other.
std::map<int, int> takenOver(const ModelMesh& mesh) {
  std::map<int, int> taken;
  for (const FaceReport& face : mesh.faces)
    if (face.congruentTo > 0) taken[face.id] = face.congruentTo;
  return taken;
}

/// The elements of a face, as lengths of their sides.
std::multiset<std::vector<int>> formsOf(const ModelMesh& mesh, int face) {
  std::multiset<std::vector<int>> forms;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.face[e] != face) continue;
    const auto corners = mesh.elements[e].vertices();
    std::vector<int> sides;
    for (std::size_t i = 0; i < corners.size(); ++i)
      sides.push_back(
          static_cast<int>(1e6 * distance(mesh.vertices[corners[i].value],
                                          mesh.vertices[corners[(i + 1) % corners.size()].value]) +
                           0.5));
    std::ranges::sort(sides);
    forms.insert(sides);
  }
  return forms;
}

TEST(CongruentFaces, HaveTheSameMesh) {
  const Model model = copiesOf(testing::drilledBlock(), {turnedAway(), mirrored(), shifted(20)});
  ASSERT_EQ(model.faceCount(), 28);
  const ModelMesh mesh = testing::mesh(model, 0.3);
  testing::expectComplete(mesh);
  const std::map<int, int> taken = takenOver(mesh);
  for (int face = 8; face <= 28; ++face) EXPECT_TRUE(taken.contains(face)) << face;
  for (const auto& [face, other] : taken) {
    EXPECT_LT(other, face);
    EXPECT_FALSE(taken.contains(other)) << face;
    EXPECT_EQ(formsOf(mesh, face), formsOf(mesh, other)) << face;
  }
  const double volume = testing::volumeOf(testing::mesh(testing::drilledBlock(), 0.3));
  EXPECT_NEAR(testing::volumeOf(mesh), 4 * volume, 1e-9 * volume);
}

TEST(CongruentFaces, DoNotDependOnThreadsOrWhereMeshesAreKept) {
  const Model model = copiesOf(testing::drilledBlock(), {turnedAway(), mirrored(), shifted(20)});
  MeshingOptions options = testing::ofSize(0.25);
  options.sizes.elementsPerTurn = 12;
  const std::string first = fingerprint(testing::mesh(model, options));
  for (const int threads : {2, 4}) {
    options.threads = threads;
    EXPECT_EQ(fingerprint(testing::mesh(model, options)), first) << threads;
  }
  options.spool.when = SpoolRequest::When::Always;
  EXPECT_EQ(fingerprint(testing::mesh(model, options)), first);
}

TEST(CongruentFaces, WantTheSameSizesByPosition) {
  const Model model = copiesOf(testing::drilledBlock(), {shifted(20)});
  MeshingOptions options = testing::ofSize(0.3);
  options.sizes.function =
      PositionSize([](const Point3& p) { return p.x > 10 && p.z > 1.5 ? 0.15 : 1; });
  const ModelMesh mesh = testing::mesh(model, options);
  testing::expectComplete(mesh);
  const std::map<int, int> taken = takenOver(mesh);
  int acrossBodies = 0;
  for (const auto& [face, other] : taken) {
    EXPECT_EQ(formsOf(mesh, face), formsOf(mesh, other)) << face;
    if (face < 8 || other > 7) continue;
    ++acrossBodies;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      for (const VertexId v : mesh.elements[e].vertices())
        if (mesh.face[e] == face) {
          EXPECT_LT(mesh.vertices[v.value].z, 1.5) << face;
        }
  }
  EXPECT_GE(acrossBodies, 1);
}

TEST(CongruentFaces, OfASizeOfItsOwnHasItsOwnMesh) {
  const Model model = copiesOf(BRepPrimAPI_MakeBox(3, 2, 1).Shape(), {shifted(20)});
  MeshingOptions options = testing::ofSize(0.3);
  options.sizes.faceSizes[8] = 0.2;
  const ModelMesh mesh = testing::mesh(model, options);
  testing::expectComplete(mesh);
  const std::map<int, int> taken = takenOver(mesh);
  EXPECT_FALSE(taken.contains(8));
  EXPECT_GE(taken.size(), 4u);
  for (const auto& [face, other] : taken) EXPECT_NE(other, 8) << face;
}

TEST(CongruentFaces, AreFoundInsideOneBody) {
  const ModelMesh mesh = testing::mesh(testing::box(3, 2, 1), 0.2);
  testing::expectComplete(mesh);
  EXPECT_EQ(takenOver(mesh).size(), 3u);
  EXPECT_NEAR(testing::volumeOf(mesh), 6, 1e-12);
}

TEST(CongruentFaces, HaveMiddlesOnTheirSurface) {
  const gp_Trsf motion = turnedAway();
  const Model model = copiesOf(BRepPrimAPI_MakeCylinder(1, 2, 1.5).Shape(), {motion});
  MeshingOptions options = testing::ofSize(0.3);
  options.order = 2;
  const ModelMesh mesh = testing::mesh(model, options);
  testing::expectComplete(mesh);
  EXPECT_TRUE(mesh.straightened.empty());
  const gp_Lin axis(gp_Ax1({0, 0, 0}, {0, 0, 1}).Transformed(motion));
  int cylinders = 0;
  for (const FaceReport& face : mesh.faces) {
    if (face.surfaceType != "cylinder" || face.congruentTo == 0) continue;
    ++cylinders;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      for (std::size_t i = 0; i < 3; ++i) {
        if (mesh.face[e] != face.id) continue;
        const Point3& p = mesh.vertices[mesh.midsides[e][i].value];
        EXPECT_NEAR(axis.Distance(gp_Pnt(p.x, p.y, p.z)), 1, 1e-9);
      }
  }
  EXPECT_EQ(cylinders, 1);
}

/// Counts the fronts on a face.
class FrontCounter final : public AF2MeshingObserver {
 public:
  void frontBegun(const FrontInput&) override { ++count; }
  std::atomic<int> count = 0;
};

TEST(CongruentFaces, AreFilledForObserversOnly) {
  const Model model = copiesOf(testing::drilledBlock(), {shifted(20)});
  MeshingOptions options = testing::ofSize(0.3);
  const std::string first = fingerprint(testing::mesh(model, options));
  std::map<int, FrontCounter> counters;
  options.observer = [&](int face) { return &counters[face]; };
  const ModelMesh mesh = testing::mesh(model, options);
  EXPECT_GE(takenOver(mesh).size(), 7u);
  for (const FaceReport& face : mesh.faces) EXPECT_GT(counters[face.id].count, 0) << face.id;
  EXPECT_EQ(fingerprint(mesh), first);
}

TEST(CongruentFaces, AreSplinesWithTheSameParameters) {
  const TopoDS_Shape wave = BRepBuilderAPI_NurbsConvert(testing::drilledBlock()).Shape();
  const ModelMesh mesh = testing::mesh(copiesOf(wave, {turnedAway(), shifted(20)}), 0.3);
  testing::expectComplete(mesh);
  const std::map<int, int> taken = takenOver(mesh);
  for (int face = 8; face <= 21; ++face) EXPECT_TRUE(taken.contains(face)) << face;
  for (const auto& [face, other] : taken)
    EXPECT_EQ(formsOf(mesh, face), formsOf(mesh, other)) << face;
}

}  // namespace
}  // namespace af2::geometry
