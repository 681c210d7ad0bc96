// Which plane faces need no repair.
#include "geometry/occ/base/sound_plane_face.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <vector>

namespace af2::geometry {
namespace {

const gp_Ax3 kAxes({1, 2, 3}, {1, 2, 2}, {0, 1, -1});

gp_Pnt at(double x, double y, double z = 0) {
  return kAxes.Location().XYZ() + x * kAxes.XDirection().XYZ() + y * kAxes.YDirection().XYZ() +
         z * kAxes.Direction().XYZ();
}

gp_Circ circle(double x, double y, double radius) {
  return {{at(x, y), kAxes.Direction()}, radius};
}

TopoDS_Wire wireOf(const std::vector<TopoDS_Edge>& edges) {
  TopoDS_Wire wire;
  BRep_Builder().MakeWire(wire);
  for (const TopoDS_Edge& edge : edges) BRep_Builder().Add(wire, edge);
  return wire;
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners) {
  std::vector<TopoDS_Vertex> vertices;
  for (const gp_Pnt& corner : corners)
    vertices.push_back(BRepBuilderAPI_MakeVertex(corner).Vertex());
  std::vector<TopoDS_Edge> edges;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    edges.push_back(
        BRepBuilderAPI_MakeEdge(vertices[i], vertices[(i + 1) % vertices.size()]).Edge());
  return wireOf(edges);
}

TopoDS_Wire square(double from, double to) {
  return polygon({at(from, from), at(to, from), at(to, to), at(from, to)});
}

TopoDS_Wire round(double x, double y, double radius) {
  return wireOf({BRepBuilderAPI_MakeEdge(circle(x, y, radius)).Edge()});
}

TopoDS_Wire reversed(const TopoDS_Wire& wire) { return TopoDS::Wire(wire.Reversed()); }

TopoDS_Face faceOf(const std::vector<TopoDS_Wire>& wires) {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_Plane(kAxes), 1e-7);
  for (const TopoDS_Wire& wire : wires) BRep_Builder().Add(face, wire);
  return face;
}

bool isSound(const std::vector<TopoDS_Wire>& wires) { return isSoundPlaneFace(faceOf(wires)); }

/// The square of side 2 whose upper side is replaced by an edge.
TopoDS_Wire squareUnder(const Handle(Geom_Curve) & curve) {
  std::vector<TopoDS_Vertex> vertices;
  for (const gp_Pnt& corner : {at(0, 0), at(2, 0), at(2, 2), at(0, 2)})
    vertices.push_back(BRepBuilderAPI_MakeVertex(corner).Vertex());
  return wireOf({BRepBuilderAPI_MakeEdge(vertices[0], vertices[1]).Edge(),
                 BRepBuilderAPI_MakeEdge(vertices[1], vertices[2]).Edge(),
                 BRepBuilderAPI_MakeEdge(curve, vertices[2], vertices[3]).Edge(),
                 BRepBuilderAPI_MakeEdge(vertices[3], vertices[0]).Edge()});
}

Handle(Geom_Curve) arcOver(const gp_Pnt& middle) {
  return GC_MakeArcOfCircle(at(2, 2), middle, at(0, 2)).Value()->BasisCurve();
}

TEST(SoundPlaneFace, MayHaveRoundEdgesAndHoles) {
  EXPECT_TRUE(isSound({square(0, 2)}));
  EXPECT_TRUE(isSoundPlaneFace(TopoDS::Face(faceOf({square(0, 2)}).Reversed())));
  EXPECT_TRUE(isSound({round(1, 1, 3)}));
  EXPECT_TRUE(isSound({squareUnder(arcOver(at(1, 3)))}));
  EXPECT_TRUE(isSound({squareUnder(arcOver(at(1, 1.2)))}));
  EXPECT_TRUE(isSound({square(0, 9), reversed(round(2, 2, 1)), reversed(square(4, 5)),
                       polygon({at(6, 8), at(8, 7), at(7, 6)})}));
}

TEST(SoundPlaneFace, HasItsWiresAroundIt) {
  EXPECT_FALSE(isSound({}));
  EXPECT_FALSE(isSound({reversed(square(0, 2))}));
  EXPECT_FALSE(isSound({square(0, 9), round(2, 2, 1)}));
  EXPECT_FALSE(isSound({square(0, 9), reversed(round(20, 2, 1))}));  // outside
  EXPECT_FALSE(
      isSound({square(0, 9), reversed(round(5, 5, 3)), reversed(round(5, 5, 1))}));  // in a hole
}

TEST(SoundPlaneFace, IsNotTouchedOrCrossedByItself) {
  EXPECT_FALSE(isSound({square(0, 9), reversed(round(9, 2, 1))}));
  EXPECT_FALSE(isSound({square(0, 9), reversed(round(1 + 1e-6, 2, 1))}));  // by a hole, nearly
  EXPECT_FALSE(isSound({polygon({at(0, 0), at(2, 0), at(0, 2), at(3, 2)})}));
  EXPECT_FALSE(isSound({polygon({at(0, 0), at(4, 0), at(2, 1e-6), at(2, 2)})}));
  EXPECT_FALSE(isSound({polygon({at(0, 0), at(4, 0), at(4, 1)}) /* 14 degrees */}));
  EXPECT_FALSE(isSound({squareUnder(arcOver(at(1, -0.1)))}));
}

TEST(SoundPlaneFace, IsClosedByItsVertices) {
  TopoDS_Wire open = square(0, 2);
  BRep_Builder().Remove(open, TopExp_Explorer(open, TopAbs_EDGE).Current());
  EXPECT_FALSE(isSound({open}));
  // A corner on two vertices.
  const TopoDS_Vertex a = BRepBuilderAPI_MakeVertex(at(0, 0)).Vertex(),
                      b = BRepBuilderAPI_MakeVertex(at(2, 0)).Vertex(),
                      c = BRepBuilderAPI_MakeVertex(at(0, 2)).Vertex(),
                      other = BRepBuilderAPI_MakeVertex(at(0, 0)).Vertex();
  EXPECT_FALSE(
      isSound({wireOf({BRepBuilderAPI_MakeEdge(a, b).Edge(), BRepBuilderAPI_MakeEdge(b, c).Edge(),
                       BRepBuilderAPI_MakeEdge(c, other).Edge()})}));
  // Edges that do not follow each other.
  EXPECT_FALSE(
      isSound({wireOf({BRepBuilderAPI_MakeEdge(a, b).Edge(), BRepBuilderAPI_MakeEdge(c, a).Edge(),
                       BRepBuilderAPI_MakeEdge(b, c).Edge()})}));
}

TEST(SoundPlaneFace, LiesInItsPlane) {
  EXPECT_TRUE(isSound({polygon({at(0, 0), at(2, 0), at(2, 2, 4e-8)})}));
  EXPECT_FALSE(isSound({polygon({at(0, 0), at(2, 0), at(2, 2, 1e-6)})}));
  EXPECT_FALSE(isSound({squareUnder(arcOver(at(1, 3, 1e-5)))}));
  const gp_Circ leaning({at(0, 0), at(0, 1e-6, 1).XYZ() - at(0, 0).XYZ()}, 1);
  EXPECT_FALSE(isSound({wireOf({BRepBuilderAPI_MakeEdge(leaning).Edge()})}));
}

TEST(SoundPlaneFace, HasEdgesThatEndAtTheirVertices) {
  const TopoDS_Wire wire = square(0, 2);
  const TopoDS_Vertex corner = TopoDS::Vertex(TopExp_Explorer(wire, TopAbs_VERTEX).Current());
  EXPECT_TRUE(isSound({wire}));
  BRep_Builder().UpdateVertex(corner, at(1e-5, 0), 0);
  EXPECT_FALSE(isSound({wire}));
  BRep_Builder().UpdateVertex(corner, 2e-5);
  EXPECT_TRUE(isSound({wire}));
}

TEST(SoundPlaneFace, HasOnlyLinesAndCircles) {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = at(2, 2);
  poles(2) = at(1, 3);
  poles(3) = at(0, 2);
  EXPECT_FALSE(isSound({squareUnder(new Geom_BezierCurve(poles))}));
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  for (TopExp_Explorer it(cylinder, TopAbs_FACE); it.More(); it.Next()) {
    // OpenCASCADE gives the plane faces curves in their parameters.
    EXPECT_FALSE(isSoundPlaneFace(TopoDS::Face(it.Current())));
  }
}

TEST(SoundPlaneFace, HasEdgesThatSayNothingElse) {
  for (int fault = 0; fault < 3; ++fault) {
    const TopoDS_Wire wire = square(0, 2);
    const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(wire, TopAbs_EDGE).Current());
    if (fault == 0) BRep_Builder().SameParameter(edge, false);
    if (fault == 1) BRep_Builder().SameRange(edge, false);
    if (fault == 2) BRep_Builder().Degenerated(edge, true);
    EXPECT_FALSE(isSound({wire})) << fault;
  }
}

}  // namespace
}  // namespace af2::geometry
