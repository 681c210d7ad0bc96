#include "geometry/occ/sizes/sizing.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <ElSLib.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <vector>

#include "engine/base/constants.h"
#include "geometry/base/box_tree.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/sizes/face_range.h"
#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

using testing::uniform;

/// The number of elements expected on the first face of a box, and of places at which the size
/// there was asked for.
struct Expected {
  double elements;
  int places = 0;

  Expected(const Model& model, double area, int samples,
           const std::function<double(const Point3&)>& sizeAt) {
    CadSizes sizes = uniform(1);
    sizes.growth = 0.4;
    sizes.function = [&](const Point3& p) {
      ++places;
      return sizeAt(p);
    };
    const FaceSurface surface = model.shape().surface(1);
    elements = expectedByPosition(sizes, 1, surface, area, rangeOf(model.shape().face(1), surface),
                                  samples);
  }
};

/// Far away from the origin of its plane.
const gp_Pln kPlane(gp_Pnt(1, 2, 3), gp_Dir(1, 0, 0));
constexpr double kU = 5, kV = 7;
Model squareOf(double side) {
  return testing::modelOf(BRepBuilderAPI_MakeFace(kPlane, kU, kU + side, kV, kV + side).Shape());
}
Point3 middleOfSquare(double side) {
  return toPoint(ElSLib::Value(kU + side / 2, kV + side / 2, kPlane));
}

double elementsOfSize(double size, double area) { return area / (kUnitTriangle * size * size); }

TEST(ExpectedElements, OnASmallFaceAreKnownFromAFewPlaces) {
  const Expected small(squareOf(0.1), 0.01, 8, [](const Point3&) { return 0.5; });
  EXPECT_EQ(small.places, 4);
  EXPECT_NEAR(small.elements / elementsOfSize(0.5, 0.01), 1, 1e-9);
}

TEST(ExpectedElements, OnALargeFaceCountWhatIsFineSomewhere) {
  const Model square = squareOf(4);
  const Point3 middle = middleOfSquare(4);
  const auto fineInTheMiddle = [&](const Point3& p) { return 0.05 + 0.2 * distance(p, middle); };
  const Expected eight(square, 16, 8, fineInTheMiddle), many(square, 16, 200, fineInTheMiddle);
  EXPECT_GT(eight.places, 64);
  EXPECT_NEAR(eight.elements / many.elements, 1, 0.5);
}

TEST(ExpectedElements, AreThoseOfThePlaceWhereAPlaneFaceIs) {
  std::vector<Point3> places;
  const Expected large(squareOf(4), 16, 8, [&](const Point3& p) {
    places.push_back(p);
    return 0.1;
  });
  EXPECT_NEAR(large.elements / elementsOfSize(0.1, 16), 1, 1e-9);
  Box3 around;
  for (const Point3& p : places) around.add(p);
  EXPECT_NEAR(distance(around.low, around.high), std::sqrt(2) * 3.5, 1e-3);
  const auto middleOf = [](const Box3& box) { return 0.5 * (box.low + box.high); };
  EXPECT_LT(distance(middleOf(around), middleOfSquare(4)), 1e-3);
}

}  // namespace
}  // namespace af2::geometry
