#include "geometry/mesh/face_history.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

TEST(FaceHistory, TellsEachStepInWords) {
  const FaceHistory history{
      note("a gap was closed"),
      failedWay("plane charts", {FillFaultKind::TooManyCandidates, "9 elements"}),
      failedFace("all failed"),
      crossingElements(3),
      triedRemedy("shorter edges", 2),
      triedRemedy("another surface", 0)};
  EXPECT_EQ(
      textsOf(history),
      (std::vector<std::string>{
          "a gap was closed",
          "plane charts: the front examined too many candidates, so it was stopped: 9 elements",
          "all failed", "3 pairs of elements cross here", "shorter edges at 2 places",
          "another surface"}));
}

TEST(FaceHistory, DoesNotRepeatWhatIsSoAtEachTry) {
  FaceHistory history{note("a gap was closed")};
  addNew({note("a gap was closed"), failedWay("plane charts", {FillFaultKind::Stuck, "here"})},
         history);
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[1].kind, FaceStepKind::WayFailed);
}

TEST(FaceHistory, TellsFaultsApartByTheirDetails) {
  const FillFault here{FillFaultKind::Stuck, "at (0, 0)"}, there{FillFaultKind::Stuck, "at (1, 0)"};
  EXPECT_NE(here, there);
  EXPECT_EQ(textOf(here), "at (0, 0)");
  EXPECT_TRUE(FillFault{}.isNone());
}

}  // namespace
}  // namespace af2::geometry
