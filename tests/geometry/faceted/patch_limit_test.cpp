#include "geometry/faceted/patch_limit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/domain/domain_division.h"
#include "geometry/faceted/mesh_faceted.h"
#include "tests/geometry/faceted/sheets.h"

namespace af2::geometry {
namespace {

using testing::Closed;
using testing::grid;

/// A sheet with a sharp ridge and waves across it on one side; the other side is plane.
Facets wavesBesideAPlane() {
  return grid(30, 30, Closed::InNeither, [](std::uint32_t i, std::uint32_t j) {
    const double x = i / 10.0, y = j / 10.0, beyond = x - 1.5;
    if (beyond <= 0) return Point3{x, y, x};
    return Point3{x, y, 1.5 - beyond + 0.2 * beyond * std::sin(2 * beyond) * std::cos(3 * y)};
  });
}

TEST(CurvatureLimits, AlongCurvesAreThoseOfTheFacesBesideThem) {
  MeshingOptions options;
  options.sizes.size = 0.4;
  options.sizes.elementsPerTurn = 20;
  const DomainModel model = facetedModel(wavesBesideAPlane(), options);
  const CurvatureLimits limits = model.curvatureLimits(DomainSize(options.sizes));
  ASSERT_EQ(limits.atKnots.size(), model.curves.size());
  int curved = 0, plane = 0;
  double least = 1e300, largest = 0;
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    const DomainCurve& curve = model.curves[c];
    std::vector<const CurvatureLimit*> beside;
    for (std::size_t f = 0; f < model.faces.size(); ++f)
      for (const auto& loop : model.faces[f].loops)
        for (const CurveUse& use : loop)
          if (use.curve == c && limits.ofFaces[f]) beside.push_back(limits.ofFaces[f].get());
    const std::vector<double>& at = limits.atKnots[c];
    ASSERT_EQ(at.size(), beside.empty() ? 0 : curve.knots.size());
    ++(beside.empty() ? plane : curved);
    for (const CurvatureLimit* face : beside)
      for (std::size_t k = 0; k < at.size(); ++k) {
        EXPECT_NEAR(face->sizeAt({curve.pointAt(curve.knots[k]), {}, 0, 0}), at[k], 1e-9 * at[k]);
        least = std::min(least, at[k]);
        largest = std::max(largest, at[k]);
        if (k == 0) continue;
        const double middle = 0.5 * (curve.knots[k - 1] + curve.knots[k]);
        EXPECT_NEAR(face->sizeAt({curve.pointAt(middle), {}, 0, 0}), 0.5 * (at[k - 1] + at[k]),
                    1e-9 * at[k]);
      }
  }
  EXPECT_GT(curved, 0);
  EXPECT_GT(plane, 0);
  EXPECT_LT(1.2 * least, largest) << "limits that are all the same would prove nothing";
}

TEST(CurvatureLimits, AlongCurvesDivideThemAsThoseOfTheFaces) {
  MeshingOptions options;
  options.sizes.size = 0.4;
  options.sizes.elementsPerTurn = 20;
  const DomainModel model = facetedModel(wavesBesideAPlane(), options);
  const DomainSize byPosition(options.sizes);
  DomainSizes sizes{byPosition,
                    std::vector<double>(model.faces.size(), options.sizes.size),
                    {},
                    nullptr,
                    model.curvatureLimits(byPosition)};
  const DividedEdges byKnots = divideCurves(model, sizes, options.sizes.growth, {});
  sizes.byCurvature.atKnots.clear();
  const DividedEdges byFaces = divideCurves(model, sizes, options.sizes.growth, {});
  ASSERT_EQ(byKnots.points.size(), byFaces.points.size());
  EXPECT_GT(byKnots.points.size(), 2 * model.corners.size());
  for (std::size_t i = 0; i < byKnots.points.size(); ++i)
    EXPECT_LT(distance(byKnots.points[i], byFaces.points[i]), 1e-9);
}

}  // namespace
}  // namespace af2::geometry
