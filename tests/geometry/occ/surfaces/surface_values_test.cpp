#include "geometry/occ/surfaces/surface_values.h"

#include <gtest/gtest.h>

#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <random>

#include "geometry/occ/base/points.h"

namespace af2::geometry {
namespace {

/// A basis as OpenCASCADE wants it: uneven knots, some of them multiple.
struct OccBasis {
  TColStd_Array1OfReal knots;
  TColStd_Array1OfInteger multiplicities;
  int poles = 0;

  OccBasis(int degree, int spans, bool periodic, std::mt19937& random)
      : knots(1, spans + 1), multiplicities(1, spans + 1) {
    std::uniform_real_distribution<double> width(0.05, 2);
    std::uniform_int_distribution<int> multiplicity(1, std::max(1, degree - 1));
    double at = -1.5;
    for (int k = 1; k <= spans + 1; ++k, at += width(random)) {
      knots(k) = at;
      const bool isEnd = k == 1 || k > spans;
      multiplicities(k) = !isEnd ? multiplicity(random) : periodic ? 1 : degree + 1;
      poles += multiplicities(k);
    }
    poles -= periodic ? multiplicities(spans + 1) : degree + 1;
  }
};

struct Shape {
  int uDegree, vDegree, uSpans, vSpans;
  bool uPeriodic = false, vPeriodic = false, rational = false;
};

Handle(Geom_BSplineSurface) makeSpline(const Shape& shape, std::mt19937& random) {
  const OccBasis u(shape.uDegree, shape.uSpans, shape.uPeriodic, random);
  const OccBasis v(shape.vDegree, shape.vSpans, shape.vPeriodic, random);
  TColgp_Array2OfPnt poles(1, u.poles, 1, v.poles);
  TColStd_Array2OfReal weights(1, u.poles, 1, v.poles);
  std::uniform_real_distribution<double> offset(-0.6, 0.6), weight(0.5, 2);
  for (int i = 1; i <= u.poles; ++i)
    for (int j = 1; j <= v.poles; ++j) {
      poles(i, j) = gp_Pnt(i + offset(random), j + offset(random), offset(random));
      weights(i, j) = shape.rational ? weight(random) : 1;
    }
  return new Geom_BSplineSurface(poles, weights, u.knots, v.knots, u.multiplicities,
                                 v.multiplicities, shape.uDegree, shape.vDegree, shape.uPeriodic,
                                 shape.vPeriodic);
}

SplineSurface::Box wholeOf(const Handle(Geom_Surface) & surface) {
  SplineSurface::Box box{};
  surface->Bounds(box.u1, box.u2, box.v1, box.v2);
  return box;
}

/// What OpenCASCADE gives, and what derivatives of first and second order are compared with.
struct OccValues {
  SurfaceJet jet;
  double first, second;

  OccValues(const Handle(Geom_Surface) & surface, double u, double v) {
    gp_Pnt p;
    gp_Vec du, dv, duu, dvv, duv;
    surface->D2(u, v, p, du, dv, duu, dvv, duv);
    jet = {toPoint(p), toPoint(du), toPoint(dv), toPoint(duu), toPoint(duv), toPoint(dvv)};
    first = 1 + length(jet.du) + length(jet.dv);
    second = first + length(jet.duu) + length(jet.duv) + length(jet.dvv);
  }
};

/// The values agree to 1e-13 of what such a surface can have, derivatives included.
void expectSame(const SurfaceJet& ours, const Handle(Geom_Surface) & surface, double u, double v) {
  const auto [occ, first, second] = OccValues(surface, u, v);
  EXPECT_LE(distance(ours.position, occ.position), 1e-13 * 20);
  EXPECT_LE(distance(ours.du, occ.du), 1e-12 * first);
  EXPECT_LE(distance(ours.dv, occ.dv), 1e-12 * first);
  EXPECT_LE(distance(ours.duu, occ.duu), 1e-11 * second);
  EXPECT_LE(distance(ours.duv, occ.duv), 1e-11 * second);
  EXPECT_LE(distance(ours.dvv, occ.dvv), 1e-11 * second);
}

/// Of the second derivatives, only the parts along the normal.
void expectSameBend(const SurfaceJet& ours, const Handle(Geom_Surface) & surface, double u,
                    double v) {
  const auto [occ, first, second] = OccValues(surface, u, v);
  EXPECT_LE(distance(ours.position, occ.position), 1e-12 * 20);
  EXPECT_LE(distance(ours.du, occ.du), 1e-10 * second);
  EXPECT_LE(distance(ours.dv, occ.dv), 1e-10 * second);
  const Point3 normal = unit(cross(occ.du, occ.dv));
  EXPECT_NEAR(dot(ours.duu, normal), dot(occ.duu, normal), 1e-8 * second);
  EXPECT_NEAR(dot(ours.duv, normal), dot(occ.duv, normal), 1e-8 * second);
  EXPECT_NEAR(dot(ours.dvv, normal), dot(occ.dvv, normal), 1e-8 * second);
}

void expectAgreement(const Handle(Geom_Surface) & surface, std::mt19937& random) {
  const SplineSurface::Box box = wholeOf(surface);
  const GeomAdaptor_Surface adaptor(surface);
  const auto definition = splineDefinitionOf(adaptor, box);
  ASSERT_TRUE(definition);
  const auto spline = SplineSurface::make(*definition, box);
  ASSERT_TRUE(spline);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 60; ++i) {
    const double u = box.u1 + share(random) * (box.u2 - box.u1);
    const double v = box.v1 + share(random) * (box.v2 - box.v1);
    const auto jet = spline->jetAt(u, v);
    ASSERT_TRUE(jet);
    expectSame(*jet, surface, u, v);
    const auto frame = spline->frameAt(u, v);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->position, jet->position);
    EXPECT_EQ(frame->du, jet->du);
    EXPECT_EQ(frame->dv, jet->dv);
  }
  for (const double u : {box.u1, box.u2})
    for (const double v : {box.v1, box.v2}) expectSame(*spline->jetAt(u, v), surface, u, v);
}

/// By their definition, in long double: OpenCASCADE loses digits where the degree is high.
using Real = long double;
Real basisAt(const std::vector<double>& t, std::size_t i, int degree, Real x) {
  if (degree == 0) return t[i] <= x && x < t[i + 1] ? 1 : 0;
  const auto p = static_cast<std::size_t>(degree);
  Real sum = 0;
  if (t[i] < t[i + p]) sum += (x - t[i]) / (Real(t[i + p]) - t[i]) * basisAt(t, i, degree - 1, x);
  if (t[i + 1] < t[i + p + 1])
    sum += (t[i + p + 1] - x) / (Real(t[i + p + 1]) - t[i + 1]) * basisAt(t, i + 1, degree - 1, x);
  return sum;
}

Point3 positionByDefinition(const SplineDefinition& definition, double u, double v) {
  std::array<Real, 4> sum{};
  for (std::size_t i = 0; i < definition.u.poleCount(); ++i) {
    const Real alongU = basisAt(definition.u.knots, i, definition.u.degree, u);
    for (std::size_t j = 0; alongU != 0 && j < definition.v.poleCount(); ++j) {
      const std::size_t pole = i * definition.v.poleCount() + j;
      const Real share = alongU * basisAt(definition.v.knots, j, definition.v.degree, v) *
                         definition.weights[pole];
      sum[0] += share * definition.poles[pole].x;
      sum[1] += share * definition.poles[pole].y;
      sum[2] += share * definition.poles[pole].z;
      sum[3] += share;
    }
  }
  return {double(sum[0] / sum[3]), double(sum[1] / sum[3]), double(sum[2] / sum[3])};
}

TEST(SurfaceValues, OfHighDegreesAreThoseOfTheDefinition) {
  std::mt19937 random(20257);
  for (const int degree : {8, 11, 14}) {
    const Handle(Geom_Surface) surface = makeSpline({degree, 3, 3, 2, false, false, true}, random);
    const SplineSurface::Box box = wholeOf(surface);
    const auto definition = splineDefinitionOf(GeomAdaptor_Surface(surface), box);
    const SurfaceValues values(surface, box);
    for (const double share : {0.0, 0.13, 0.41, 0.77, 0.99}) {
      const double u = box.u1 + share * (box.u2 - box.u1), v = box.v1 + 0.3 * (box.v2 - box.v1);
      EXPECT_LT(distance(values.frameAt(u, v).position, positionByDefinition(*definition, u, v)),
                1e-13);
    }
  }
}

TEST(SurfaceValues, OfSplinesAreThoseOfOpenCascade) {
  std::mt19937 random(20251);
  for (int uDegree = 1; uDegree <= 7; ++uDegree)
    for (int vDegree = 1; vDegree <= 7; vDegree += 2)
      for (const bool rational : {false, true})
        expectAgreement(
            makeSpline({uDegree, vDegree, 1 + uDegree % 4, 5, false, false, rational}, random),
            random);
}

TEST(SurfaceValues, OfPeriodicSplinesAreThoseOfOpenCascade) {
  std::mt19937 random(20252);
  for (int degree = 1; degree <= 6; ++degree)
    for (const bool rational : {false, true}) {
      expectAgreement(makeSpline({degree, 3, 12, 3, true, false, rational}, random), random);
      expectAgreement(makeSpline({2, degree, 3, 12, false, true, rational}, random), random);
      expectAgreement(makeSpline({degree, degree, 12, 12, true, true, rational}, random), random);
    }
}

TEST(SurfaceValues, OfPeriodicSplinesAreTheSameOnePeriodOn) {
  std::mt19937 random(20253);
  const Handle(Geom_Surface) surface = makeSpline({3, 2, 9, 4, true, false, false}, random);
  const SplineSurface::Box box = wholeOf(surface);
  const SurfaceValues values(surface, {box.u1 + 1, box.u2 + 1, box.v1, box.v2});
  const double u = (box.u1 + box.u2) / 2, v = (box.v1 + box.v2) / 2, period = box.u2 - box.u1;
  EXPECT_LT(distance(values.frameAt(u, v).position, values.frameAt(u + period, v).position), 1e-12);
  EXPECT_LT(distance(values.frameAt(u, v).position, values.frameAt(u - period, v).position), 1e-12);
}

TEST(SurfaceValues, OfBezierSurfacesAreThoseOfOpenCascade) {
  std::mt19937 random(20254);
  std::uniform_real_distribution<double> offset(-0.5, 0.5), weight(0.5, 2);
  for (int degree = 1; degree <= 8; ++degree) {
    TColgp_Array2OfPnt poles(1, degree + 1, 1, 4);
    TColStd_Array2OfReal weights(1, degree + 1, 1, 4);
    for (int i = 1; i <= degree + 1; ++i)
      for (int j = 1; j <= 4; ++j) {
        poles(i, j) = gp_Pnt(i + offset(random), j + offset(random), offset(random));
        weights(i, j) = weight(random);
      }
    expectAgreement(new Geom_BezierSurface(poles), random);
    expectAgreement(new Geom_BezierSurface(poles, weights), random);
  }
}

TEST(SurfaceValues, OfExtrudedSplinesAreThoseOfOpenCascade) {
  std::mt19937 random(20255);
  for (const bool periodic : {false, true}) {
    const Handle(Geom_BSplineSurface) spline =
        makeSpline({3, 1, 10, 1, periodic, false, true}, random);
    const Handle(Geom_Curve) section = spline->VIso(-1.5);
    const Handle(Geom_Surface) extrusion =
        new Geom_SurfaceOfLinearExtrusion(section, gp_Dir(0.1, 0.2, 1));
    const double u1 = section->FirstParameter(), u2 = section->LastParameter();
    expectAgreement(new Geom_RectangularTrimmedSurface(extrusion, u1, u2, -3.0, 7.0), random);
  }
}

TEST(SurfaceValues, OfOffsetsAreThoseOfOpenCascade) {
  std::mt19937 random(20257);
  std::uniform_real_distribution<double> share(0, 1);
  for (const bool rational : {false, true})
    for (const double distance : {0.02, -0.3}) {
      const Handle(Geom_Surface) surface = new Geom_OffsetSurface(
          makeSpline({3, 4, 6, 5, false, false, rational}, random), distance);
      const SplineSurface::Box box = wholeOf(surface);
      const SurfaceValues values(surface, box), copy = values;
      for (int i = 0; i < 60; ++i) {
        const double u = box.u1 + share(random) * (box.u2 - box.u1);
        const double v = box.v1 + share(random) * (box.v2 - box.v1);
        const SurfaceJet bend = values.bendAt(u, v);
        const SurfaceFrame frame = copy.frameAt(u, v);
        EXPECT_EQ(frame.position, bend.position);
        EXPECT_EQ(frame.du, bend.du);
        EXPECT_EQ(frame.dv, bend.dv);
        expectSameBend(bend, surface, u, v);
        expectSame(values.jetAt(u, v), surface, u, v);
      }
    }
}

/// Where the base has no normal, OpenCASCADE knows what to do.
TEST(SurfaceValues, OfOffsetsFromPolesAreThoseOfOpenCascade) {
  TColgp_Array2OfPnt poles(1, 3, 1, 2);
  for (int i = 1; i <= 3; ++i) {
    poles(i, 1) = gp_Pnt(i - 2, i == 2 ? -1 : 0, 0);
    poles(i, 2) = gp_Pnt(0, 0, 1);
  }
  const Handle(Geom_Surface) surface = new Geom_OffsetSurface(new Geom_BezierSurface(poles), 0.1);
  const SurfaceValues values(surface, wholeOf(surface));
  gp_Pnt pole;
  surface->D0(0.5, 1, pole);
  EXPECT_LT(distance(values.frameAt(0.5, 1).position, toPoint(pole)), 1e-9);
}

TEST(SurfaceValues, AreThoseOfOpenCascadeOutsideTheBox) {
  std::mt19937 random(20256);
  const Handle(Geom_Surface) surface = makeSpline({3, 3, 20, 20, false, false, false}, random);
  const SplineSurface::Box whole = wholeOf(surface);
  const SplineSurface::Box corner{whole.u1, whole.u1 + 0.01, whole.v1, whole.v1 + 0.01};
  const auto definition = splineDefinitionOf(GeomAdaptor_Surface(surface), corner);
  const auto spline = SplineSurface::make(*definition, corner);
  ASSERT_TRUE(spline);
  EXPECT_TRUE(spline->frameAt(whole.u1, whole.v1));
  EXPECT_FALSE(spline->frameAt(whole.u2, whole.v2));
  const SurfaceValues values(surface, corner);
  expectSame(values.jetAt(whole.u2 - 0.01, whole.v2 - 0.01), surface, whole.u2 - 0.01,
             whole.v2 - 0.01);
}

}  // namespace
}  // namespace af2::geometry
