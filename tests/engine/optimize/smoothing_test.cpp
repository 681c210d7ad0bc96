// That vertices which sleep would not have moved, and the shape of rows.
#include "engine/optimize/smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/mesh/element_shape.h"
#include "engine/mesh/triangle_grades.h"
#include "tests/support/meshing.h"
#include "tests/support/quad_grid.h"

namespace af2 {
namespace {

using namespace af2::testing;

struct SmoothedDisc {
  FrontInput input;
  Mesh mesh;
  FlatMaker maker;

  SmoothedDisc() : input(discWithHole(.1)) {
    mesh = AF2Algorithm(triangleSet()).execute(maker, input, UniformSize(.1)).mesh;
  }
};

/// Until nothing moves, whoever looks.
void bringToRest(MeshTopology& topology, SmoothedDisc& c) {
  constexpr int kMax = 2000;
  for (int i = 0; i < kMax; ++i)
    if (VertexSmoother(topology, c.mesh, c.maker).sweep() == 0) return;
  FAIL() << "still moving";
}

Corner someInnerSide(const MeshTopology& topology) {
  const std::size_t last = topology.mesh().vertices.size() - 1;
  return topology.cornerOf(VertexId(last / 2 + topology.fixedCount() / 2));
}

/// Neighbours need not follow moves of a hundredth of an edge.
constexpr double kAsNear = 0.02 * .1;

TEST(Smoothing, AfterASwapWhoeverIsNotToldNeedNotLook) {
  SmoothedDisc c;
  MeshTopology topology(c.mesh, boundaryOf(c.input));
  bringToRest(topology, c);
  VertexSmoother asleep(topology, c.mesh, c.maker);
  EXPECT_EQ(asleep.sweep(), 0u);
  topology.swap(someInnerSide(topology));
  const std::vector<SurfacePoint> before = c.mesh.vertices;

  asleep.wake(topology.takeChanged());
  EXPECT_GT(asleep.sweep(), 0u);
  const std::vector<SurfacePoint> woken = c.mesh.vertices;
  double farthest = 0;
  for (std::size_t v = 0; v < woken.size(); ++v)
    farthest = std::max(farthest, distance(before[v].position, woken[v].position));
  EXPECT_GT(farthest, 2 * kAsNear);

  c.mesh.vertices = before;
  VertexSmoother(topology, c.mesh, c.maker).sweep();
  for (std::size_t v = 0; v < woken.size(); ++v)
    EXPECT_LT(distance(c.mesh.vertices[v].position, woken[v].position), kAsNear);
}

TEST(Smoothing, NobodyLooksWhereNothingWasToldOf) {
  SmoothedDisc c;
  MeshTopology topology(c.mesh, boundaryOf(c.input));
  bringToRest(topology, c);
  VertexSmoother asleep(topology, c.mesh, c.maker);
  asleep.sweep();
  topology.swap(someInnerSide(topology));
  EXPECT_EQ(asleep.sweep(), 0u);
}

TEST(Smoothing, LeavesNoGradesOfTrianglesThatItHasChanged) {
  SmoothedDisc c;
  MeshTopology topology(c.mesh, boundaryOf(c.input));
  VertexSmoother smoother(topology, c.mesh, c.maker);  // grades all
  EXPECT_GT(smoother.sweep(), 0u);
  MeshTopology fresh(c.mesh, boundaryOf(c.input));
  for (std::size_t e = 0; e < c.mesh.elements.size(); ++e)
    EXPECT_EQ(gradeOf(topology, e), gradeOf(fresh, e)) << e;
}

/// A square, and a vertex inside at some height above its lower side.
struct Square {
  FrontInput input;
  Mesh mesh;
  FlatMaker maker;

  explicit Square(double height) {
    const auto at = [](double x, double y) { return SurfacePoint{{x, y, 0}, {0, 0, 1}, x, y}; };
    mesh.vertices = {at(0, 0), at(1, 0), at(1, 1), at(0, 1), at(0.5, height)};
    input.vertexCount = 4;
    input.loops.emplace_back();
    for (std::uint32_t i = 0; i < 4; ++i) {
      input.loops[0].push_back({VertexId(i), mesh.vertices[i]});
      mesh.elements.push_back({{VertexId(i), VertexId((i + 1) % 4), VertexId(4), VertexId()}});
    }
    mesh.origins.assign(4, {});
  }
};

/// One that is all but flat takes more than small steps.
TEST(Smoothing, AThinElementIsMendedAtOnce) {
  constexpr double kFlat = 1e-4;
  Square square(kFlat);
  MeshTopology topology(square.mesh, boundaryOf(square.input));
  VertexSmoother smoother(topology, square.mesh, square.maker);
  const std::vector<VertexId> inside{VertexId(4)};
  EXPECT_EQ(smoother.mend(inside), 1u);
  EXPECT_GT(square.mesh.vertices[4].position.y, 0.1);
}

/// The upper side is shifted, so that columns lean. In the first row they lean less than in the
/// middle.
TEST(Smoothing, ColumnsStandMoreUprightOnTheBoundary) {
  constexpr int kSquares = 8;
  QuadGrid grid(kSquares);
  for (SurfacePoint& vertex : grid.mesh.vertices) vertex.position.x += 0.4 * vertex.position.y;
  MeshTopology topology(grid.mesh, boundaryOf(grid.input));
  const FlatMaker maker;
  VertexSmoother smoother(topology, grid.mesh, maker);
  for (int i = 0; i < 300; ++i) smoother.sweep();
  const auto lean = [&](int row) {
    const Point3 low = grid.mesh.vertices[grid.id(kSquares / 2, row).value].position;
    const Point3 high = grid.mesh.vertices[grid.id(kSquares / 2, row + 1).value].position;
    return (high.x - low.x) / (high.y - low.y);
  };
  EXPECT_GT(lean(0), 0);
  EXPECT_LT(lean(0), 0.5 * lean(kSquares / 2));
}

/// The sheet z = cosh(x), which bends more in its middle than beside it.
struct HangingSheet {
  static SurfacePoint at(double x, double y) {
    return {{x, y, std::cosh(x)}, unit(Point3{-std::sinh(x), 0, 1}), x, y};
  }
  /// The point at some length along the sheet from its middle.
  static SurfacePoint atLength(double s, double y) { return at(std::asinh(s), y); }

  /// A plane normal to the mean of the normals of an edge, and back along its normal.
  class Chart final : public AF2LocalTransform {
   public:
    Chart(const SurfacePoint& from, const SurfacePoint& to, double unit)
        : plane_(from, to, af2::unit(from.normal + to.normal), unit) {}
    ChartPoint transformFromSurface(const SurfacePoint& p) const override {
      return plane_.transformFromSurface(p);
    }
    std::optional<SurfacePoint> transformToSurface(Point2 p) const override {
      const SurfacePoint start = *plane_.transformToSurface(p);
      Point3 place = start.position;
      for (int i = 0; i < 20; ++i) {
        const SurfacePoint below = at(place.x, place.y);
        const double height = dot(place - below.position, below.normal);
        place = place - (height / dot(start.normal, below.normal)) * start.normal;
      }
      return at(place.x, place.y);
    }

   private:
    PlaneChart plane_;
  };

  class Maker final : public ChartMaker<Maker> {
   public:
    static Chart chart(const SurfacePoint& from, const SurfacePoint& to, double unit) {
      return {from, to, unit};
    }
  };
};

/// Rows of triangles that are equilateral when the sheet is flattened.
struct RowsOnSheet {
  static constexpr std::uint32_t kColumns = 16, kRows = 8;
  Mesh mesh;
  MeshBoundary boundary{0, {}};
  HangingSheet::Maker maker;

  explicit RowsOnSheet(double size) {
    const auto isOnRim = [](std::uint32_t i, std::uint32_t j) {
      return i == 0 || j == 0 || i == kColumns || j == kRows;
    };
    std::vector<VertexId> ids((kColumns + 1) * (kRows + 1));
    for (const bool rim : {true, false}) {
      for (std::uint32_t j = 0; j <= kRows; ++j)
        for (std::uint32_t i = 0; i <= kColumns; ++i)
          if (isOnRim(i, j) == rim) {
            ids[i + (kColumns + 1) * j] = VertexId(mesh.vertices.size());
            mesh.vertices.push_back(HangingSheet::atLength(
                size * (i + 0.5 * j - 0.5 * kColumns - 0.25 * kRows), size * j * std::sqrt(0.75)));
          }
      if (rim) boundary.fixedCount = mesh.vertices.size();
    }
    const auto id = [&](std::uint32_t i, std::uint32_t j) { return ids[i + (kColumns + 1) * j]; };
    for (std::uint32_t j = 0; j < kRows; ++j)
      for (std::uint32_t i = 0; i < kColumns; ++i) {
        mesh.elements.push_back({{id(i, j), id(i + 1, j), id(i, j + 1), {}}});
        mesh.elements.push_back({{id(i + 1, j), id(i + 1, j + 1), id(i, j + 1), {}}});
      }
    mesh.origins.resize(mesh.elements.size());
  }

  double meanQuality() const {
    double sum = 0;
    for (const auto& [corners] : mesh.elements)
      sum +=
          1 / triangleDistortion(mesh.vertices[corners[0].value], mesh.vertices[corners[1].value],
                                 mesh.vertices[corners[2].value]);
    return sum / double(mesh.elements.size());
  }
};

/// Projected to planes that lean, edges are too short.
TEST(Smoothing, DoesNotDriftOnASurfaceThatBends) {
  RowsOnSheet sheet(0.5);
  MeshTopology topology(sheet.mesh, sheet.boundary);
  VertexSmoother smoother(topology, sheet.mesh, sheet.maker);
  for (const Element& element : sheet.mesh.elements) smoother.wake(element.vertices());
  const double before = sheet.meanQuality();
  for (int i = 0; i < 20; ++i) smoother.sweep();
  EXPECT_GT(sheet.meanQuality(), before - 1e-4);
}

TEST(Smoothing, LeavesVerticesBetweenEvenTrianglesAlone) {
  RowsOnSheet sheet(0.5);
  MeshTopology topology(sheet.mesh, sheet.boundary);
  EXPECT_EQ(VertexSmoother(topology, sheet.mesh, sheet.maker).sweep(), 0u);
  const std::size_t v = sheet.boundary.fixedCount + 20;
  sheet.mesh.vertices[v] =
      HangingSheet::at(sheet.mesh.vertices[v].u + 0.1, sheet.mesh.vertices[v].v);
  MeshTopology moved(sheet.mesh, sheet.boundary);
  EXPECT_GT(VertexSmoother(moved, sheet.mesh, sheet.maker).sweep(), 0u);
}

/// A vertex away from the middle of a polygon, between triangles to its corners.
struct Wheel {
  Mesh mesh;
  MeshBoundary boundary;
  FlatMaker maker;

  explicit Wheel(std::size_t spokes) {
    for (std::size_t i = 0; i < spokes; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(spokes);
      mesh.vertices.push_back({{std::cos(angle), std::sin(angle), 0}, {0, 0, 1}});
      mesh.elements.push_back(
          {{VertexId(i), VertexId((i + 1) % spokes), VertexId(spokes), VertexId()}});
    }
    boundary.fixedCount = spokes;
    mesh.vertices.push_back({{0.3, 0.1, 0}, {0, 0, 1}});
    mesh.origins.resize(spokes);
  }
};

/// TriangleStar has room for some triangles only.
TEST(Smoothing, MovesAVertexBetweenAnyNumberOfTriangles) {
  for (const std::size_t spokes : {3u, 4u, 5u, 15u, 16u, 17u, 18u, 40u}) {
    Wheel wheel(spokes);
    MeshTopology topology(wheel.mesh, wheel.boundary);
    VertexSmoother smoother(topology, wheel.mesh, wheel.maker);
    for (int i = 0; i < 20; ++i) smoother.sweep();
    EXPECT_LT(length(wheel.mesh.vertices.back().position), 0.02) << spokes;
  }
}

}  // namespace
}  // namespace af2
