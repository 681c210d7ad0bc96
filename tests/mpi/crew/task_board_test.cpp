#include "geometry/mpi/crew/task_board.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"

namespace af2::mpi {
namespace {

std::vector<std::uint64_t> numbersOf(const std::optional<Task>& task) {
  std::vector<std::uint64_t> numbers;
  for (const NumberedTry& one : task->tries) numbers.push_back(one.number);
  return numbers;
}

TEST(TaskBoard, GivesLargeTasksOneByOneAndSmallOnesTogether) {
  TaskBoard board(2);
  const std::vector<double> work{1, 1, 50, 1, 1, 1, 1, 100};
  const std::uint64_t round = board.begin(std::vector<geometry::FaceTry>(work.size()), work);
  EXPECT_EQ(numbersOf(board.takeIfAny(round)), std::vector<std::uint64_t>{7});
  EXPECT_EQ(numbersOf(board.takeIfAny(round)), std::vector<std::uint64_t>{2});
  EXPECT_EQ(numbersOf(board.takeIfAny(round)), std::vector<std::uint64_t>{0});
  board.finish(8);
  EXPECT_EQ(board.takeIfAny(round)->kind, TaskKind::Over);
}

TEST(TaskBoard, SendsNoMoreThreadsToAFaceThanItHasPieces) {
  TaskBoard board(4);
  const std::uint64_t round = board.begin(std::vector<geometry::FaceTry>(1), std::vector{9.0});
  board.takeIfAny(round);
  EXPECT_FALSE(board.takeIfAny(round).has_value()) << "there may be pieces later";
  const RegionKey region{round, 0, 1};
  board.offer(region, 3, std::vector{1.0, 5.0, 2.0});
  EXPECT_EQ(board.nextPiece(region, false), 1u);
  for (int i = 0; i < 2; ++i) {
    const std::optional<Task> help = board.takeIfAny(round);
    EXPECT_EQ(help->kind, TaskKind::Help);
    EXPECT_EQ(help->owner, 3);
  }
  EXPECT_FALSE(board.takeIfAny(round).has_value());
  EXPECT_EQ(board.nextPiece(region, true), 2u);
  EXPECT_EQ(board.nextPiece({round, 0, 2}, true), std::nullopt) << "it was cut in another way";
  EXPECT_EQ(board.nextPiece(region, true), 0u);
  EXPECT_EQ(board.nextPiece(region, false), std::nullopt);
}

TEST(TaskBoard, KnowsThatAskingForAnOldRoundMeansThatItIsOver) {
  TaskBoard board(1);
  const std::uint64_t old = board.begin(std::vector<geometry::FaceTry>(1), std::vector{1.0});
  board.begin(std::vector<geometry::FaceTry>(1), std::vector{1.0});
  EXPECT_EQ(board.takeIfAny(old)->kind, TaskKind::Over);
}

TEST(TaskBoard, EndsAllRoundsWhenSomebodyGivesUp) {
  TaskBoard board(1);
  const std::uint64_t round = board.begin(std::vector<geometry::FaceTry>(2), std::vector{1.0, 1.0});
  board.giveUp("rank 1: no memory");
  board.giveUp("rank 2: follows from it");
  EXPECT_EQ(board.take(round).kind, TaskKind::Over);
  try {
    board.check();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "rank 1: no memory");
  }
}

}  // namespace
}  // namespace af2::mpi
