// Edges of a face that lie on each other along a part of their length only.
#include "geometry/occ/edges/touching_edges.h"

#include <gtest/gtest.h>
#include <gp_Circ.hxx>

#include <map>

#include "geometry/occ/edges/edge_division.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using testing::expectComplete;
using testing::leastAngle;
using testing::mesh;

/// Faces of the plane z = 0 that share the vertices and edges between them.
class Sheets {
 public:
  explicit Sheets(const std::vector<gp_Pnt>& corners) {
    for (const gp_Pnt& corner : corners)
      vertices_.push_back(BRepBuilderAPI_MakeVertex(corner).Vertex());
    BRep_Builder().MakeCompound(all_);
  }

  /// Counterclockwise.
  void add(const std::vector<std::size_t>& corners) {
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t i = 0; i < corners.size(); ++i)
      builder.Add(wire, edge(corners[i], corners[(i + 1) % corners.size()]));
    TopoDS_Face face;
    builder.MakeFace(face, new Geom_Plane(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1}))), 1e-7);
    builder.Add(face, wire);
    builder.Add(all_, face);
  }

  Model model() const { return testing::modelOf(all_); }

 private:
  TopoDS_Shape edge(std::size_t from, std::size_t to) {
    const auto [made, isNew] = edges_.try_emplace(std::minmax(from, to));
    if (isNew) {
      const auto [low, high] = made->first;
      made->second = BRepBuilderAPI_MakeEdge(vertices_[low], vertices_[high]).Edge();
    }
    return from < to ? made->second : made->second.Reversed();
  }

  std::vector<TopoDS_Vertex> vertices_;
  std::map<std::pair<std::size_t, std::size_t>, TopoDS_Shape> edges_;
  TopoDS_Compound all_;
};

std::size_t segmentsWith(const ModelMesh& mesh, int uses) {
  std::map<std::pair<VertexId, VertexId>, int> all;
  for (const EdgeSegment& s : mesh.segments) all[std::minmax(s.from, s.to)] += s.uses;
  return static_cast<std::size_t>(
      std::ranges::count_if(all, [&](const auto& segment) { return segment.second == uses; }));
}

/// The face in the middle, of 2 by 2, ends in a needle; the others lie beside that.
Model needle(double width) {
  Sheets sheets({{0, 0, 0},
                 {7, 0, 0},
                 {7, 2, 0},
                 {5, 2, 0},
                 {5, width, 0},
                 {0, 2, 0},
                 {0, -2, 0},
                 {7, -2, 0}});
  sheets.add({0, 1, 2, 3, 4});
  sheets.add({6, 7, 1, 0});
  sheets.add({0, 4, 3, 5});
  return sheets.model();
}

/// Nothing is left of it but a corner at its wide end.
TEST(TouchingEdges, AFaceThatIsANeedleIsLeftOut) {
  Sheets sheets({{0, 0, 0}, {0.8, 0, 0}, {0.8006, 0.0006, 0}, {0.8, -1, 0}, {0, -1, 0}, {0, 1, 0}});
  sheets.add({0, 1, 2});
  sheets.add({4, 3, 1, 0});
  sheets.add({0, 2, 5});
  const ModelMesh result = mesh(sheets.model(), 0.5);
  expectComplete(result, 1.2, 1e-3);
  EXPECT_GT(leastAngle(result), 10);
}

/// No division of the edges opens an angle of a thousandth of a degree.
TEST(TouchingEdges, ANeedleThatCannotBeSeenIsClosed) {
  const ModelMesh result = mesh(needle(1e-4), 1.3);
  expectComplete(result, 28, 1e-4);
  EXPECT_GT(leastAngle(result), 15);
  EXPECT_EQ(segmentsWith(result, 1), segmentsWith(mesh(needle(0.5), 1.3), 1)) << "a hole";
  ASSERT_EQ(result.faces[0].attempts.size(), 1u);
  EXPECT_NE(result.faces[0].attempts[0].find("coincide within 0.0001"), std::string::npos)
      << result.faces[0].attempts[0];
}

/// Parts of the sides of the needle cancel each other, and the faces beside it share the others.
TEST(TouchingEdges, ArePartsOfEvenLoops) {
  int odd = 0;
  for (const double size : {0.4, 0.55, 0.7, 0.9, 1.3}) {
    MeshingOptions options = testing::ofSize(size);
    for (const FaceReport& face : mesh(needle(1e-4), options).faces)
      odd += static_cast<int>(face.oddLoops.size());
    options.evenLoops = true;
    const ModelMesh result = mesh(needle(1e-4), options);
    expectComplete(result, 28, 1e-4);
    for (const FaceReport& face : result.faces) EXPECT_TRUE(face.oddLoops.empty()) << size;
  }
  EXPECT_GT(odd, 0);
}

TEST(TouchingEdges, ANeedleThatCanBeSeenStays) {
  const ModelMesh result = mesh(needle(0.05), 1.3);
  expectComplete(result, 28, 1e-4);
  EXPECT_TRUE(result.faces[0].attempts.empty());
  EXPECT_LT(leastAngle(result), 0.6);
}

/// Two half circles, one a little beside the other, with lines between their ends that run on as
/// the circles do: at its tips the outer circle leaves such a line at an angle of zero.
TEST(TouchingEdges, ATipAtWhichALineTouchesAnArcIsClosedUpToWhereItOpens) {
  constexpr double kBeside = 0.02, kArcRadius = 1.25;
  const gp_Pnt a(0, kArcRadius, 0), b(0, -kArcRadius, 0);
  const gp_Pnt c(-kBeside, kArcRadius, 0), d(-kBeside, -kArcRadius, 0);
  const auto arc = [](const gp_Pnt& centre, const gp_Pnt& from, const gp_Pnt& to) {
    return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, {0, 0, 1}), kArcRadius), from, to).Edge();
  };
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(a, c), arc({-kBeside, 0, 0}, c, d),
                               BRepBuilderAPI_MakeEdge(d, b));
  wire.Add(TopoDS::Edge(arc({0, 0, 0}, a, b).Reversed()));
  const ModelMesh result = mesh(testing::plane({wire.Wire()}), 2.4);
  expectComplete(result, 2 * kArcRadius * kBeside, 0.05);
  EXPECT_GT(leastAngle(result), 0.6);
  EXPECT_FALSE(result.faces[0].attempts.empty());
}

/// The sides of a frame, 0.2 wide, with a narrow place between them that is no part of any edge.
TEST(TouchingEdges, APlaceWithoutWidthDividesAFaceInTwo) {
  constexpr double kTiny = 1e-6;
  Sheets sheets({{0, 0, 0},
                 {3, 0, 0},
                 {3, 0.2, 0},
                 {2.8, 0.2, 0},
                 {2.8, kTiny, 0},
                 {0.2, kTiny, 0},
                 {0.2, 0.2, 0},
                 {0, 0.2, 0},
                 {0, -1, 0},
                 {3, -1, 0}});
  sheets.add({0, 1, 2, 3, 4, 5, 6, 7});
  sheets.add({8, 9, 1, 0});
  sheets.add({5, 4, 3, 6});
  const ModelMesh result = mesh(sheets.model(), 0.5);
  expectComplete(result, 3.6, 1e-4);
  EXPECT_GT(leastAngle(result), 15);
  EXPECT_EQ(result.faces[0].attempts.size(), 1u);
}

TEST(TouchingEdges, AreDividedWhereOthersEnd) {
  CadSizes sizes;
  sizes.size = 1.3;
  const Model model = needle(1e-4);
  const DividedEdges divided =
      divideEdges(model.shape(), sampleEdges(model.shape(), sizes, 1, {}), sizes, 1, {});
  const DividedEdge& whole = divided.edges[0];
  const DividedEdge& part = divided.edges[4];
  ASSERT_EQ(whole.stops.size(), 1u);
  EXPECT_EQ(whole.points[whole.stops[0]], part.points.back());
  EXPECT_EQ(
      std::vector(whole.points.begin(), whole.points.begin() + std::ptrdiff_t(part.points.size())),
      part.points);
  EXPECT_TRUE(std::ranges::is_sorted(whole.parameters));
}

/// Its points are given from outside, and stay as they are.
TEST(TouchingEdges, AnEdgeWithGivenPointsIsNotDividedFurther) {
  MeshingOptions options = testing::ofSize(1.3);
  options.edgePoints[1] = {{1, 0, 0}, {2, 0, 0}, {3.5, 0, 0}, {4.5, 0, 0}, {6, 0, 0}};
  const ModelMesh result = mesh(needle(1e-4), options);
  EXPECT_EQ(std::ranges::count(result.segments, 1, &EdgeSegment::edge), 6);
}

}  // namespace
}  // namespace af2::geometry
