// Whole faces through each kind of chart: complete, on the surface, and told in the report.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <cmath>
#include <utility>

#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

ModelMesh mesh(const Model& model, double size, ChartKind chart) {
  MeshingOptions options = testing::ofSize(size);
  options.chart = chart;
  return testing::mesh(model, options);
}

/// distance  of a point from the curved face, which is face 1
template <class Distance>
void expectOnSurface(const ModelMesh& mesh, double size, Distance&& distance) {
  for (const FaceReport& face : mesh.faces) EXPECT_EQ(face.status, FaceStatus::Complete);
  EXPECT_TRUE(mesh.findings.empty());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.face[e] != 1) continue;
    for (const VertexId v : mesh.elements[e].vertices())
      EXPECT_LT(std::abs(distance(mesh.vertices[v.value])), 1e-6 * size);
  }
}

double fromTube(const Point3& p) { return length(Point2{p.x, p.y}) - 2; }
/// From the cone of radius 2 at z = 0 with its tip at z = 3.
double fromCone(const Point3& p) {
  return (length(Point2{p.x, p.y}) - 2 * (1 - p.z / 3)) * 3 / std::sqrt(13.0);
}

TEST(Charts, ACylinderIsMeshedThroughEachThatItHas) {
  for (const ChartKind kind :
       {ChartKind::MeanNormal, ChartKind::Parametric, ChartKind::Affine, ChartKind::Developed}) {
    const ModelMesh result = mesh(testing::cylinder(2, 3), 0.4, kind);
    expectOnSurface(result, 0.4, fromTube);
    EXPECT_EQ(result.faces[0].chart, toString(kind));
    EXPECT_EQ(result.faces[1].chart, "plane");
  }
}

/// Badness of the triangles of face 1, each laid flat: the largest and the mean.
std::pair<double, double> badnessOf(const ModelMesh& mesh, double size) {
  double worst = 0, sum = 0, count = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.face[e] != 1) continue;
    const auto v = mesh.elements[e].vertices();
    const Point3 a = mesh.vertices[v[0].value];
    const Point3 p = (1 / size) * (mesh.vertices[v[1].value] - a);
    const Point3 q = (1 / size) * (mesh.vertices[v[2].value] - a);
    const double along = dot(p, q) / length(p);
    const double badness = ShapeSizeMetric(10).triangleBadness(
        {0, 0}, {length(p), 0}, {along, length(cross(p, q)) / length(p)});
    worst = std::max(worst, badness);
    sum += badness;
    count += 1;
  }
  return {worst, sum / count};
}

TEST(Charts, ACylinderIsFinishedByTheScoreThroughEachThatItHas) {
  constexpr double kSize = 0.4;
  RuleSetDefinition definition = testing::triangleSetDefinition();
  definition.finish = Finish::Score;
  const AF2Algorithm byScore(std::make_shared<const RuleSet>(definition));
  for (const ChartKind kind :
       {ChartKind::MeanNormal, ChartKind::Parametric, ChartKind::Affine, ChartKind::Developed}) {
    MeshingOptions options = testing::ofSize(kSize);
    options.chart = kind;
    const ModelMesh finished = meshModel(testing::cylinder(2, 3), byScore, options);
    expectOnSurface(finished, kSize, fromTube);
    options.optimize = false;
    const ModelMesh raw = meshModel(testing::cylinder(2, 3), byScore, options);
    EXPECT_EQ(finished.elements.size(), raw.elements.size());
    EXPECT_LT(badnessOf(finished, kSize).first, badnessOf(raw, kSize).first) << toString(kind);
    EXPECT_LT(badnessOf(finished, kSize).second, badnessOf(raw, kSize).second) << toString(kind);
  }
}

TEST(Charts, AConeIsMeshedToItsTipThroughEachThatItHas) {
  for (const ChartKind kind :
       {ChartKind::MeanNormal, ChartKind::Parametric, ChartKind::Affine, ChartKind::Developed}) {
    const ModelMesh result = mesh(testing::cone(2, 0, 3), 0.3, kind);
    expectOnSurface(result, 0.3, fromCone);
    EXPECT_EQ(result.faces[0].chart, toString(kind));
  }
}

TEST(Charts, ASphereIsMeshedThroughEachThatItHas) {
  for (const ChartKind kind : {ChartKind::MeanNormal, ChartKind::Stereographic}) {
    const ModelMesh result = mesh(testing::sphere(2), 0.4, kind);
    expectOnSurface(result, 0.4, [](const Point3& p) { return length(p) - 2; });
    EXPECT_EQ(result.faces[0].chart, toString(kind));
  }
}

TEST(Charts, ATorusIsMeshedThroughEachThatItHas) {
  for (const ChartKind kind : {ChartKind::MeanNormal, ChartKind::NormalLines, ChartKind::Affine,
                               ChartKind::Parametric, ChartKind::Conformal}) {
    const ModelMesh result = mesh(testing::torus(2, 1), 0.4, kind);
    expectOnSurface(result, 0.4, [](const Point3& p) {
      return length(Point2{length(Point2{p.x, p.y}) - 2, p.z}) - 1;
    });
    EXPECT_EQ(result.faces[0].chart, toString(kind));
  }
}

/// A profile from (1, 0, 0) to (1, 0, 4) that bulges by one.
TopoDS_Edge profile() {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = gp_Pnt(1, 0, 0);
  poles(2) = gp_Pnt(3, 0, 2);
  poles(3) = gp_Pnt(1, 0, 4);
  return BRepBuilderAPI_MakeEdge(Handle(Geom_BezierCurve)(new Geom_BezierCurve(poles)));
}

TEST(Charts, ASurfaceOfRevolutionIsMeshedThroughEachThatItHas) {
  const auto bulge = BRepPrimAPI_MakeRevol(profile(), gp_Ax1({0, 0, 0}, {0, 0, 1})).Shape();
  for (const ChartKind kind : {ChartKind::MeanNormal, ChartKind::NormalLines, ChartKind::Affine,
                               ChartKind::Parametric, ChartKind::Conformal}) {
    const ModelMesh result = mesh(testing::modelOf(bulge), 0.4, kind);
    expectOnSurface(result, 0.4, [](const Point3& p) {
      const double t = p.z / 4;
      return length(Point2{p.x, p.y}) - (1 + 4 * t * (1 - t));
    });
    EXPECT_EQ(result.faces[0].chart, toString(kind));
  }
}

TEST(Charts, ASurfaceThatTouchesItsAxisHasNoConformalOnes) {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(3, 0, 0);
  poles(3) = gp_Pnt(2, 0, 2);
  const TopoDS_Edge bowl =
      BRepBuilderAPI_MakeEdge(Handle(Geom_BezierCurve)(new Geom_BezierCurve(poles)));
  const ModelMesh result =
      mesh(testing::modelOf(BRepPrimAPI_MakeRevol(bowl, gp_Ax1({0, 0, 0}, {0, 0, 1})).Shape()), 0.4,
           ChartKind::Conformal);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Complete);
  EXPECT_EQ(result.faces[0].chart, "mean-normal");
}

TEST(Charts, AnExtrusionIsMeshedThroughEachThatItHas) {
  // Askew, so that lengths along the curve are not those across the direction.
  const auto sheet = BRepPrimAPI_MakePrism(profile(), gp_Vec(0, 3, 1)).Shape();
  for (const ChartKind kind : {ChartKind::MeanNormal, ChartKind::NormalLines, ChartKind::Affine,
                               ChartKind::Parametric, ChartKind::Developed}) {
    const ModelMesh result = mesh(testing::modelOf(sheet), 0.4, kind);
    expectOnSurface(result, 0.4, [](const Point3& p) {
      const double t = (p.z - p.y / 3) / 4;
      return p.x - (1 + 4 * t * (1 - t));
    });
    EXPECT_EQ(result.faces[0].chart, toString(kind));
  }
}

/// From exchange and translation files they come as splines, with either parameter along.
TEST(Charts, AnExtrusionIsDevelopedWhateverItIsStoredAs) {
  const auto sheet = TopoDS::Face(BRepPrimAPI_MakePrism(profile(), gp_Vec(0, 3, 1)).Shape());
  const Handle(Geom_BSplineSurface) spline =
      GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(
          BRep_Tool::Surface(sheet), 0.0, 1.0, 0.0, std::sqrt(10.0)));
  spline->IncreaseDegree(3, 2);
  for (const bool isExchanged : {false, true}) {
    if (isExchanged) spline->ExchangeUV();
    const ModelMesh result =
        mesh(testing::modelOf(BRepBuilderAPI_MakeFace(spline, 1e-7).Shape()), 0.4, ChartKind::Auto);
    expectOnSurface(result, 0.4, [](const Point3& p) {
      const double t = (p.z - p.y / 3) / 4;
      return p.x - (1 + 4 * t * (1 - t));
    });
    EXPECT_EQ(result.faces[0].chart, "developed");
  }
}

/// Sizes near the radius of curvature, with nothing that makes them smaller: charts fold there.
template <class Normal>
void expectNoFolds(const Model& model, ChartKind kind, Normal&& normalAt) {
  static const AF2Algorithm algorithm(testing::triangleSet());
  for (const double size : {0.9, 0.7, 0.5}) {
    MeshingOptions options;
    options.sizes.size = size;
    TurnLimits none;
    none.faceTurn = none.edgeTurn = 1e3;
    options.threads = 1;
    options.chart = kind;
    const ModelMesh mesh = meshModel(model, algorithm, options, none);
    EXPECT_EQ(mesh.faces[0].status, FaceStatus::Complete) << toString(kind) << " " << size;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      if (mesh.face[e] != 1) continue;
      const auto at = [&](std::size_t i) {
        return mesh.vertices[mesh.elements[e].corners[i].value];
      };
      const Point3 turned = unit(cross(at(1) - at(0), at(2) - at(0)));
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_GT(dot(turned, normalAt(at(i))), 0) << toString(kind) << " " << size;
    }
  }
}

TEST(Charts, ProduceNoFoldsWhereSizesAreNearTheRadius) {
  for (const ChartKind kind : {ChartKind::Auto, ChartKind::MeanNormal, ChartKind::NormalLines,
                               ChartKind::Affine, ChartKind::Parametric, ChartKind::Developed,
                               ChartKind::Stereographic, ChartKind::Conformal}) {
    expectNoFolds(testing::cylinder(1, 3), kind, [](const Point3& p) {
      return Point3{p.x, p.y, 0};
    });
    expectNoFolds(testing::sphere(1), kind, [](const Point3& p) { return p; });
    expectNoFolds(testing::torus(3, 1), kind, [](const Point3& p) {
      return p - (3 / length(Point2{p.x, p.y})) * Point3{p.x, p.y, 0};
    });
  }
}

TEST(Charts, AreChosenByTheSurface) {
  EXPECT_EQ(mesh(testing::torus(2, 1), 0.4, ChartKind::Auto).faces[0].chart, "conformal");
  EXPECT_EQ(mesh(testing::sphere(2), 0.4, ChartKind::Auto).faces[0].chart, "stereographic");
  EXPECT_EQ(mesh(testing::cylinder(2, 3), 0.4, ChartKind::Auto).faces[0].chart, "developed");
  EXPECT_EQ(mesh(testing::cone(2, 1, 3), 0.4, ChartKind::Auto).faces[0].chart, "developed");
  EXPECT_EQ(mesh(testing::box(1, 1, 1), 0.4, ChartKind::Auto).faces[0].chart, "plane");
}

TEST(Charts, AFaceThatHasNoSuchChartIsMeshedWithAnother) {
  const ModelMesh result = mesh(testing::torus(2, 1), 0.4, ChartKind::Developed);
  EXPECT_EQ(result.faces[0].status, FaceStatus::Complete);
  EXPECT_NE(result.faces[0].chart, "developed");
  EXPECT_TRUE(result.faces[0].attempts.empty());  // nothing failed
}

TEST(Charts, HaveNames) {
  for (const ChartKind kind :
       {ChartKind::Auto, ChartKind::MeanNormal, ChartKind::Parametric, ChartKind::NormalLines,
        ChartKind::Affine, ChartKind::Developed, ChartKind::Stereographic, ChartKind::Conformal})
    EXPECT_EQ(chartKindOf(toString(kind)), kind);
  EXPECT_EQ(chartKindOf("plane"), std::nullopt);  // follows from the face, is not asked for
  EXPECT_EQ(chartKindOf(""), std::nullopt);
}

}  // namespace
}  // namespace af2::geometry
