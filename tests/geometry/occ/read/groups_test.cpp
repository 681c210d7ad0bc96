// Names, layers, colours and solids of STEP files; elements of second order on CAD surfaces.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <filesystem>

#include "geometry/base/words.h"
#include "geometry/mesh/second_order.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

ModelMesh mesh(const Model& model, double size, int order) {
  MeshingOptions options = testing::ofSize(size);
  options.order = order;
  ModelMesh result = testing::mesh(model, options);
  testing::expectComplete(result);
  return result;
}

/// An assembly of a box and a cylinder, twice; the box is red but for one face, the rest is blue.
void writeAssembly(const std::filesystem::path& path) {
  const Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto layers = XCAFDoc_DocumentTool::LayerTool(document->Main());
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(0.5, 2).Shape();
  gp_Trsf away;
  away.SetTranslation({5, 0, 0});
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, box);
  builder.Add(all, rod.Moved(TopLoc_Location(away)));
  away.SetTranslation({9, 0, 0});
  builder.Add(all, rod.Moved(TopLoc_Location(away)));
  const TDF_Label top = shapes->AddShape(all, true);
  TDataStd_Name::Set(top, "machine");
  TDF_Label boxLabel, rodLabel;
  shapes->FindShape(box, boxLabel);
  shapes->FindShape(rod, rodLabel);
  TDataStd_Name::Set(boxLabel, "base");
  TDataStd_Name::Set(rodLabel, "rod");
  colors->SetColor(boxLabel, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
  colors->SetColor(rodLabel, Quantity_Color(0, 0, 1, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
  const TopoDS_Shape side = TopExp_Explorer(box, TopAbs_FACE).Current();
  colors->SetColor(shapes->AddSubShape(boxLabel, side), Quantity_Color(0, 1, 0, Quantity_TOC_sRGB),
                   XCAFDoc_ColorSurf);
  layers->SetLayer(rodLabel, "turned parts");
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPCAFControl_Writer writer;
  writer.SetLayerMode(true);
  writer.Transfer(document);
  writer.Write(path.c_str());
}

std::size_t facesIn(const Model& model, GroupKind kind, const std::string& name) {
  for (const FaceGroup& group : model.groups())
    if (group.kind == kind && group.name == name) return group.faces.size();
  return 0;
}

TEST(Groups, AreTheNamesLayersColorsAndSolidsOfAStepFile) {
  const testing::TestFile file("assembly.step");
  writeAssembly(file.path());
  const Model model = readModel(file.path());
  ASSERT_EQ(model.faceCount(), 12);
  EXPECT_EQ(facesIn(model, GroupKind::Part, "machine"), 12u);
  EXPECT_EQ(facesIn(model, GroupKind::Part, "base"), 6u);
  EXPECT_EQ(facesIn(model, GroupKind::Part, "rod"), 6u) << "both places of it";
  EXPECT_EQ(facesIn(model, GroupKind::Layer, "turned parts"), 6u);
  EXPECT_EQ(facesIn(model, GroupKind::Color, "#ff0000"), 5u);
  EXPECT_EQ(facesIn(model, GroupKind::Color, "#00ff00"), 1u);
  EXPECT_EQ(facesIn(model, GroupKind::Color, "#0000ff"), 6u);
  for (const char* solid : {"1", "2", "3"}) EXPECT_GT(facesIn(model, GroupKind::Solid, solid), 0u);
  EXPECT_EQ(mesh(model, 0.5, 1).groups, model.groups());
}

/// The standard has escapes for what is not ASCII, but many programs write names as they have them.
TEST(Groups, HaveNamesInUtf8OrElseInWindows1252) {
  const std::string text = contentOf(AF2_SOURCE_DIR "/examples/models/cylinder.step");
  const std::size_t face = text.find("ADVANCED_FACE('") + 15;
  for (const auto& [name, isNoted] :
       {std::pair("T\\X2\\00E4\\X0\\l", false), {"T\xc3\xa4l", false}, {"T\xe4l", true}}) {
    const testing::TestFile file("named.step", std::string(text).insert(face, name));
    const Model model = readModel(file.path());
    std::vector<std::string> names;
    for (int id = 1; id <= model.faceCount(); ++id) names.push_back(model.faceName(id));
    EXPECT_EQ(std::count(names.begin(), names.end(), "T\xc3\xa4l"), 1) << name;
    EXPECT_EQ(model.notes().size(), isNoted ? 1u : 0u) << name;
  }
}

double areaOfSecondOrder(const ModelMesh& mesh) {
  double area = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto corner = [&](std::size_t i) {
      return mesh.vertices[mesh.elements[e].corners[i].value];
    };
    const auto middle = [&](std::size_t i) { return mesh.vertices[mesh.midsides[e][i].value]; };
    const auto add = [&](const Point3& a, const Point3& b, const Point3& c) {
      area += length(cross(b - a, c - a)) / 2;
    };
    for (std::size_t i = 0; i < 3; ++i) add(corner(i), middle(i), middle((i + 2) % 3));
    add(middle(0), middle(1), middle(2));
  }
  return area;
}

TEST(SecondOrder, LiesOnASphere) {
  const ModelMesh ball = mesh(testing::sphere(1), 0.4, 2);
  ASSERT_EQ(ball.midsides.size(), ball.elements.size());
  EXPECT_TRUE(ball.straightened.empty());
  for (const Point3& p : ball.vertices) EXPECT_NEAR(length(p), 1, 1e-9);
  for (std::size_t e = 0; e < ball.elements.size(); ++e) EXPECT_GT(scaledJacobian(ball, e), 0.3);
  EXPECT_NEAR(areaOfSecondOrder(ball), 4 * 3.14159265, 0.02 * 12.6);
}

TEST(SecondOrder, FollowsTheCurvesOfEdgesByTheirParameter) {
  const ModelMesh tube = mesh(testing::cylinder(1, 2), 0.5, 2);
  std::size_t onCircles = 0;
  for (const EdgeSegment& segment : tube.segments) {
    const Point3 &a = tube.vertices[segment.from.value], &b = tube.vertices[segment.to.value];
    if (a.z != b.z) continue;
    ++onCircles;
    EXPECT_NEAR(std::hypot(segment.middle.x, segment.middle.y), 1, 1e-12);
    EXPECT_NEAR(distance(a, segment.middle), distance(b, segment.middle), 1e-12);
    EXPECT_EQ(std::count(tube.vertices.begin(), tube.vertices.end(), segment.middle), 1);
  }
  EXPECT_GT(onCircles, 10u);
  for (const Point3& p : tube.vertices) EXPECT_LT(std::hypot(p.x, p.y), 1 + 1e-9);
}

}  // namespace
}  // namespace af2::geometry
