// Boolean operations, fillets, chamfers, shells, drafts: what parts of machines are made with.
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_Pln.hxx>
#include <numbers>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

TopoDS_Shape block(Draw& draw) {
  const double x = draw.between(5, 12);
  const double y = draw.between(4, 9);
  return BRepPrimAPI_MakeBox(gp_Pnt(-x / 2, -y / 2, -2), x, y, draw.between(2, 7)).Shape();
}

bool isValid(const TopoDS_Shape& shape) { return BRepCheck_Analyzer(shape).IsValid(); }

/// Rounds some edges; each in a try of its own, as many a radius fits only some edges.
TopoDS_Shape rounded(Draw& draw, TopoDS_Shape shape, int tries, double least, double most) {
  for (int i = 0; i < tries; ++i) {
    const std::vector<TopoDS_Shape> edges = edgesOf(shape);
    const TopoDS_Edge edge = TopoDS::Edge(
        edges[static_cast<std::size_t>(draw.count(0, static_cast<int>(edges.size()) - 1))]);
    const double radius = draw.between(least, most);
    const double other = draw.chance(30) ? draw.between(least, most) : radius;
    try {
      BRepFilletAPI_MakeFillet fillet(shape);
      fillet.Add(radius, other, edge);
      fillet.Build();
      if (fillet.IsDone() && isValid(fillet.Shape())) shape = fillet.Shape();
    } catch (const Standard_Failure&) {
      continue;
    }
  }
  return shape;
}

TopoDS_Shape cutBlock(Draw& draw) {
  TopoDS_Shape shape = block(draw);
  for (int i = draw.count(1, 5); i > 0; --i)
    shape = cut(shape, primitive(draw, draw.between(1, 5)));
  return shape;
}

TopoDS_Shape unionOfSolids(Draw& draw) {
  TopoDS_Shape shape = primitive(draw, 6);
  for (int i = draw.count(1, 4); i > 0; --i)
    shape = fused(shape, primitive(draw, draw.between(2, 6)));
  return shape;
}

TopoDS_Shape commonOfSolids(Draw& draw) {
  const TopoDS_Shape first = primitive(draw, 6);
  return BRepAlgoAPI_Common(first, primitive(draw, 6)).Shape();
}

TopoDS_Shape unionAndCuts(Draw& draw) {
  TopoDS_Shape shape = unionOfSolids(draw);
  for (int i = draw.count(1, 4); i > 0; --i)
    shape = cut(shape, primitive(draw, draw.between(1, 4)));
  return shape;
}

TopoDS_Shape roundedBlock(Draw& draw) {
  const TopoDS_Shape shape = block(draw);
  BRepFilletAPI_MakeFillet fillet(shape);
  const double radius = draw.between(0.05, 0.99);
  for (const TopoDS_Shape& edge : edgesOf(shape)) {
    if (draw.chance(80))
      fillet.Add(draw.chance(70) ? radius : draw.between(0.02, 0.9), TopoDS::Edge(edge));
  }
  return fillet.Shape();
}

TopoDS_Shape roundedCut(Draw& draw) {
  TopoDS_Shape shape = cutBlock(draw);
  return rounded(draw, shape, draw.count(2, 8), 0.02, 0.7);
}

TopoDS_Shape roundedUnion(Draw& draw) {
  TopoDS_Shape shape = unionOfSolids(draw);
  return rounded(draw, shape, draw.count(2, 6), 0.02, 0.5);
}

TopoDS_Shape chamfered(Draw& draw) {
  TopoDS_Shape shape = cutBlock(draw);
  for (int i = draw.count(2, 6); i > 0; --i) {
    const std::vector<TopoDS_Shape> edges = edgesOf(shape);
    const auto chosen = static_cast<std::size_t>(draw.count(0, static_cast<int>(edges.size()) - 1));
    const double length = draw.between(0.02, 0.7);
    try {
      BRepFilletAPI_MakeChamfer chamfer(shape);
      chamfer.Add(length, TopoDS::Edge(edges[chosen]));
      chamfer.Build();
      if (chamfer.IsDone() && isValid(chamfer.Shape())) shape = chamfer.Shape();
    } catch (const Standard_Failure&) {
      continue;
    }
  }
  return shape;
}

TopoDS_Shape hollow(Draw& draw) {
  TopoDS_Shape shape = block(draw);
  if (draw.chance(50))
    shape = cut(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 0, -5), gp::DZ()),
                                                draw.between(0.3, 1.5), 20)
                           .Shape());
  if (draw.chance(50))
    shape = fused(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 1, 0), gp::DY()),
                                                  draw.between(0.6, 1.5), 8)
                             .Shape());
  if (draw.chance(50)) shape = rounded(draw, shape, draw.count(1, 4), 0.1, 0.6);
  const double wall = draw.chance(70) ? -draw.between(0.05, 0.5) : draw.between(0.05, 0.5);
  const GeomAbs_JoinType join = draw.chance(50) ? GeomAbs_Arc : GeomAbs_Intersection;
  for (const TopoDS_Shape& face : facesOf(shape)) {
    TopTools_ListOfShape open;
    open.Append(face);
    BRepOffsetAPI_MakeThickSolid thick;
    thick.MakeThickSolidByJoin(shape, open, wall, 1e-5, BRepOffset_Skin, false, false, join);
    if (thick.IsDone() && isValid(thick.Shape())) return thick.Shape();
  }
  return {};
}

TopoDS_Shape drafted(Draw& draw) {
  const TopoDS_Shape shape = block(draw);
  BRepOffsetAPI_DraftAngle draft(shape);
  for (const TopoDS_Shape& face : facesOf(shape)) {
    const gp_Dir normal = BRepAdaptor_Surface(TopoDS::Face(face)).Plane().Axis().Direction();
    if (std::abs(normal.Z()) > 0.5 || draw.chance(20)) continue;
    draft.Add(TopoDS::Face(face), gp::DZ(), draw.between(-0.3, 0.3),
              gp_Pln(gp::Origin(), gp::DZ()));
  }
  draft.Build();
  return rounded(draw, draft.Shape(), draw.count(0, 5), 0.05, 0.6);
}

TopoDS_Shape perforatedPlate(Draw& draw) {
  const int columns = draw.count(3, 14);
  const int rows = draw.count(2, 8);
  const double radius = draw.between(0.1, 0.498);
  const bool round = draw.chance(60);
  std::vector<TopoDS_Wire> holes;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const gp_Pnt center(i + (j % 2) * 0.5, j * 0.9, 0);
      if (round) {
        holes.push_back(circle(gp_Ax2(center, gp::DZ()), 0.9 * radius));
        continue;
      }
      std::vector<gp_Pnt> corners;
      for (int k = 0; k < 6; ++k) {
        const double angle = kTurn * (k + 0.5) / 6;
        corners.emplace_back(center.X() + radius * std::cos(angle),
                             center.Y() + radius * std::sin(angle), 0);
      }
      holes.push_back(polygon(corners));
    }
  }
  const TopoDS_Wire outer =
      polygon({gp_Pnt(-0.6, -0.6, 0), gp_Pnt(columns + 0.1, -0.6, 0),
               gp_Pnt(columns + 0.1, 0.9 * rows - 0.3, 0), gp_Pnt(-0.6, 0.9 * rows - 0.3, 0)});
  return extruded(flatFace(outer, holes), gp_Vec(0, 0, draw.between(0.01, 1)));
}

TopoDS_Shape gear(Draw& draw) {
  const int teeth = draw.count(8, 40);
  const double depth = draw.between(0.2, 0.9);
  std::vector<gp_Pnt> corners;
  const auto add = [&](double radius, double turn) {
    corners.emplace_back(radius * std::cos(kTurn * turn), radius * std::sin(kTurn * turn), 0);
  };
  for (int i = 0; i < teeth; ++i) {
    add(5, (i - 0.3) / teeth);
    add(5 + depth, (i - 0.15) / teeth);
    add(5 + depth, (i + 0.15) / teeth);
    add(5, (i + 0.3) / teeth);
  }
  const double height = draw.between(0.3, 3);
  TopoDS_Shape shape =
      extruded(flatFace(polygon(corners), {circle(gp::XOY(), draw.between(0.5, 4.8))}),
               gp_Vec(0, 0, height));
  if (draw.chance(50)) {
    const double slope = draw.between(0.3, 0.9);
    const TopoDS_Shape ball =
        BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, height / 2), 5 + slope * depth).Shape();
    shape = BRepAlgoAPI_Common(shape, ball).Shape();
  }
  return rounded(draw, shape, draw.count(0, 4), 0.02, 0.2);
}

/// Cylinders that meet with almost the same radius, or almost touch.
TopoDS_Shape nearlyTangent(Draw& draw) {
  const double radius = draw.between(0.8, 1.2);
  const double gaps[] = {0, 1e-5, -1e-5, 1e-4, -1e-4, 1e-3, -1e-3, 1e-2, -1e-2};
  const double other = radius + gaps[draw.count(0, 8)];
  const gp_Ax2 up(gp_Pnt(0, 0, -3), gp::DZ());
  const gp_Ax2 across(gp_Pnt(-3, gaps[draw.count(0, 8)], 0),
                      draw.chance(60) ? gp::DX() : gp_Dir(1, 0, draw.between(-1, 1)));
  const gp_Ax2 beside(gp_Pnt(radius + other - (draw.chance(50) ? 1e-3 : 1e-2), 0, -3), gp::DZ());
  const TopoDS_Shape first = BRepPrimAPI_MakeCylinder(up, radius, 6).Shape();
  const TopoDS_Shape second =
      BRepPrimAPI_MakeCylinder(draw.chance(70) ? across : beside, other, draw.between(3.5, 6))
          .Shape();
  return draw.chance(60) ? fused(first, second) : cut(first, second);
}

/// Boxes whose faces almost coincide: strips and steps far narrower than an element.
TopoDS_Shape nearlyFlush(Draw& draw) {
  const double steps[] = {1e-4, 1e-3, 3e-3, 1e-2, 3e-2};
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(4, 3, 2).Shape();
  for (int i = draw.count(1, 4); i > 0; --i) {
    const double step = steps[draw.count(0, 4)];
    const gp_Pnt corner(draw.between(0, 3), draw.chance(50) ? step : -step,
                        draw.chance(50) ? 2 - step : draw.between(0, 2));
    const TopoDS_Shape other =
        draw.chance(60)
            ? BRepPrimAPI_MakeBox(corner, draw.between(0.5, 2), draw.between(1, 3), 1).Shape()
            : BRepPrimAPI_MakeCylinder(gp_Ax2(corner, gp::DZ()), draw.between(0.3, 1), 1).Shape();
    shape = draw.chance(60) ? fused(shape, other) : cut(shape, other);
  }
  return shape;
}

TopoDS_Shape flange(Draw& draw) {
  const double bore = draw.between(0.5, 1.9);
  TopoDS_Shape shape = fused(BRepPrimAPI_MakeCylinder(5, 1).Shape(),
                             BRepPrimAPI_MakeCylinder(2.5, draw.between(2, 5)).Shape());
  shape =
      cut(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -1), gp::DZ()), bore, 10).Shape());
  const int bolts = draw.count(3, 12);
  const double radius = draw.between(0.1, 0.55);
  std::vector<TopoDS_Shape> holes;
  for (int i = 0; i < bolts; ++i) {
    const double angle = kTurn * i / bolts;
    const gp_Pnt center(3.8 * std::cos(angle), 3.8 * std::sin(angle), -1);
    holes.push_back(BRepPrimAPI_MakeCylinder(gp_Ax2(center, gp::DZ()), radius, 3).Shape());
  }
  shape = cut(shape, compound(holes));
  return rounded(draw, shape, draw.count(1, 6), 0.02, 0.6);
}

/// A plate with a hole and a pin far smaller than any element, and a needle.
TopoDS_Shape tinyFeatures(Draw& draw) {
  const TopoDS_Shape plate =
      BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), 10, 10, draw.between(0.3, 1)).Shape();
  const auto at = [&](double z) {
    return gp_Ax2(gp_Pnt(draw.between(-4, 4), draw.between(-4, 4), z), gp::DZ());
  };
  const double hole = draw.between(0.005, 0.05), pin = draw.between(0.005, 0.05);
  const double needle = draw.between(0.005, 0.05), height = draw.between(1, 4);
  TopoDS_Shape shape = cut(plate, BRepPrimAPI_MakeCylinder(at(-1), hole, 4).Shape());
  shape = fused(shape, BRepPrimAPI_MakeCylinder(at(0.1), pin, 2).Shape());
  return fused(shape, BRepPrimAPI_MakeCone(at(0.1), needle, 0, height).Shape());
}

}  // namespace

std::vector<Family> partFamilies() {
  return {{"cut_block", cutBlock},
          {"union", unionOfSolids},
          {"common", commonOfSolids},
          {"union_and_cuts", unionAndCuts},
          {"rounded_block", roundedBlock},
          {"rounded_cut", roundedCut},
          {"rounded_union", roundedUnion},
          {"chamfered", chamfered},
          {"hollow", hollow},
          {"drafted", drafted},
          {"perforated_plate", perforatedPlate},
          {"gear", gear},
          {"nearly_tangent", nearlyTangent},
          {"nearly_flush", nearlyFlush},
          {"flange", flange},
          {"tiny_features", tinyFeatures}};
}

}  // namespace af2::made
