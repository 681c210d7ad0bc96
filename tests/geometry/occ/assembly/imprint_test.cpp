// Parts that touch share faces, so that meshes match and each solid has a closed shell.
#include "geometry/occ/assembly/imprint.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_Copy.hxx>
#include <map>
#include <numbers>
#include <set>

#include "engine/base/error.h"
#include "geometry/occ/assembly/contacts.h"
#include "tests/geometry/occ/assembly/assemblies.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using testing::assemblyOf;
using testing::boxBetween;

const FaceGroup* groupOf(const std::vector<FaceGroup>& groups, GroupKind kind,
                         const std::string& name) {
  for (const FaceGroup& group : groups)
    if (group.kind == kind && group.name == name) return &group;
  return nullptr;
}

std::set<std::string> namesOf(const Model& model, GroupKind kind) {
  std::set<std::string> names;
  for (const FaceGroup& group : model.groups())
    if (group.kind == kind) names.insert(group.name);
  return names;
}

/// Of the elements of a solid, those of faces that look into it turned round. Fails unless they are
/// closed and oriented.
double shellVolume(const ModelMesh& mesh, const FaceGroup& solid) {
  const auto has = [](const std::vector<int>& ids, int id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  std::map<std::pair<VertexId, VertexId>, int> sides;
  double volume = 0;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    if (!has(solid.faces, mesh.face[i])) continue;
    auto corners = mesh.elements[i].corners;
    if (has(solid.inward, mesh.face[i])) std::swap(corners[1], corners[2]);
    for (std::size_t k = 0; k < 3; ++k) ++sides[{corners[k], corners[(k + 1) % 3]}];
    const auto at = [&](std::size_t k) { return mesh.vertices[corners[k].value]; };
    volume += dot(at(0), cross(at(1), at(2))) / 6;
  }
  for (const auto& [side, uses] : sides) {
    EXPECT_EQ(uses, 1) << "in solid " << solid.name;
    EXPECT_TRUE(sides.contains({side.second, side.first})) << "solid " << solid.name << " is open";
  }
  return volume;
}

/// The volumes of the shells of all solids, by mesh; also expects one element at each place, and
/// the same mesh on one thread and on two.
std::vector<double> shellVolumes(const Model& model, double size) {
  MeshingOptions options = testing::ofSize(size);
  const ModelMesh mesh = testing::mesh(model, options);
  testing::expectComplete(mesh);
  options.threads = 2;
  const ModelMesh again = testing::mesh(model, options);
  EXPECT_EQ(mesh.vertices, again.vertices);
  EXPECT_EQ(mesh.elements, again.elements);
  std::set<std::set<VertexId>> places;
  for (const Element& e : mesh.elements)
    EXPECT_TRUE(places.insert({e.corners[0], e.corners[1], e.corners[2]}).second);
  std::vector<double> volumes;
  for (const FaceGroup& group : mesh.groups)
    if (group.kind == GroupKind::Solid) volumes.push_back(shellVolume(mesh, group));
  return volumes;
}

void expectImprinted(const Model& model, std::size_t interfaces) {
  ASSERT_TRUE(model.imprinting());
  EXPECT_EQ(model.imprinting()->undone, "");
  EXPECT_EQ(model.imprinting()->interfaces, interfaces);
  EXPECT_TRUE(findContacts(model).pairs.empty()) << "all parts share what they have in common";
}

TEST(Imprint, GivesBoxesThatTouchOneFaceInCommon) {
  const Model model = imprintModel(testing::touchingBoxes());
  expectImprinted(model, 1);
  EXPECT_EQ(model.faceCount(), 13);
  const FaceGroup* common = groupOf(model.groups(), GroupKind::Interface, "left|right");
  ASSERT_TRUE(common);
  ASSERT_EQ(common->faces.size(), 1u);
  for (const char* part : {"left", "right"}) {
    const auto& faces = groupOf(model.groups(), GroupKind::Part, part)->faces;
    EXPECT_EQ(std::count(faces.begin(), faces.end(), common->faces[0]), 1) << part;
  }
  EXPECT_EQ(groupOf(model.groups(), GroupKind::Solid, "2")->inward, common->faces);
  const std::vector<double> volumes = shellVolumes(model, 0.7);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0], 64, 1e-9);
  EXPECT_NEAR(volumes[1], 36, 1e-9);
}

TEST(Imprint, GivesABoltAndItsPlateOneFaceInCommon) {
  const Model model = imprintModel(testing::boltOnPlate());
  expectImprinted(model, 1);
  ASSERT_TRUE(groupOf(model.groups(), GroupKind::Interface, "plate|bolt"));
  const std::vector<double> volumes = shellVolumes(model, 0.5);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0], 100, 1e-9);
  EXPECT_NEAR(volumes[1], 3 * std::numbers::pi, 0.3);
}

TEST(Imprint, GivesThreeBoxesAroundAnEdgeThatEdge) {
  const Model model = imprintModel(testing::threeBoxes());
  expectImprinted(model, 2);
  EXPECT_EQ(model.faceCount(), 16);
  for (const double volume : shellVolumes(model, 0.7)) EXPECT_NEAR(volume, 12, 1e-9);
}

TEST(Imprint, GivesASheetAndABoxOneFaceInCommon) {
  const Model model = imprintModel(testing::sheetOnBox());
  expectImprinted(model, 1);
  EXPECT_EQ(model.faceCount(), 7);
  EXPECT_EQ(namesOf(model, GroupKind::Interface), std::set<std::string>{"block|label"});
  EXPECT_NEAR(shellVolumes(model, 0.7).at(0), 48, 1e-9);
}

TEST(Imprint, DividesASolidAlongASheetThroughIt) {
  const Model model =
      imprintModel(assemblyOf({{"block", boxBetween({0, 0, -1}, {4, 4, 1})},
                               {"sheet", testing::plane({testing::rectangle(-1, -1, 5, 5)})}}));
  expectImprinted(model, 1);
  const std::vector<double> volumes = shellVolumes(model, 1);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_NEAR(volumes[0], 16, 1e-9);
  EXPECT_NEAR(volumes[1], 16, 1e-9);
}

TEST(Imprint, KeepsASheetThatEndsInsideASolid) {
  const Model model =
      imprintModel(assemblyOf({{"block", boxBetween({0, 0, -1}, {4, 4, 1})},
                               {"sheet", testing::plane({testing::rectangle(1, 1, 3, 3)})}}));
  expectImprinted(model, 0);
  EXPECT_EQ(model.faceCount(), 7);
  EXPECT_NEAR(shellVolumes(model, 1).at(0), 32, 1e-9);
}

TEST(Imprint, RefusesSolidsThatOverlapByTheirNames) {
  try {
    imprintModel(testing::overlappingBoxes());
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'first' and 'second' (volume 6)"), std::string::npos)
        << error.what();
  }
}

TEST(Imprint, GivesAnOverlapToThePartThatIsAskedFor) {
  ImprintOptions options;
  for (const auto& [overlaps, first, second] :
       {std::tuple{Overlaps::First, 64.0, 21.0}, std::tuple{Overlaps::Last, 58.0, 27.0}}) {
    options.overlaps = overlaps;
    const Model model = imprintModel(testing::overlappingBoxes(), options);
    expectImprinted(model, 1);
    const std::vector<double> volumes = shellVolumes(model, 0.7);
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_NEAR(volumes[0], first, 1e-9);
    EXPECT_NEAR(volumes[1], second, 1e-9);
    EXPECT_EQ(model.imprinting()->changes.size(), 1u);
    const FaceGroup* loser =
        groupOf(model.groups(), GroupKind::Part, overlaps == Overlaps::First ? "second" : "first");
    const FaceGroup* solid =
        groupOf(model.groups(), GroupKind::Solid, overlaps == Overlaps::First ? "2" : "1");
    EXPECT_EQ(loser->faces, solid->faces);
  }
}

TEST(Imprint, CutsAnOverlapOutAsASolidOfItsOwn) {
  ImprintOptions options;
  options.overlaps = Overlaps::Cut;
  const Model model = imprintModel(testing::overlappingBoxes(), options);
  expectImprinted(model, 2);
  EXPECT_EQ(namesOf(model, GroupKind::Interface),
            (std::set<std::string>{"first|first&second", "second|first&second"}));
  const std::vector<double> volumes = shellVolumes(model, 0.7);
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes[0], 58, 1e-9);
  EXPECT_NEAR(volumes[1], 21, 1e-9);
  EXPECT_NEAR(volumes[2], 6, 1e-9);
}

TEST(Imprint, TellsIfNothingIsLeftOfAPart) {
  const TopoDS_Shape box = boxBetween({0, 0, 0}, {1, 2, 3});
  ImprintOptions options;
  options.overlaps = Overlaps::First;
  const Model model =
      imprintModel(assemblyOf({{"a", box}, {"b", BRepBuilderAPI_Copy(box).Shape()}}), options);
  EXPECT_EQ(model.faceCount(), 6);
  ASSERT_EQ(model.imprinting()->changes.size(), 2u);
  EXPECT_EQ(model.imprinting()->changes[1],
            "nothing is left of 'b': all its volume belongs to other parts");
  EXPECT_NEAR(shellVolumes(model, 0.5).at(0), 6, 1e-9);
}

TEST(Imprint, KeepsNamesAndColoursOfFacesThatAreSplit) {
  const TopoDS_Shape plate = boxBetween({0, 0, 0}, {10, 10, 1});
  const TopoDS_Shape bolt = BRepPrimAPI_MakeCylinder(gp_Ax2({5, 5, 1}, {0, 0, 1}), 1, 3).Shape();
  TopoDS_Face top;
  for (TopExp_Explorer it(plate, TopAbs_FACE); it.More(); it.Next())
    top = TopoDS::Face(it.Current());
  ReadShape read;
  read.shape = testing::compoundOf({plate, bolt});
  read.unit = "mm";
  read.nameOf = [top](const TopoDS_Face& face) { return face.IsSame(top) ? "top" : ""; };
  read.groups = {{"#ff0000", GroupKind::Color, {top}}, {"steel", GroupKind::Layer, {plate}}};
  const Model model = imprintModel(Model(makeModelShape(std::move(read))));
  expectImprinted(model, 1);
  EXPECT_EQ(model.unit(), "mm");
  std::vector<int> named;
  for (int face = 1; face <= model.faceCount(); ++face)
    if (model.faceName(face) == "top") named.push_back(face);
  EXPECT_EQ(named.size(), 2u) << "the ring and the disk under the bolt";
  EXPECT_EQ(groupOf(model.groups(), GroupKind::Color, "#ff0000")->faces, named);
  EXPECT_EQ(groupOf(model.groups(), GroupKind::Layer, "steel")->faces.size(), 7u);
  EXPECT_EQ(namesOf(model, GroupKind::Interface), std::set<std::string>{"solid 1|solid 2"});
}

TEST(Imprint, JoinsOnlyEqualFacesIfAskedFor) {
  ImprintOptions options;
  options.onlyEqual = true;
  const Model walls = assemblyOf(
      {{"a", boxBetween({0, 0, 0}, {1, 1, 1})}, {"b", boxBetween({1, 0, 0}, {2, 1, 1})}});
  const Model model = imprintModel(walls, options);
  expectImprinted(model, 1);
  for (const double volume : shellVolumes(model, 0.4)) EXPECT_NEAR(volume, 1, 1e-9);
}

TEST(Imprint, UsesTheToleranceThatIsAskedFor) {
  const Model apart = assemblyOf(
      {{"a", boxBetween({0, 0, 0}, {1, 1, 1})}, {"b", boxBetween({1.001, 0, 0}, {2, 1, 1})}});
  EXPECT_EQ(imprintModel(apart).imprinting()->interfaces, 0u);
  ImprintOptions options;
  options.tolerance = 0.002;
  const Model model = imprintModel(apart, options);
  EXPECT_EQ(model.imprinting()->undone, "");
  EXPECT_EQ(model.imprinting()->interfaces, 1u);
  options.tolerance = -1;
  EXPECT_THROW(imprintModel(apart, options), InputError);
}

TEST(Imprint, ReturnsTheModelAsItWasIfItIsStopped) {
  std::stop_source source;
  source.request_stop();
  ImprintOptions options;
  options.stop = source.get_token();
  const Model before = testing::touchingBoxes();
  const Model model = imprintModel(before, options);
  EXPECT_EQ(model.imprinting()->undone, "it was stopped");
  EXPECT_EQ(model.faceCount(), 12);
  EXPECT_EQ(model.groups(), before.groups());
}

TEST(Imprint, ReturnsTheModelAsItWasIfItTakesTooLong) {
  ImprintOptions options;
  options.seconds = 0;
  const Model model = imprintModel(testing::touchingBoxes(), options);
  EXPECT_EQ(model.imprinting()->undone, "it took longer than 0 seconds");
  EXPECT_EQ(model.faceCount(), 12);
}

TEST(Imprint, KeepsTheOrientationOfSheets) {
  const TopoDS_Shape sheet = testing::plane({testing::rectangle(-1, -1, 5, 5)}).Reversed();
  const auto lift = [](const Model& model) {
    double z = 0;
    for (const ModelMesh mesh = testing::mesh(model, 1); const Element& e : mesh.elements) {
      const auto at = [&](std::size_t k) { return mesh.vertices[e.corners[k].value]; };
      z += cross(at(1) - at(0), at(2) - at(0)).z / 2;
    }
    return z;
  };
  const Model model =
      imprintModel(assemblyOf({{"block", boxBetween({0, 0, 0}, {2, 2, 2})}, {"sheet", sheet}}));
  // The closed block adds nothing, and its bottom takes the place of that part of the sheet.
  EXPECT_NEAR(lift(testing::modelOf(sheet)), -36, 1e-9);
  EXPECT_NEAR(lift(model), -32, 1e-9);
}

TEST(Imprint, LeavesAModelOfOnePartAsItIs) {
  const Model box = testing::box(1, 2, 3);
  const Model model = imprintModel(box);
  EXPECT_EQ(model.imprinting()->parts, 1u);
  EXPECT_EQ(testing::mesh(box, 0.5).vertices, testing::mesh(model, 0.5).vertices);
}

}  // namespace
}  // namespace af2::geometry
