// Faces on which the first way fails: what is done then, and that it is told.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "geometry/occ/run/mesh_model.h"
#include "geometry/occ/sizes/sizing.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

using testing::circle;
using testing::crossingsOf;
using testing::expectComplete;
using testing::leastAngle;
using testing::mesh;
using testing::plane;
using testing::rectangle;

/// The wanted size would let the chords of the two circles cross.
TEST(DifficultFaces, ANarrowRingGetsShorterEdges) {
  BRepBuilderAPI_MakeWire inner(TopoDS::Edge(circle(1).Reversed()));
  const TopoDS_Face ring = plane({BRepBuilderAPI_MakeWire(circle(1.005)).Wire(), inner.Wire()});
  const ModelMesh result = mesh(ring, 0.6);
  expectComplete(result, pi * (1.005 * 1.005 - 1));
  EXPECT_FALSE(result.faces[0].attempts.empty());
}

TEST(DifficultFaces, AnArcOfAThousandthOfTheSizeIsDividedUntilItsChordsDoNotCross) {
  const auto arc = [](double radius) {
    return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0}, {0, 0, 1}), radius), 0, pi).Edge();
  };
  const auto side = [](double from, double to) {
    return BRepBuilderAPI_MakeEdge(gp_Pnt(from, 0, 0), gp_Pnt(to, 0, 0)).Edge();
  };
  BRepBuilderAPI_MakeWire wire(arc(1.0002), side(-1.0002, -1), arc(1), side(1, 1.0002));
  const ModelMesh result = mesh(plane({wire.Wire()}), 0.2);
  expectComplete(result, pi / 2 * (1.0002 * 1.0002 - 1), 0.01);
  EXPECT_GT(leastAngle(result), 0.5);
}

/// A tube so oblique that its section is flat, with a radius of a sixth of the size at its ends:
/// the first tries fail without a place that is at fault.
TEST(DifficultFaces, AnObliqueTubeGetsTheSizesThatItsCurvatureWants) {
  const TopoDS_Shape tube =
      BRepPrimAPI_MakePrism(circle(1.537), gp_Vec(1.7555, 0, 0.21863)).Shape();
  const ModelMesh result = mesh(tube, 0.143);
  expectComplete(result, 11.163);
  EXPECT_FALSE(result.faces[0].attempts.empty());
}

/// No front can fill what crossing edges bound, however short they are.
TEST(DifficultFaces, ALoopThatCrossesItselfIsTriedOnce) {
  MeshingOptions options = testing::ofSize(0.3);
  int fronts = 0;
  options.observer = [&](int) {
    ++fronts;
    return nullptr;
  };
  const ModelMesh result = mesh(testing::modelOf(testing::crossingLoop()), options);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_EQ(fronts, 1);
}

/// Its sides cross on a cylinder, so that a front leaves what they bound.
TopoDS_Face eightOnCylinder() {
  const Handle(Geom_Surface) surface = new Geom_CylindricalSurface(gp_Ax3(), 1);
  const std::vector<gp_Pnt2d> corners{{0, 0}, {2, 2}, {2, 0}, {0, 2.1}};
  std::vector<TopoDS_Vertex> vertices;
  for (const gp_Pnt2d& p : corners)
    vertices.push_back(BRepBuilderAPI_MakeVertex(surface->Value(p.X(), p.Y())));
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t k = (i + 1) % corners.size();
    wire.Add(BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(corners[i], corners[k]).Value(), surface,
                                     vertices[i], vertices[k], 0, corners[i].Distance(corners[k])));
  }
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, wire.Wire());
  BRepLib::BuildCurves3d(face);
  return face;
}

TEST(DifficultFaces, AFrontThatRunsAwayIsStoppedEarlyWhereTurnsAreAskedFor) {
  struct Counter final : AF2MeshingObserver {
    void stepTaken(const StepReport& step) override { most = std::max(most, step.elements); }
    std::size_t most = 0;
  } counter;
  MeshingOptions options = testing::ofSize(0.3);
  options.sizes.elementsPerTurn = 12;
  options.threads = 1;
  options.observer = [&](int) { return &counter; };
  const ModelMesh result = mesh(testing::modelOf(eightOnCylinder()), options);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
  EXPECT_LT(counter.most, 10'000u);
}

/// Ten times shorter edges are not enough, though better.
TEST(DifficultFaces, AStripOfATwoThousandthOfTheSizeIsDividedFinely) {
  const ModelMesh result = mesh(plane({rectangle(0, 0, 2, 0.0005)}), 1);
  expectComplete(result, 0.001, 1e-9);
  EXPECT_GT(leastAngle(result), 0.5);
}

/// A frame as those of the sockets on a circuit board: a thousandth of its side wide.
TEST(DifficultFaces, AFrameHasElementsAsWideAsItself) {
  const TopoDS_Wire hole = TopoDS::Wire(rectangle(0.001, 0.001, 0.999, 0.999).Reversed());
  const ModelMesh result = mesh(plane({rectangle(0, 0, 1, 1), hole}), 2.5);
  expectComplete(result, 4 * 0.999 * 0.001, 1e-6);
  EXPECT_GT(leastAngle(result), 0.5);
  EXPECT_LT(result.elements.size(), 400u);
  for (const Point3& p : result.vertices)
    EXPECT_LT(std::min({p.x, p.y, 1 - p.x, 1 - p.y}), 0.00100001) << "a vertex inside";
}

/// No division opens the angle of a corner, so none is tried.
TEST(DifficultFaces, ASharpCornerIsLeftAsItIs) {
  BRepBuilderAPI_MakePolygon wedge({0, 0, 0}, {10, 0, 0}, {10, 0.2, 0}, true);
  const ModelMesh result = mesh(plane({wedge.Wire()}), 1);
  expectComplete(result, 1, 1e-6);
  EXPECT_TRUE(result.faces[0].attempts.empty());
  EXPECT_LT(result.elements.size(), 40u);
}

/// The disc wants shorter edges for its area; on the crescent, whose sides touch at the tips, the
/// element there is the worse the shorter it is. The strip cannot be meshed without shorter edges.
TEST(DifficultFaces, ShorterEdgesForOneFaceDoNotSpoilItsNeighbor) {
  const gp_Ax2 axes({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
  const gp_Pnt left(-1, 0, 0), right(1, 0, 0);
  const TopoDS_Edge upper = BRepBuilderAPI_MakeEdge(gp_Circ(axes, 1), right, left);
  const TopoDS_Edge lower = BRepBuilderAPI_MakeEdge(gp_Circ(axes, 1), left, right);
  const TopoDS_Edge outer = BRepBuilderAPI_MakeEdge(gp_Elips(axes, 1.05, 1), right, left);
  BRepBuilderAPI_Sewing sewing(1e-7);
  sewing.Add(plane({BRepBuilderAPI_MakeWire(upper, lower).Wire()}));
  sewing.Add(plane({BRepBuilderAPI_MakeWire(outer, TopoDS::Edge(upper.Reversed())).Wire()}));
  sewing.Perform();
  const TopoDS_Shape both =
      testing::compoundOf({sewing.SewedShape(), plane({rectangle(4, 0, 6, 0.001)})});
  const ModelMesh result = mesh(both, 0.8);
  expectComplete(result, pi * 1.025, 0.1);
  EXPECT_GT(leastAngle(result), 0.6);
}

/// A square of side 10 with ridges that are far sharper than the wanted size.
TopoDS_Face roughGround() {
  constexpr int kPoles = 21;
  TColgp_Array2OfPnt poles(1, kPoles, 1, kPoles);
  for (int i = 1; i <= kPoles; ++i)
    for (int k = 1; k <= kPoles; ++k)
      poles(i, k) =
          gp_Pnt(0.5 * (i - 1), 0.5 * (k - 1), i % 11 == 5 || (k % 13 == 6 && i > 10) ? 0.8 : 0);
  TColStd_Array1OfReal knots(1, kPoles - 2);
  TColStd_Array1OfInteger multiplicities(1, kPoles - 2);
  for (int i = 1; i <= kPoles - 2; ++i) {
    knots(i) = i;
    multiplicities(i) = i == 1 || i == kPoles - 2 ? 4 : 1;
  }
  const Handle(Geom_Surface) ground =
      new Geom_BSplineSurface(poles, knots, knots, multiplicities, multiplicities, 3, 3);
  return BRepBuilderAPI_MakeFace(ground, 1e-6);
}

TEST(DifficultFaces, AFrontFollowsSizesThatChangeFasterThanItsElements) {
  const TopoDS_Face ground = roughGround();
  CadSizes sizes;
  sizes.size = 1;
  EXPECT_EQ(unevenFaces(testing::modelOf(ground).shape(), sizes, 1, {}), std::vector<int>{1});
  EXPECT_TRUE(unevenFaces(testing::modelOf(plane({rectangle(0, 0, 20, 20)})).shape(), sizes, 1, {})
                  .empty());
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(ground, properties);
  const ModelMesh result = mesh(ground, sizes.size);
  expectComplete(result, properties.Mass());
  EXPECT_GT(leastAngle(result), 15);
}

/// One corner of the surface turns over by a little, so that the normals along an edge look back.
TEST(DifficultFaces, ACornerThatTurnsOverIsMeshedWithElementsThatLean) {
  TColgp_Array2OfPnt poles(1, 5, 1, 5);
  for (int i = poles.LowerRow(); i <= poles.UpperRow(); ++i)
    for (int k = poles.LowerCol(); k <= poles.UpperCol(); ++k)
      poles.SetValue(i, k,
                     i == poles.UpperRow() ? gp_Pnt(4 - 0.1 * (k - 1), -0.15 * (k - 1), 1.6)
                                           : gp_Pnt(i - 1, 0.4 * (k - 1), 0.1 * i * i));
  const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-6);
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  for (const double size : {0.5, 0.9}) {
    const ModelMesh result = mesh(face, size);
    expectComplete(result, properties.Mass());
    ASSERT_FALSE(result.faces[0].attempts.empty());
    EXPECT_EQ(result.faces[0].attempts.back(), "elements that tilt against the surface") << size;
  }
}

/// Most of a turn of a trumpet: its narrow end is one point, a corner of the face, from which the
/// surface looks up to opposite sides.
TEST(DifficultFaces, ASharpTipAtACornerIsMeshed) {
  TColgp_Array1OfPnt poles(1, 3);
  poles.SetValue(1, {0, 0, 0});
  poles.SetValue(2, {0.5, 0, -0.5});
  poles.SetValue(3, {1.5, 0, 0});
  const Handle(Geom_Surface) surface =
      new Geom_SurfaceOfRevolution(new Geom_BezierCurve(poles), gp::OZ());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 0, 5.5, 0, 1, 1e-7);
  for (const double size : {0.3, 0.17, 0.1}) {
    const ModelMesh result = mesh(face, size);
    expectComplete(result);
    EXPECT_GT(leastAngle(result), 10) << size;
  }
}

TEST(DifficultFaces, AThinWireIsMeshedAllTheWayAround) {
  expectComplete(mesh(BRepPrimAPI_MakeCylinder(0.01, 2).Shape(), 0.5), 2 * pi * 0.01 * 2, 0.1);
}

TEST(DifficultFaces, AThinHalfTubeIsMeshedAcross) {
  expectComplete(mesh(BRepPrimAPI_MakeCylinder(0.01, 2, pi).Shape(), 0.5),
                 (pi + 2) * 0.01 * 2 + pi * 1e-4, 0.1);
}

TEST(DifficultFaces, AHoleOfAThousandthOfTheSizeStaysAHole) {
  BRepBuilderAPI_MakeWire hole(TopoDS::Edge(circle(0.0005).Reversed()));
  const ModelMesh result = mesh(plane({rectangle(-1, -1, 1, 1), hole.Wire()}), 0.5);
  expectComplete(result, 4);
  EXPECT_EQ(std::ranges::count(result.segments, 5, &EdgeSegment::edge) >= 6, true);
}

/// Chords of the wanted length of the two circles cross between their ends, and the elements with
/// them. The narrow faces between the spheres ask for shorter edges.
TEST(DifficultFaces, AThinBentWallIsMeshedSoFinelyThatItsSidesDoNotCross) {
  const TopoDS_Shape outer = BRepPrimAPI_MakeSphere(1.008, 0, pi / 2, pi / 2).Shape();
  const TopoDS_Shape wall =
      BRepAlgoAPI_Cut(outer, BRepPrimAPI_MakeSphere(1, 0, pi / 2, pi / 2).Shape()).Shape();
  const ModelMesh result = mesh(wall, 0.3);
  expectComplete(result, pi / 2 * (1 + 1.008 * 1.008) + 3 * pi / 4 * (1.008 * 1.008 - 1));
  EXPECT_EQ(crossingsOf(result), 0u);
  EXPECT_TRUE(std::ranges::any_of(result.faces, [](const FaceReport& face) {
    return std::ranges::any_of(face.attempts, [](const std::string& step) {
      return step.find("shorter edges") != std::string::npos;
    });
  }));
}

/// Where it takes more than a round or two until fewer elements cross.
TEST(DifficultFaces, AWallOfLessThanAThousandthOfItsRadiusIsMeshed) {
  const TopoDS_Shape inner = BRepPrimAPI_MakeCylinder(0.9994, 1).Shape();
  const ModelMesh result =
      mesh(BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(1, 1).Shape(), inner).Shape(), 0.1);
  expectComplete(result, 2 * pi * 1.9994 + 2 * pi * (1 - 0.9994 * 0.9994));
  EXPECT_EQ(crossingsOf(result), 0u);
}

/// Which no size can mend.
/// Files may trim the curve that is swept to another part of it than the face takes up.
TEST(DifficultFaces, AFaceBeyondTheEndsOfTheCurveThatIsSweptIsMeshed) {
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2({}, gp::DZ(), gp_Dir(0, -1, 0)), 1);
  const auto swept = [&](double from, double to) {
    return Handle(Geom_Surface)(
        new Geom_SurfaceOfRevolution(new Geom_TrimmedCurve(circle, from, to), gp::OY()));
  };
  TopoDS_Face face = BRepBuilderAPI_MakeFace(swept(pi, 2 * pi), 0, pi / 2, pi, 2 * pi, 1e-7);
  const Handle(Geom_Surface) other = swept(0, pi);
  BRep_Builder builder;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double first, last;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    builder.UpdateEdge(edge, curve, other, TopLoc_Location(), 1e-7);
  }
  builder.UpdateFace(face, other, TopLoc_Location(), 1e-7);
  expectComplete(mesh(face, 0.1), pi, 0.01);  // a quarter of a sphere
}

TEST(DifficultFaces, FacesThatCrossAreNamed) {
  const auto face = [](std::initializer_list<gp_Pnt> corners) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& corner : corners) polygon.Add(corner);
    polygon.Close();
    return BRepBuilderAPI_MakeFace(polygon.Wire()).Face();
  };
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(plane({rectangle(0, 0, 1, 1)}));
  sewing.Add(face({{0.5, -1, -1}, {0.5, 2, -1}, {0.5, 2, 1}, {0.5, -1, 1}}));
  // These join the two, so that they are of one piece.
  sewing.Add(face({{0.5, 2, 1}, {0.5, -1, 1}, {1, 1, 0}}));
  sewing.Add(face({{1, 1, 0}, {1, 0, 0}, {0.5, -1, 1}}));
  sewing.Perform();
  const ModelMesh result = mesh(sewing.SewedShape(), 0.4);
  const auto failed = std::ranges::find(result.faces, FaceStatus::Failed, &FaceReport::status);
  ASSERT_NE(failed, result.faces.end());
  EXPECT_NE(failed->reason.find("elements cross those of face"), std::string::npos);
  EXPECT_EQ(std::ranges::count(result.faces, FaceStatus::Complete, &FaceReport::status), 3);
  EXPECT_EQ(crossingsOf(result), 0u);
}

TEST(DifficultFaces, TheSameMeshFromAnyNumberOfThreads) {
  BRepBuilderAPI_MakeWire inner(TopoDS::Edge(circle(1).Reversed()));
  const TopoDS_Face ring = plane({BRepBuilderAPI_MakeWire(circle(1.005)).Wire(), inner.Wire()});
  const Model solid = testing::modelOf(BRepPrimAPI_MakePrism(ring, gp_Vec(0, 0, 0.5)).Shape());
  const AF2Algorithm algorithm(testing::triangleSet());
  MeshingOptions options;
  options.sizes.size = 0.6;
  options.threads = 1;
  const ModelMesh one = meshModel(solid, algorithm, options);
  options.threads = 4;
  const ModelMesh four = meshModel(solid, algorithm, options);
  EXPECT_EQ(one.vertices, four.vertices);
  EXPECT_EQ(one.elements, four.elements);
}

/// A patch with three corners, one of them a pole, as between fillets; `inside` are the poles of
/// the surface between that and the rim.
TopoDS_Face patchFromPole(const std::array<gp_Pnt, 3>& inside, const gp_Pnt& rim) {
  const std::array<gp_Pnt, 3> last{gp_Pnt(1, 0, 0), rim, gp_Pnt(0, 1, 0)};
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  poles.Init(gp_Pnt(0, 0, 0));
  for (int i = 1; i <= 3; ++i) {
    poles.SetValue(i, 2, inside[static_cast<std::size_t>(i) - 1]);
    poles.SetValue(i, 3, last[static_cast<std::size_t>(i) - 1]);
  }
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7);
}

TEST(DifficultFaces, PatchesBentMoreThanAFewElementsCanFollowAreClosedLeaning) {
  const std::array patches{
      patchFromPole({{{-0.3, 0.4, 0.2}, {0.3, 0.5, -0.3}, {0, 0.3, 0.4}}}, {0.5, 0.3, -0.3}),
      patchFromPole({{{-0.1, 0.2, 0.1}, {0.6, 0.4, 0.4}, {-0.1, 0.3, 0.3}}}, {0.4, 0.6, 0.2})};
  for (const TopoDS_Face& patch : patches) {
    const ModelMesh result = mesh(patch, 0.4);
    expectComplete(result);
    EXPECT_GT(leastAngle(result), 2);
    EXPECT_EQ(crossingsOf(result), 0u);
    ASSERT_FALSE(result.faces[0].attempts.empty());
    EXPECT_EQ(result.faces[0].attempts.back(), "elements that tilt against the surface");
  }
}

/// A front would try in vain to put vertices into it.
TEST(DifficultFaces, CurvedStripsAreFilledFromTheirBoundaries) {
  const gp_Ax2 axes(gp_Pnt(0, 0, 0), gp::DZ());
  const auto closedIn = [&](double height) {
    const ModelMesh result =
        testing::mesh(BRepPrimAPI_MakeCylinder(axes, 10, height, 1).Shape(), 1);
    testing::expectComplete(result);
    const auto curved = std::ranges::find(result.faces, "cylinder", &FaceReport::surfaceType);
    EXPECT_NEAR(curved->area, 10 * height, 1e-3 * height);
    return static_cast<double>(curved->withoutRule.closing) / static_cast<double>(curved->elements);
  };
  EXPECT_EQ(closedIn(0.002), 1);
  EXPECT_EQ(closedIn(2), 0);
}

}  // namespace
}  // namespace af2::geometry
