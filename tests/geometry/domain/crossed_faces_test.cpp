#include "geometry/domain/crossed_faces.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

Crossing crossingOf(int one, int other, const Point3& place) {
  Crossing crossing;
  crossing.faces = {one, other};
  crossing.place = place;
  crossing.widths = {0.5, 1};
  return crossing;
}

FaceReport failedFace(int id, FailureCause cause = FailureCause::Unknown) {
  FaceReport face;
  face.id = id;
  face.status = FaceStatus::Failed;
  face.reason = "stuck";
  face.cause = cause;
  return face;
}

TEST(CrossedFaces, AreWhereAFaceCrossesAnotherInTheModelToo) {
  const std::vector<FacesCross> model = {{{2, 5}, {1, 0, 0}}};
  EXPECT_TRUE(crossInModel(model, 5, {crossingOf(4, 5, {1.9, 0, 0})}));
  EXPECT_TRUE(crossInModel(model, 2, {crossingOf(2, 4, {1.9, 0, 0})}));
  EXPECT_FALSE(crossInModel(model, 5, {crossingOf(4, 5, {2.1, 0, 0})})) << "too far away";
  EXPECT_FALSE(crossInModel(model, 4, {crossingOf(4, 5, {1.9, 0, 0})})) << "another face";
  EXPECT_FALSE(crossInModel(model, 5, {crossingOf(3, 4, {1, 0, 0})})) << "others cross";
  EXPECT_FALSE(crossInModel({}, 5, {crossingOf(4, 5, {1, 0, 0})}));
}

TEST(CrossedFaces, ExplainFailures) {
  std::vector<FaceReport> faces = {failedFace(1), failedFace(2), failedFace(3),
                                   failedFace(4, FailureCause::Size), FaceReport{}};
  faces[4].id = 5;
  tellOfCrossings(
      {{{5, 2}, {1, 2, 3}}, {{2, 3}, {4, 4, 4}}, {{4, 5}, {1, 1, 1}}, {{1, 1}, {7, 8, 9}}}, faces);
  EXPECT_EQ(faces[0].reason, "stuck; in the model itself it crosses itself at (7, 8, 9)");
  EXPECT_EQ(faces[1].reason, "stuck; in the model itself it crosses face 5 at (1, 2, 3)");
  EXPECT_EQ(faces[2].reason, "stuck; in the model itself it crosses face 2 at (4, 4, 4)");
  EXPECT_EQ(faces[1].cause, FailureCause::Model);
  EXPECT_EQ(faces[3].reason, "stuck") << "it is explained already";
  EXPECT_EQ(faces[3].cause, FailureCause::Size);
  EXPECT_TRUE(faces[4].reason.empty()) << "it has not failed";
}

}  // namespace
}  // namespace af2::geometry
