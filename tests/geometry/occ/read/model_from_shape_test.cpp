#include "geometry/occ/read/model_from_shape.h"

#include <gtest/gtest.h>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>

#include "engine/base/error.h"
#include "geometry/mesh/fingerprint.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/shapes.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

struct BoxAndRod {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 2, 1).Shape();
  TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2({5, 0, 0}, {0, 0, 1}), 0.5, 2).Shape();
  TopoDS_Compound all;
  BoxAndRod() {
    const BRep_Builder builder;
    builder.MakeCompound(all);
    builder.Add(all, box);
    builder.Add(all, rod);
  }
};

TopoDS_Shape faceOf(const TopoDS_Shape& shape, int index) {
  TopExp_Explorer it(shape, TopAbs_FACE);
  for (int i = 0; i < index; ++i) it.Next();
  return it.Current();
}

TEST(ModelFromShape, IsTheModelOfABrepFileWithThisShape) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 3, 1).Shape();  // written without rounding
  const testing::TestFile file("box.brep");
  BRepTools::Write(box, file.path().c_str());
  EXPECT_EQ(fingerprint(testing::mesh(modelFrom(box), 0.3)),
            fingerprint(testing::mesh(readModel(file.path()), 0.3)));
}

TEST(ModelFromShape, HasTheNamesThatItIsGiven) {
  const BoxAndRod made;
  ShapeNames names;
  names.unit = "m";
  names.names = {{faceOf(made.box, 2), "inlet"},
                 {made.rod, "rod"},
                 {faceOf(made.box, 0), "#ff0000", GroupKind::Color},
                 {faceOf(made.rod, 0), "#ff0000", GroupKind::Color}};
  const Model model = modelFrom(made.all, names);
  EXPECT_EQ(model.unit(), "m");
  EXPECT_EQ(model.faceName(3), "inlet");
  EXPECT_EQ(model.faceName(1), "");
  const std::vector<FaceGroup>& groups = model.groups();
  ASSERT_EQ(groups.size(), 4u);  // and two solids
  EXPECT_EQ(groups[0].name, "rod");
  EXPECT_EQ(groups[0].faces, (std::vector<int>{7, 8, 9}));
  EXPECT_EQ(groups[1].kind, GroupKind::Color);
  EXPECT_EQ(groups[1].faces, (std::vector<int>{1, 7}));
  EXPECT_EQ(testing::mesh(model, 0.5).faces.at(2).name, "inlet");
}

TEST(ModelFromShape, KeepsNamesOfFacesWhoseBoundaryIsCompleted) {
  const BRep_Builder builder;
  TopoDS_Face bare;
  builder.MakeFace(bare, BRep_Tool::Surface(testing::sphereOf(BRepPrimAPI_MakeSphere(1).Shape())),
                   1e-7);
  const Model model = modelFrom(bare, {{{bare, "ball"}, {bare, "paint", GroupKind::Layer}}, ""});
  EXPECT_EQ(model.notes().size(), 1u);
  EXPECT_EQ(model.faceName(1), "ball");
  ASSERT_EQ(model.groups().size(), 1u);
  EXPECT_EQ(model.groups()[0].faces, std::vector<int>{1});
}

std::string refusalOf(const TopoDS_Shape& shape, const ShapeNames& names = {}) {
  try {
    modelFrom(shape, names);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ModelFromShape, IsRefusedWithTheReason) {
  const BoxAndRod made;
  const auto named = [](const NamedShape& name) { return ShapeNames{{name}, ""}; };
  EXPECT_EQ(refusalOf({}), "modelFrom: the shape is null");
  EXPECT_EQ(refusalOf(testing::circle(1)), "modelFrom: the shape has no face");
  EXPECT_EQ(refusalOf(made.box, named({made.rod, "rod"})),
            "modelFrom: the shape called 'rod' has a face that the model does not have");
  EXPECT_EQ(refusalOf(made.box, named({{}, "rod"})), "modelFrom: the shape called 'rod' is null");
  EXPECT_EQ(refusalOf(made.box, named({testing::circle(1), "rim"})),
            "modelFrom: the shape called 'rim' has no face");
  EXPECT_EQ(refusalOf(made.box, named({made.box, ""})), "modelFrom: a name is empty");
  EXPECT_EQ(refusalOf(made.box, named({made.box, "red", GroupKind::Color})),
            "modelFrom: 'red' is not a colour of the form #rrggbb, in lower case");
  EXPECT_EQ(refusalOf(made.box, named({made.box, "7", GroupKind::Solid})),
            "modelFrom: '7' names a group of the kind Solid; name the solid as a Part");
}

}  // namespace
}  // namespace af2::geometry
