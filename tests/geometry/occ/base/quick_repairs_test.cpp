// That OpenCASCADE's replacements of shapes give what they gave, where copies are left out.
#include "geometry/occ/base/quick_repairs.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <ShapeAlgo_ToolContainer.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/stopwatch.h"
#include "geometry/occ/model/model.h"
#include "tests/geometry/occ/in_iges.h"
#include "tests/geometry/occ/in_step.h"

namespace af2::geometry {
namespace {

using Context = Handle(ShapeBuild_ReShape);

Context quickContext() {
  repairShapesQuickly();
  return ShapeAlgo::AlgoContainer()->ToolContainer()->FixShape()->Context();
}

Context plainContext() {
  const Context context = new ShapeBuild_ReShape;
  context->ModeConsiderLocation() = true;
  return context;
}

/// Two boxes that are one shape at two places.
TopoDS_Shape twoBoxes() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Solid();
  gp_Trsf away;
  away.SetTranslation({5, 0, 0});
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, box);
  builder.Add(both, box.Moved(away));
  return both;
}

TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, type, parts);
  return parts;
}

/// By type: how many parts there are, and how many of them are parts of `before`.
std::vector<std::pair<int, int>> countsOf(const TopoDS_Shape& shape, const TopoDS_Shape& before) {
  std::vector<std::pair<int, int>> counts;
  for (const TopAbs_ShapeEnum type : {TopAbs_COMPOUND, TopAbs_SOLID, TopAbs_SHELL, TopAbs_FACE,
                                      TopAbs_WIRE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopTools_IndexedMapOfShape parts = partsOf(shape, type), old = partsOf(before, type);
    int kept = 0;
    for (int i = 1; i <= parts.Extent(); ++i) kept += old.Contains(parts(i));
    counts.emplace_back(parts.Extent(), kept);
  }
  return counts;
}

/// What both contexts make of a shape in which a part has been replaced, or removed.
void expectBothMakeTheSame(const TopoDS_Shape& shape, const TopoDS_Shape& part,
                           const TopoDS_Shape& by) {
  const Context quick = quickContext(), plain = plainContext();
  for (const Context& context : {quick, plain}) context->Replace(part, by);
  for (int turn = 0; turn < 2; ++turn) {
    const TopoDS_Shape made = quick->Apply(shape), expected = plain->Apply(shape);
    EXPECT_FALSE(made.IsSame(shape));
    EXPECT_EQ(countsOf(made, shape), countsOf(expected, shape));
    EXPECT_EQ(made.Orientation(), expected.Orientation());
    for (int status = ShapeExtend_OK; status <= ShapeExtend_FAIL; ++status)
      EXPECT_EQ(quick->Status(static_cast<ShapeExtend_Status>(status)),
                plain->Status(static_cast<ShapeExtend_Status>(status)))
          << status << " at turn " << turn;
  }
}

TEST(QuickRepairs, ReplacesPartsAsBefore) {
  const TopoDS_Shape shape = twoBoxes();
  for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopoDS_Shape part = partsOf(shape, type)(2);
    expectBothMakeTheSame(shape, part, BRepBuilderAPI_Copy(part).Shape());
    expectBothMakeTheSame(shape.Reversed(), part, BRepBuilderAPI_Copy(part).Shape());
  }
  expectBothMakeTheSame(shape, partsOf(shape, TopAbs_FACE)(4), {});
}

TEST(QuickRepairs, GivesTheSameShapeWhereNothingIsReplaced) {
  const TopoDS_Shape shape = twoBoxes(), other = twoBoxes();
  const Context context = quickContext();
  EXPECT_TRUE(context->Apply(shape).IsEqual(shape));
  context->Remove(partsOf(other, TopAbs_FACE)(1));
  EXPECT_TRUE(context->Apply(shape).IsEqual(shape));
  EXPECT_TRUE(context->Status(ShapeExtend_OK));
  EXPECT_TRUE(context->Apply({}).IsNull());
  EXPECT_FALSE(context->Apply(other).IsEqual(other));
  context->Clear();
  EXPECT_TRUE(context->Apply(other).IsEqual(other));
}

/// Sets tools, and puts those that were there before back.
class WithTools {
 public:
  explicit WithTools(const Handle(ShapeAlgo_ToolContainer) & tools) {
    ShapeAlgo::Init();
    before_ = ShapeAlgo::AlgoContainer()->ToolContainer();
    ShapeAlgo::AlgoContainer()->SetToolContainer(tools);
  }
  ~WithTools() { ShapeAlgo::AlgoContainer()->SetToolContainer(before_); }
  static Handle(ShapeAlgo_ToolContainer) now() {
    return ShapeAlgo::AlgoContainer()->ToolContainer();
  }

 private:
  Handle(ShapeAlgo_ToolContainer) before_;
};

TEST(QuickRepairs, KeepsTheToolsOfTheProgram) {
  struct Own : ShapeAlgo_ToolContainer {};
  const Handle(ShapeAlgo_ToolContainer) own = new Own;
  const WithTools tools(own);
  repairShapesQuickly();
  EXPECT_EQ(tools.now(), own);
}

/// What OpenCASCADE's reader makes of a STEP file, as text.
///
/// seconds  if not null: how long it takes to make it, once the file has been read
std::string readWith(const Handle(ShapeAlgo_ToolContainer) & tools, const std::string& step,
                     double* seconds = nullptr) {
  const WithTools used(tools);
  const testing::TestFile file("model.step", step);
  STEPControl_Reader reader;
  if (reader.ReadFile(file.path().c_str()) != IFSelect_RetDone) return "not read";
  const Stopwatch watch;
  reader.TransferRoots();
  if (seconds) *seconds = watch.seconds();
  std::ostringstream text;
  if (reader.NbShapes() > 0) BRepTools::Write(reader.OneShape(), text);
  return text.str();
}

Handle(ShapeAlgo_ToolContainer) quickTools() {
  repairShapesQuickly();
  return WithTools::now();
}

/// With plane faces with and without holes, some of which touch curved ones.
std::vector<TopoDS_Shape> solids() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(3, 4, 5).Solid();
  const gp_Ax2 upwards({1, 2, -1}, {0, 0, 1});
  const TopoDS_Shape drilled =
      BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(upwards, 0.5, 9).Solid());
  const TopoDS_Shape pierced =
      BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeBox({1, 1, -1}, {2, 2, 9}).Solid());
  const TopoDS_Shape hollow =
      BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeBox({1, 1, 1}, {2, 2, 2}).Solid());
  return {box, drilled, pierced, hollow, twoBoxes()};
}

TEST(QuickRepairs, LeaveOutOnlyFacesThatNeedNone) {
  const auto quick = quickTools();
  const Handle(ShapeAlgo_ToolContainer) plain = new ShapeAlgo_ToolContainer;
  for (const TopoDS_Shape& solid : solids()) {
    const std::string step = testing::inStep(solid);
    EXPECT_EQ(readWith(quick, step), readWith(plain, step));
  }
}

/// Of the plate, the two large faces take most of the time.
TEST(QuickRepairs, LeaveOutFaces) {
  constexpr int kHoles = 12;  // in each direction
  BRepBuilderAPI_MakeFace plate(gp_Pln(), 0, kHoles + 1, 0, kHoles + 1);
  for (int i = 1; i <= kHoles; ++i)
    for (int j = 1; j <= kHoles; ++j) {
      const gp_Circ circle(gp_Ax2({1. * i, 1. * j, 0}, {0, 0, -1}), 0.3);
      plate.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)).Wire());
    }
  const std::string step =
      testing::inStep(BRepPrimAPI_MakePrism(plate.Face(), gp_Vec(0, 0, 1)).Shape());
  // The least of a few turns, since other load only adds to them.
  double quick = 1e9, plain = 1e9;
  for (int turn = 0; turn < 3; ++turn) {
    double one = 0, other = 0;
    const std::string made = readWith(quickTools(), step, &one);
    EXPECT_EQ(made, readWith(new ShapeAlgo_ToolContainer, step, &other));
    quick = std::min(quick, one);
    plain = std::min(plain, other);
  }
  EXPECT_GT(plain, 2 * quick);  // 3.4 times; 1.7 times if no face is left out
}

TEST(QuickRepairs, MakeTheSameOfFaultyFiles) {
  const auto quick = quickTools();
  const Handle(ShapeAlgo_ToolContainer) plain = new ShapeAlgo_ToolContainer;
  // Each in turn: a face, a boundary or an edge turned around, a point moved.
  const std::vector<std::pair<std::string, std::string>> faults = {{".T.)", ".F.)"},
                                                                   {"(1.,1.,", "(1.,1.001,"},
                                                                   {"(3.,4.,", "(3.,4.0000002,"},
                                                                   {"(3.,0.,", "(3.,4.,"},
                                                                   {",0.5)", ",0.50001)"}};
  int count = 0;
  for (const TopoDS_Shape& solid : solids()) {
    const std::string step = testing::inStep(solid);
    for (const auto& [sound, faulty] : faults) {
      for (std::size_t at = step.find(sound); at != std::string::npos;
           at = step.find(sound, at + 1), ++count) {
        std::string text = step;
        text.replace(at, sound.size(), faulty);
        EXPECT_EQ(readWith(quick, text), readWith(plain, text)) << faulty << " at " << at;
      }
    }
  }
  EXPECT_GT(count, 200);
}

TEST(QuickRepairs, AreUsedByTheReaders) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Solid();
  const testing::TestFile step("box.step", testing::inStep(box)),
      iges("box.igs", testing::inIges({box}));
  for (const testing::TestFile* file : {&step, &iges}) {
    const Handle(ShapeAlgo_ToolContainer) plain = new ShapeAlgo_ToolContainer;
    const WithTools tools(plain);
    readModel(file->path());
    EXPECT_NE(tools.now(), plain) << file->path();
  }
}

}  // namespace
}  // namespace af2::geometry
