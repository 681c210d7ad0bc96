// Free surfaces, sheets, what shares faces, odd units and places.
#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_MakeFilling.hxx>
#include <BRepOffsetAPI_MakeOffsetShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <gp_GTrsf.hxx>
#include <numbers>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

TopoDS_Shape anyOf(Draw& draw, const std::vector<Family>& families) {
  return families[static_cast<std::size_t>(draw.count(0, static_cast<int>(families.size()) - 1))]
      .make(draw);
}

TopoDS_Shape anySolid(Draw& draw) {
  return anyOf(draw, draw.chance(60) ? partFamilies() : sweptFamilies());
}

TopoDS_Face hills(Draw& draw) {
  const double waves = draw.between(0.5, 2.5);
  const double height = draw.between(0.1, 0.6) / waves;
  const double skew = draw.between(-1, 1);
  return surfaceThrough(24, 24, [=](double u, double v) {
    return gp_Pnt(8 * u + skew * v, 6 * v,
                  height * std::sin(kTurn * waves * u) * std::cos(kTurn * waves * v + skew));
  });
}

/// A sheet of hills, cut by a cylinder or by a box.
TopoDS_Shape trimmedHills(Draw& draw) {
  const TopoDS_Face face = hills(draw);
  const gp_Ax2 up(gp_Pnt(4, 3, -5), gp_Dir(draw.between(-0.3, 0.3), 0, 1));
  const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(up, draw.between(0.5, 3.5), 12).Shape();
  const int kind = draw.count(0, 3);
  if (kind == 0) return face;
  if (kind == 1) return cut(face, tool);
  if (kind == 2) return BRepAlgoAPI_Common(face, tool).Shape();
  return BRepAlgoAPI_Common(extruded(face, gp_Vec(0, 0, draw.between(0.2, 3))), tool).Shape();
}

/// A spline surface with one side, or two, drawn together into points.
TopoDS_Shape patchWithTips(Draw& draw) {
  const bool second = draw.chance(40);
  const double bulge = draw.between(-1.5, 1.5);
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  const double wide[] = {0, draw.between(0.2, 1), draw.between(0.2, 1), second ? 0.0 : 1.0};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double bump = i % 3 == 0 || j % 3 == 0 ? 0 : bulge;
      poles.SetValue(i + 1, j + 1, gp_Pnt(i, wide[i] * (j - 1.5), bump));
    }
  }
  const Handle(Geom_BezierSurface) surface = new Geom_BezierSurface(poles);
  return BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Face();
}

/// Tubes, closed one way or both, of splines with periods.
TopoDS_Shape closedSpline(Draw& draw) {
  const int columns = draw.count(5, 9);
  const int rows = draw.count(4, 9);
  const bool torus = draw.chance(50);
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i) {
    const double large = kTurn * i / rows;
    for (int j = 0; j < columns; ++j) {
      const double small = kTurn * j / columns;
      const double radius = draw.between(0.7, 1.3);
      const double out = radius * std::cos(small);
      const double up = radius * std::sin(small);
      poles.SetValue(i + 1, j + 1,
                     torus ? gp_Pnt((4 + out) * std::cos(large), (4 + out) * std::sin(large), up)
                           : gp_Pnt(out, up, 1.2 * i));
    }
  }
  const auto knots = [](int count) {
    TColStd_Array1OfReal made(1, count);
    for (int i = 1; i <= count; ++i) made.SetValue(i, i);
    return made;
  };
  const auto ones = [](int count, int ends) {
    TColStd_Array1OfInteger made(1, count);
    made.Init(1);
    made.SetValue(1, ends);
    made.SetValue(count, ends);
    return made;
  };
  const int knotsAlong = torus ? rows + 1 : rows - 2;
  const Handle(Geom_BSplineSurface) surface = new Geom_BSplineSurface(
      poles, knots(knotsAlong), knots(columns + 1), ones(knotsAlong, torus ? 1 : 4),
      ones(columns + 1, 1), 3, 3, torus, true);
  return BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Face();
}

/// A face with three to six sides, filled in between curves.
TopoDS_Shape filled(Draw& draw) {
  const int sides = draw.count(3, 6);
  std::vector<gp_Pnt> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = kTurn * i / sides;
    corners.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), draw.between(-0.7, 0.7));
  }
  BRepOffsetAPI_MakeFilling filling;
  for (int i = 0; i < sides; ++i) {
    const gp_Pnt& from = corners[static_cast<std::size_t>(i)];
    const gp_Pnt& to = corners[static_cast<std::size_t>((i + 1) % sides)];
    const gp_Pnt middle((from.X() + to.X()) * 0.55, (from.Y() + to.Y()) * 0.55,
                        draw.between(-0.7, 0.7));
    filling.Add(TopoDS::Edge(edgesOf(splineWire({from, middle, to}))[0]), GeomAbs_C0);
  }
  filling.Build();
  return filling.Shape();
}

TopoDS_Shape offsetSheet(Draw& draw) {
  BRepOffsetAPI_MakeOffsetShape offset;
  const TopoDS_Shape base = draw.chance(50) ? TopoDS_Shape(hills(draw)) : trimmedHills(draw);
  offset.PerformByJoin(base, draw.between(0.05, 0.4), 1e-5, BRepOffset_Skin, false, false,
                       GeomAbs_Intersection);
  return offset.Shape();
}

/// All surfaces made splines, as some programs write them.
TopoDS_Shape allSplines(Draw& draw) { return BRepBuilderAPI_NurbsConvert(anySolid(draw)).Shape(); }

/// Stretched by another factor along each axis: spheres become ellipsoids of splines.
TopoDS_Shape stretched(Draw& draw) {
  gp_GTrsf stretch;
  for (int i = 1; i <= 3; ++i) stretch.SetValue(i, i, draw.between(0.3, 3));
  return BRepBuilderAPI_GTransform(anyOf(draw, partFamilies()), stretch).Shape();
}

/// In microns, in kilometres, far from the origin, as the mirror image.
TopoDS_Shape elsewhere(Draw& draw) {
  gp_Trsf move;
  const double scales[] = {1e-3, 1.0 / 25.4, 25.4, 1e3};
  if (draw.chance(60)) {
    move.SetScale(gp_Pnt(), scales[draw.count(0, 3)]);
  } else if (draw.chance(50)) {
    move.SetTranslation(gp_Vec(draw.between(-1e4, 1e4), draw.between(-1e4, 1e4), 0));
  } else {
    move.SetMirror(draw.axes(3));
  }
  return BRepBuilderAPI_Transform(anySolid(draw), move, true).Shape();
}

/// Solids that share faces, edges or corners, with sheets in them or through them.
TopoDS_Shape sharedFaces(Draw& draw) {
  BOPAlgo_Builder builder;
  for (int i = draw.count(2, 4); i > 0; --i)
    builder.AddArgument(primitive(draw, draw.between(2, 5)));
  if (draw.chance(50)) {
    const gp_Ax2 axes = draw.axes(1);
    builder.AddArgument(flatFace(circle(axes, draw.between(1, 6))));
  }
  builder.Perform();
  return builder.HasErrors() ? TopoDS_Shape() : builder.Shape();
}

TopoDS_Shape oneFace(Draw& draw) {
  const std::vector<TopoDS_Shape> faces = facesOf(anySolid(draw));
  return faces.at(static_cast<std::size_t>(draw.count(0, static_cast<int>(faces.size()) - 1)));
}

}  // namespace

std::vector<Family> surfaceFamilies() {
  return {{"trimmed_hills", trimmedHills}, {"patch_with_tips", patchWithTips},
          {"closed_spline", closedSpline}, {"filled", filled},
          {"offset_sheet", offsetSheet},   {"all_splines", allSplines},
          {"stretched", stretched},        {"elsewhere", elsewhere},
          {"shared_faces", sharedFaces},   {"one_face", oneFace}};
}

}  // namespace af2::made
