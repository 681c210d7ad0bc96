#include "cli/playground/turns.h"

#include <gtest/gtest.h>

namespace af2::playground {
namespace {

using std::chrono::seconds;

TEST(Turns, ANewerRunOvertakesTheOneBefore) {
  Turns turns;
  const Turn first(turns, "mesh", 1, seconds(60));
  const Turn other(turns, "tests", 1, seconds(60));
  EXPECT_FALSE(first.isOvertaken());
  const Turn second(turns, "mesh", 2, seconds(60));
  EXPECT_TRUE(first.isOvertaken());
  EXPECT_FALSE(second.isOvertaken());
  EXPECT_FALSE(other.isOvertaken());
}

TEST(Turns, AnOlderRunThatComesLaterDoesNotBegin) {
  Turns turns;
  const Turn second(turns, "mesh", 2, seconds(60));
  const Turn first(turns, "mesh", 1, seconds(60));
  EXPECT_TRUE(first.isOvertaken());
  EXPECT_FALSE(second.isOvertaken());
}

TEST(Turns, ARunEndsWhenItsTimeIsOver) {
  Turns turns;
  const Turn turn(turns, "mesh", 1, seconds(0));
  while (!turn.token().stop_requested()) std::this_thread::yield();
  EXPECT_TRUE(turn.isLate());
  EXPECT_FALSE(turn.isOvertaken());
}

TEST(Turns, NothingRunsAfterTheEnd) {
  Turns turns;
  const Turn before(turns, "mesh", 1, seconds(60));
  turns.end();
  const Turn after(turns, "tests", 1, seconds(60));
  EXPECT_TRUE(before.token().stop_requested());
  EXPECT_TRUE(after.token().stop_requested());
}

}  // namespace
}  // namespace af2::playground
