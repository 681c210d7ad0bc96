#include "geometry/fill/closing_way.h"

#include <gtest/gtest.h>

#include "geometry/fill/boundary_alone_way.h"
#include "geometry/fill/close_front.h"
#include "geometry/mesh/without_rule.h"
#include "tests/geometry/fill/flat_face.h"

namespace af2::geometry {
namespace {

FaceAttempt stuckAtOnce(const FaceTask& task) {
  FaceAttempt attempt;
  attempt.fault = {FillFaultKind::Stuck, "at once"};
  attempt.result = frontBeforeFirstStep(task.boundary.input);
  attempt.searchCost = 100;
  return attempt;
}

TEST(ClosingWay, ClosesTheFirstFrontThatCanBeClosed) {
  const testing::FlatFace face({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const FaceTask task = face.task();
  FillState state{task};
  state.failed.emplace_back().fault = {FillFaultKind::Unsound, "no front is left of it"};
  state.failed.push_back(stuckAtOnce(task));
  const FaceAttempt closed = fillByClosing(state);
  EXPECT_TRUE(closed.fault.isNone());
  const ElementOrigin closing = originOf(WithoutRule::Closing, task.algorithm.rules());
  EXPECT_EQ(closed.result.mesh.origins, (std::vector{closing, closing}));
  EXPECT_EQ(closed.searchCost, 0u) << "what the front cost is counted already";
}

TEST(ClosingWay, LeavesNothingBehindWhereNothingCanBeClosed) {
  const testing::FlatFace face(testing::crossedLoop());
  const FaceTask task = face.task();
  FillState state{task};
  state.failed.push_back(stuckAtOnce(task));
  EXPECT_EQ(fillByClosing(state).fault.kind, FillFaultKind::NotFilled);
  EXPECT_EQ(state.failed[0].fault.kind, FillFaultKind::Stuck);
  EXPECT_FALSE(closeStuck(task, state.failed[0], kMaxStuckEdges));
}

}  // namespace
}  // namespace af2::geometry
