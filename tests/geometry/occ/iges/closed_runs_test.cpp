#include "geometry/occ/iges/closed_runs.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_Copy.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>

#include "tests/geometry/occ/run/dirt.h"
#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

using Faces = std::vector<TopoDS_Shape>;

/// Each with edges of its own.
Faces looseFacesOf(const TopoDS_Shape& shape) {
  Faces faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
  return faces;
}

Faces blockAt(double x, double width) {
  return looseFacesOf(BRepPrimAPI_MakeBox(gp_Pnt(x, 0, 0), width, 1, 1).Shape());
}

Faces joined(Faces faces, const Faces& others) {
  faces.insert(faces.end(), others.begin(), others.end());
  return faces;
}

std::vector<int> sizesOfRuns(const Faces& faces) {
  std::vector<int> sizes;
  for (const TopoDS_Shape& run : closedRuns(testing::compoundOf(faces), 1e-6)) {
    sizes.push_back(0);
    for (TopoDS_Iterator it(run); it.More(); it.Next()) ++sizes.back();
  }
  return sizes;
}

TEST(ClosedRuns, PartAtEachPartThatCloses) {
  const Faces touching = joined(blockAt(0, 1), joined(blockAt(1, 2), blockAt(3, 1)));
  EXPECT_EQ(sizesOfRuns(touching), (std::vector<int>{6, 6, 6}));
  EXPECT_EQ(sizesOfRuns(looseFacesOf(BRepPrimAPI_MakeCylinder(1, 2).Shape())), std::vector<int>{3});
}

TEST(ClosedRuns, LeaveTogetherWhatIsOpenAndWhatItLiesOn) {
  Faces open = blockAt(1, 1);
  open.erase(open.begin());  // where it would touch the block before
  EXPECT_EQ(sizesOfRuns(joined(blockAt(0, 1), open)), std::vector<int>{11});
  EXPECT_EQ(sizesOfRuns(joined(blockAt(-5, 1), open)), (std::vector<int>{6, 5}));
}

TEST(ClosedRuns, AreOneIfTheFacesOfPartsAlternate) {
  const Faces one = blockAt(0, 1), other = blockAt(5, 1);
  Faces mixed;
  for (std::size_t i = 0; i < one.size(); ++i) {
    mixed.push_back(one[i]);
    mixed.push_back(other[i]);
  }
  EXPECT_EQ(sizesOfRuns(mixed), std::vector<int>{12});
}

TEST(ClosedRuns, DoNotTakeShellsApart) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  EXPECT_EQ(sizesOfRuns(joined({TopExp_Explorer(block, TopAbs_SHELL).Current()}, blockAt(1, 1))),
            (std::vector<int>{1, 6}));
}

}  // namespace
}  // namespace af2::geometry
