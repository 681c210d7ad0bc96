#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>

#include <functional>
#include <numbers>

#include "geometry/mesh/fingerprint.h"
#include "geometry/occ/inspect/edge_list.h"
#include "tests/geometry/layers/layers.h"
#include "tests/geometry/occ/meshing.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;
using testing::expectComplete;
using testing::layerVertices;

/// Edges of a face by a property of their middle.
std::vector<int> edgesAt(const Model& model, const std::function<bool(const Point3&)>& isWanted) {
  std::vector<int> edges;
  for (const EdgeEntry& edge : edgesOf(model))
    if (isWanted(0.5 * (edge.from + edge.to))) edges.push_back(edge.id);
  return edges;
}

ModelMesh withLayers(const Model& model, double size, const LayerRequest& request,
                     int threads = 1) {
  MeshingOptions options = testing::ofSize(size);
  options.layers = {request};
  options.threads = threads;
  return testing::mesh(model, options);
}

/// Corners of elements that turn against the normal of their element.
std::size_t foldedLayers(const ModelMesh& mesh) {
  std::size_t folded = 0;
  for (const Element& element : mesh.elements) {
    const auto corners = element.vertices();
    const auto at = [&](std::size_t i) { return mesh.vertices[corners[i % corners.size()].value]; };
    const Point3 normal = cross(at(2) - at(0), element.isQuad() ? at(3) - at(1) : at(2) - at(1));
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (!(dot(cross(at(i + 1) - at(i), at(i + 2) - at(i + 1)), normal) > 0)) ++folded;
  }
  return folded;
}

TEST(Layers, OnThePlaneFacesOfABoxKeepItClosed) {
  const Model box = testing::box(4, 5, 6);
  const std::vector<int> edges =
      edgesAt(box, [](const Point3& p) { return p.z == 0 && (p.x == 0 || p.y == 0); });
  ASSERT_EQ(edges.size(), 2u);
  const LayerRequest request = testing::layersAlong(edges, 0.03, 1.3, 6);
  const ModelMesh result = withLayers(box, 0.5, request);
  expectComplete(result);
  EXPECT_NEAR(testing::areaWithQuads(result), 2 * (20 + 24 + 30), 1e-9);
  EXPECT_EQ(foldedLayers(result), 0u);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(testing::layerTriangles(result), 0u);
  const std::vector<double> tops = testing::topsOf(request);
  for (const VertexId v : layerVertices(result)) {
    const Point3& p = result.vertices[v.value];
    // In each plane, the distance from the nearer one of the two edges.
    const double toX = std::hypot(p.x, p.z), toY = std::hypot(p.y, p.z);
    EXPECT_TRUE(testing::isTop(std::min(toX, toY), tops, 1e-9)) << p.x << " " << p.y << " " << p.z;
  }
  for (const EdgeSegment& segment : result.segments) EXPECT_EQ(segment.uses, 2);
}

TEST(Layers, OnACylinderEndOnItsSeam) {
  const Model cylinder = testing::cylinder(1, 3);
  const std::vector<int> rim = edgesAt(cylinder, [](const Point3& p) { return p.z == 0; });
  ASSERT_EQ(rim.size(), 1u);
  const LayerRequest request = testing::layersAlong(rim, 0.02, 1.25, 6);
  const ModelMesh result = withLayers(cylinder, 0.25, request);
  expectComplete(result);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(foldedLayers(result), 0u);
  const std::vector<double> tops = testing::topsOf(request);
  for (std::size_t e = 0; e < result.elements.size(); ++e) {
    if (!testing::isOfLayer(result, e)) continue;
    for (const VertexId v : result.elements[e].vertices()) {
      const Point3& p = result.vertices[v.value];
      const double radius = std::hypot(p.x, p.y);
      if (p.z == 0 && radius < 1 - 1e-9) {
        // The distance from the chords is as asked; that from the circle is larger by their sag.
        EXPECT_TRUE(testing::isTop(1 - radius, tops, 0.004)) << radius;
      } else {
        EXPECT_NEAR(radius, 1, 1e-12);
        EXPECT_TRUE(testing::isTop(p.z, tops, 1e-9)) << p.z;
      }
    }
  }
}

TEST(Layers, OnASphericalCapLieOnIt) {
  const Model hemisphere = testing::modelOf(
      BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 2), 0, 2 * pi, 0, pi / 2).Shape());
  const std::vector<int> rim =
      edgesAt(hemisphere, [](const Point3& p) { return std::abs(p.z) < 1e-9; });
  ASSERT_EQ(rim.size(), 1u);
  const LayerRequest request = testing::layersAlong(rim, 0.05, 1.3, 5);
  const ModelMesh result = withLayers(hemisphere, 0.3, request);
  expectComplete(result);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(foldedLayers(result), 0u);
  const std::vector<double> tops = testing::topsOf(request);
  for (const VertexId v : layerVertices(result)) {
    const Point3& p = result.vertices[v.value];
    EXPECT_NEAR(length(p), 2, 1e-9);
    EXPECT_TRUE(testing::isTop(2 * std::asin(p.z / 2), tops, 2e-3)) << p.z;  // along the surface
  }
}

/// A wavy square of 3 x 3 over the plane.
Model wavySquare() {
  TColgp_Array2OfPnt poles(1, 5, 1, 5);
  for (int i = 1; i <= 5; ++i)
    for (int k = 1; k <= 5; ++k)
      poles(i, k) = gp_Pnt(0.75 * (i - 1), 0.75 * (k - 1), (i + k) % 2 == 0 ? 0.4 : 0);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger multiplicities(1, 3);
  for (int i = 1; i <= 3; ++i) {
    knots(i) = i - 1;
    multiplicities(i) = i == 2 ? 1 : 4;
  }
  const Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
  return testing::modelOf(BRepBuilderAPI_MakeFace(surface, 1e-6).Shape());
}

TEST(Layers, AroundASplineFaceAreSound) {
  const Model square = wavySquare();
  LayerRequest request = testing::layersAlong({}, 0.02, 1.3, 7);
  request.faces = {1};
  const ModelMesh result = withLayers(square, 0.25, request);
  expectComplete(result);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(foldedLayers(result), 0u);
  EXPECT_EQ(result.faces[0].layers.size(), 4u);
  EXPECT_NEAR(testing::areaWithQuads(result), result.faces[0].area, 0.02 * result.faces[0].area);
}

TEST(Layers, AreTheSameForAllThreadCounts) {
  const Model box = testing::box(4, 5, 6);
  LayerRequest request = testing::layersAlong({}, 0.03, 1.3, 6);
  request.faces = {1, 2, 3};
  const std::string once = fingerprint(withLayers(box, 0.5, request, 1));
  for (const int threads : {2, 5})
    EXPECT_EQ(fingerprint(withLayers(box, 0.5, request, threads)), once);
}

TEST(Layers, OfSecondOrderHaveMiddlesOnTheSurface) {
  const Model cylinder = testing::cylinder(1, 3);
  MeshingOptions options = testing::ofSize(0.3);
  options.order = 2;
  LayerRequest request = testing::layersAlong({}, 0.03, 1.3, 5);
  request.faces = {1, 2, 3};
  options.layers = {request};
  const ModelMesh result = testing::mesh(cylinder, options);
  expectComplete(result);
  EXPECT_EQ(result.midsides.size(), result.elements.size());
  EXPECT_GT(testing::layerElements(result), 0u);
}

}  // namespace
}  // namespace af2::geometry
