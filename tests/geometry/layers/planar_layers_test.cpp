#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <random>

#include "engine/base/error.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/mesh/fingerprint.h"
#include "geometry/planar/mesh_planar.h"
#include "tests/geometry/layers/layers.h"
#include "tests/geometry/planar/poly_text.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using Loop = std::vector<Point2>;
using std::numbers::pi;

/// Closed loops; segments are numbered one after the other, and each loop is a boundary.
PlanarDomain domainOf(const std::vector<Loop>& loops, const std::vector<Point2>& holes = {},
                      const std::vector<Loop>& lines = {}) {
  PlanarDomain domain;
  domain.name = "test";
  domain.holes = holes;
  int marker = 0;
  const auto add = [&](const Loop& points, bool isClosed) {
    const int first = static_cast<int>(domain.points.size()),
              count = static_cast<int>(points.size());
    domain.points.insert(domain.points.end(), points.begin(), points.end());
    ++marker;
    for (int i = 0; i < count - (isClosed ? 0 : 1); ++i) {
      PlanarDomain::Segment segment;
      segment.from = first + i;
      segment.to = first + (i + 1) % count;
      segment.edge = static_cast<int>(domain.segments.size()) + 1;
      segment.marker = marker;
      domain.segments.push_back(segment);
    }
  };
  for (const Loop& loop : loops) add(loop, true);
  for (const Loop& line : lines) add(line, false);
  return domain;
}

double distanceToSegment(Point2 p, Point2 a, Point2 b) {
  const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return distance(p, a + t * (b - a));
}

double distanceToBoundary(const Point3& p, const PlanarDomain& domain) {
  double least = 1e300;
  for (const PlanarDomain::Segment& segment : domain.segments)
    least = std::min(
        least, distanceToSegment({p.x, p.y}, domain.points[static_cast<std::size_t>(segment.from)],
                                 domain.points[static_cast<std::size_t>(segment.to)]));
  return least;
}

const Loop kRectangle{{0, 0}, {10, 0}, {10, 6}, {0, 6}};

class PlanarLayers : public ::testing::Test {
 protected:
  AF2Algorithm algorithm{testing::triangleSet()};
  MeshingOptions options;

  ModelMesh mesh(const PlanarDomain& domain) { return meshPlanar(domain, algorithm, options); }

  /// Complete, of exactly this area, without inverted elements.
  ModelMesh sound(const PlanarDomain& domain, double area) {
    ModelMesh result = mesh(domain);
    testing::expectComplete(result);
    EXPECT_NEAR(testing::areaWithQuads(result), area, 1e-9 * area);
    EXPECT_EQ(testing::invertedIn(result), 0u);
    return result;
  }

  /// All corners of layers are as far from the boundary as the tops of layers.
  static void expectHeights(const ModelMesh& result, const PlanarDomain& domain,
                            const LayerRequest& request, double tolerance = 1e-9) {
    const std::vector<double> tops = testing::topsOf(request);
    for (const VertexId v : testing::layerVertices(result)) {
      const Point3& p = result.vertices[v.value];
      EXPECT_TRUE(testing::isTop(distanceToBoundary(p, domain), tops, tolerance))
          << "(" << p.x << ", " << p.y << "): " << distanceToBoundary(p, domain);
    }
  }

  /// All corners of layers are at some share of the heights of tops of layers, at least `least`.
  static void expectSharesOfHeights(const ModelMesh& result, const PlanarDomain& domain,
                                    const LayerRequest& request, double least) {
    const std::vector<double> tops = testing::topsOf(request);
    for (const VertexId v : testing::layerVertices(result)) {
      const Point3& p = result.vertices[v.value];
      const double away = distanceToBoundary(p, domain);
      EXPECT_TRUE(std::ranges::any_of(
          tops, [&](double top) { return away <= top + 1e-9 && away >= least * top - 1e-9; }))
          << "(" << p.x << ", " << p.y << "): " << away;
    }
  }

  LayerRequest wall(double first, double growth, int count) {
    LayerRequest request = testing::layersAlong({}, first, growth, count);
    request.faces = {1};
    return request;
  }
};

TEST_F(PlanarLayers, EndOnTheSidesBesideTheirEdge) {
  options.sizes.size = 0.7;
  const LayerRequest request = testing::layersAlong({1}, 0.05, 1.3, 6);
  options.layers = {request};
  const ModelMesh result = sound(domainOf({kRectangle}), 60);
  const std::vector<double> tops = testing::topsOf(request);
  std::size_t onLeft = 0;
  for (const VertexId v : testing::layerVertices(result)) {
    const Point3& p = result.vertices[v.value];
    EXPECT_TRUE(testing::isTop(p.y, tops, 1e-12)) << p.y;
    if (p.x == 0) ++onLeft;
  }
  EXPECT_EQ(onLeft, tops.size());
  ASSERT_EQ(result.faces[0].layers.size(), 1u);
  const LayersAlongEdge& along = result.faces[0].layers[0];
  EXPECT_EQ(along.edge, 1);
  EXPECT_EQ(along.fewest, 6u);
  EXPECT_EQ(along.most, 6u);
  EXPECT_EQ(along.fewer, 0u);
  EXPECT_EQ(testing::layerElements(result), 6 * along.segments);
}

TEST_F(PlanarLayers, HaveTheirHeightsAtConvexCorners) {
  options.sizes.size = 0.7;
  const LayerRequest request = wall(0.05, 1.3, 6);
  options.layers = {request};
  const PlanarDomain domain = domainOf({kRectangle});
  const ModelMesh result = sound(domain, 60);
  expectHeights(result, domain, request);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(testing::layerTriangles(result), 0u);
}

TEST_F(PlanarLayers, GoAroundReflexCornersInFans) {
  options.sizes.size = 0.6;
  const LayerRequest request = wall(0.05, 1.3, 8);
  options.layers = {request};
  const PlanarDomain domain = domainOf({{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}});
  const ModelMesh result = sound(domain, 64);
  expectHeights(result, domain, request);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(testing::layerTriangles(result), 0u);
}

TEST_F(PlanarLayers, GoAroundHolesAndLinesInside) {
  options.sizes.size = 0.4;
  Loop hole;
  for (int i = 0; i < 30; ++i)
    hole.push_back({3 + std::cos(-2 * pi * i / 30), 3 + std::sin(-2 * pi * i / 30)});
  const PlanarDomain domain = domainOf({kRectangle, hole}, {{3, 3}}, {{{6, 2}, {8, 4}}});
  LayerRequest request = testing::layersAlong({}, 0.02, 1.25, 7);
  request.edgeNames = {"boundary 2", "boundary 3"};
  options.layers = {request};
  const ModelMesh result = sound(domain, 60 - 30 * std::sin(2 * pi / 30) / 2);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  // At the corners of the hole, heights above its segments are as asked.
  expectHeights(result, domain, request, 0.002);
}

TEST_F(PlanarLayers, BecomeFewerBetweenOppositeSides) {
  options.sizes.size = 0.3;
  const LayerRequest request = wall(0.02, 1.3, 8);
  options.layers = {request};
  const PlanarDomain domain = domainOf({{{0, 0}, {10, 0}, {10, 0.4}, {0, 0.4}}});
  const ModelMesh result = sound(domain, 4);
  expectSharesOfHeights(result, domain, request, kThinnest);
  for (const LayersAlongEdge& along : result.faces[0].layers) {
    EXPECT_LT(along.most, 8u);
    EXPECT_GT(along.most, 2u);
    EXPECT_EQ(along.fewer, along.segments);
    EXPECT_EQ(along.thinner, along.segments);
    EXPECT_GE(along.thinnest, kThinnest);
    EXPECT_LE(along.thinnest, kThinnest / 0.9);
  }
}

TEST_F(PlanarLayers, BecomeThinnerBetweenOppositeSidesBeforeTheyBecomeFewer) {
  options.sizes.size = 0.3;
  const LayerRequest request = wall(0.02, 1.3, 8);
  options.layers = {request};
  const double width = 0.8;
  const PlanarDomain domain = domainOf({{{0, 0}, {10, 0}, {10, width}, {0, width}}});
  const ModelMesh result = sound(domain, 10 * width);
  const double most = width / 2 / 1.25 / testing::topsOf(request).back();  // there is a gap
  expectSharesOfHeights(result, domain, request, 0.75 * most);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(testing::layerTriangles(result), 0u);
  for (const LayersAlongEdge& along : result.faces[0].layers) {
    EXPECT_EQ(along.thinner, along.segments);
    EXPECT_LE(along.thinnest, most);
    EXPECT_GE(along.thinnest, 0.75 * most);
  }
}

TEST_F(PlanarLayers, AreThinnerOnlyNearNarrowPlaces) {
  options.sizes.size = 0.3;
  const LayerRequest request = testing::layersAlong({1}, 0.1, 1.2, 5);
  options.layers = {request};
  const PlanarDomain domain =
      domainOf({{{0, 0}, {12, 0}, {12, 4}, {7, 4}, {6, 0.6}, {5, 4}, {0, 4}}});
  const ModelMesh result = mesh(domain);
  testing::expectComplete(result);
  EXPECT_EQ(testing::invertedIn(result), 0u);
  const std::vector<double> tops = testing::topsOf(request);
  std::size_t far = 0;
  for (const VertexId v : testing::layerVertices(result)) {
    const Point3& p = result.vertices[v.value];
    EXPECT_LT(p.y, tops.back() + 1e-9);
    if (std::abs(p.x - 6) < 4) continue;
    EXPECT_TRUE(testing::isTop(p.y, tops, 1e-9)) << p.x << " " << p.y;
    ++far;
  }
  EXPECT_GE(far, 40u);
  const LayersAlongEdge& along = result.faces[0].layers.at(0);
  EXPECT_EQ(along.fewer, 0u);
  EXPECT_GT(along.thinner, 0u);
  EXPECT_LT(along.thinnest, 0.7);
  EXPECT_NEAR(along.place.x, 6, 1);
}

TEST_F(PlanarLayers, ThatEndOnShortSidesAreThinnerThere) {
  options.sizes.size = 0.5;
  const LayerRequest request = testing::layersAlong({1, 3}, 0.1, 1.3, 5);
  options.layers = {request};
  const double width = 1.5;
  const PlanarDomain domain = domainOf({{{0, 0}, {10, 0}, {10, width}, {0, width}}});
  const ModelMesh result = sound(domain, 10 * width);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  EXPECT_EQ(testing::layerTriangles(result), 0u);
  std::vector<double> tops = testing::topsOf(request);
  const double share = 0.4 * width / tops.back();  // layers take up 40 % of the side each
  std::size_t onSide = 0;
  for (double& top : tops) top *= share;
  for (const VertexId v : testing::layerVertices(result)) {
    const Point3& p = result.vertices[v.value];
    if (p.x == 0 && p.y < width / 2) onSide += testing::isTop(p.y, tops, 1e-9) ? 1 : 0;
  }
  EXPECT_EQ(onSide, tops.size());
}

TEST_F(PlanarLayers, BecomeFewerTowardsASharpCorner) {
  options.sizes.size = 0.4;
  const LayerRequest request = wall(0.02, 1.3, 8);
  options.layers = {request};
  const PlanarDomain domain = domainOf({{{0, 0}, {10, 0}, {10, 2}}});
  const ModelMesh result = sound(domain, 10);
  expectSharesOfHeights(result, domain, request, kThinnest);
  EXPECT_EQ(result.faces[0].layers[0].fewest, 0u);
  EXPECT_EQ(result.faces[0].layers[0].most, 8u);
}

TEST_F(PlanarLayers, BecomeFewerOneByOneWhereTheBoundaryGoesStraightOn) {
  options.sizes.size = 0.5;
  options.layers = {testing::layersAlong({1}, 0.05, 1.2, 5)};
  const PlanarDomain domain = domainOf({{{0, 0}, {5, 0}, {10, 0}, {10, 6}, {0, 6}}});
  const ModelMesh result = sound(domain, 60);
  const LayersAlongEdge& along = result.faces[0].layers.at(0);
  EXPECT_EQ(along.fewest, 0u);
  EXPECT_EQ(along.most, 5u);
  EXPECT_EQ(along.fewer, 5u);
}

TEST_F(PlanarLayers, KeepRegionsConforming) {
  options.sizes.size = 0.5;
  LayerRequest request = testing::layersAlong({1}, 0.04, 1.3, 6);
  options.layers = {request};
  const PlanarDomain domain =
      domainOf({{{0, 0}, {5, 0}, {10, 0}, {10, 6}, {5, 6}, {0, 6}}}, {}, {{{5, 0}, {5, 6}}});
  const ModelMesh result = sound(domain, 60);
  ASSERT_EQ(result.faces.size(), 2u);
  EXPECT_EQ(testing::segmentsWithFewer(result), 0u);
  std::set<VertexId> atWall;  // between the regions, at heights of layers
  for (std::size_t e = 0; e < result.elements.size(); ++e)
    for (const VertexId v : result.elements[e].vertices()) {
      const Point3& p = result.vertices[v.value];
      if (result.face[e] == 2 && p.x == 5 && testing::isTop(p.y, testing::topsOf(request), 1e-12))
        atWall.insert(v);
    }
  EXPECT_EQ(atWall.size(), 7u);
}

TEST_F(PlanarLayers, OfARequestForOneFaceAreNotOnTheOther) {
  options.sizes.size = 0.5;
  LayerRequest request = testing::layersAlong({7}, 0.04, 1.3, 4);
  request.faces = {2};
  options.layers = {request};
  const PlanarDomain domain =
      domainOf({{{0, 0}, {5, 0}, {10, 0}, {10, 6}, {5, 6}, {0, 6}}}, {}, {{{5, 0}, {5, 6}}});
  const ModelMesh result = sound(domain, 60);
  EXPECT_EQ(result.faces[0].layerElements, 0u);
  EXPECT_GT(result.faces[1].layerElements, 0u);
}

TEST_F(PlanarLayers, OfALaterRequestReplaceThoseOfAnEarlierOne) {
  options.sizes.size = 0.7;
  options.layers = {wall(0.05, 1.3, 6), testing::layersAlong({1}, 0.1, 1, 2)};
  const ModelMesh result = sound(domainOf({kRectangle}), 60);
  EXPECT_EQ(result.faces[0].layers.at(0).asked, 2u);
  EXPECT_EQ(result.faces[0].layers.at(1).asked, 6u);
}

/// A polygon around the origin with corners at random distances.
Loop star(std::mt19937& random, int corners) {
  std::uniform_real_distribution<double> radius(1, 3);
  Loop loop;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners, r = radius(random);
    loop.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return loop;
}

double areaOf(const Loop& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    area += cross(loop[i], loop[(i + 1) % loop.size()]) / 2;
  return area;
}

TEST_F(PlanarLayers, AreSoundInRandomPolygons) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Loop loop = star(random, 5 + trial % 14);
    options.sizes.size = trial % 3 == 0 ? 0.5 : 0.2;
    options.layers = {wall(trial % 2 == 0 ? 0.01 : 0.1, 1.3, 8)};
    const PlanarDomain domain = domainOf({loop});
    const ModelMesh result = sound(domain, areaOf(loop));
    EXPECT_GT(testing::layerElements(result), 0u);
  }
}

TEST_F(PlanarLayers, AreAllOfQuadrilateralsWithRulesForThese) {
  options.sizes.size = 0.5;
  options.quads.onlyQuads = true;
  options.evenLoops = true;
  options.layers = {wall(0.05, 1.2, 5)};
  const ModelMesh result = sound(domainOf({kRectangle}), 60);
  EXPECT_TRUE(std::ranges::all_of(result.elements, &Element::isQuad));
}

TEST_F(PlanarLayers, RefuseWhatIsNotPossible) {
  options.sizes.size = 0.5;
  const auto messageFor = [&](auto&& change) {
    options.layers = {testing::layersAlong({1}, 0.05, 1.2, 5)};
    change(options.layers[0]);
    return testing::messageOf([&] { mesh(domainOf({kRectangle})); });
  };
  EXPECT_EQ(messageFor([](LayerRequest&) {}), "no error");
  EXPECT_EQ(messageFor([](LayerRequest& r) { r.edges = {5}; }),
            "layers: there is no edge 5; the model has edges 1 to 4");
  EXPECT_EQ(messageFor([](LayerRequest& r) { r.faces = {2}; }),
            "layers: there is no face 2; the model has faces 1 to 1");
  EXPECT_NE(messageFor([](LayerRequest& r) { r.edgeNames = {"inlet"}; }).find("'inlet'"),
            std::string::npos);
  EXPECT_NE(messageFor([](LayerRequest& r) { r.faceNames = {"lid"}; }).find("'lid'"),
            std::string::npos);
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    EXPECT_NE(messageFor([&](LayerRequest& r) { r.first = wrong; }).find("greater than 0"),
              std::string::npos);
    EXPECT_NE(messageFor([&](LayerRequest& r) { r.growth = wrong; }).find("greater than 0"),
              std::string::npos);
  }
  EXPECT_NE(messageFor([](LayerRequest& r) { r.count = 0; }), "no error");
  EXPECT_NE(messageFor([](LayerRequest& r) { r.count = kMaxLayers + 1; }), "no error");
  EXPECT_NE(messageFor([](LayerRequest& r) {
              r.growth = 4;
              r.count = 20;
            }).find("high together"),
            std::string::npos);
  EXPECT_NE(messageFor([](LayerRequest& r) { r.edges = {}; }), "no error");
}

TEST_F(PlanarLayers, ThatHaveNoRoomAreReported) {
  options.sizes.size = 0.5;
  options.layers = {wall(8, 1, 1)};
  const ModelMesh result = mesh(domainOf({kRectangle}));
  EXPECT_EQ(testing::layerElements(result), 0u);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_NE(result.findings[0].find("no room"), std::string::npos);
  EXPECT_NEAR(testing::areaWithQuads(result), 60, 1e-9);
}

}  // namespace
}  // namespace af2::geometry
