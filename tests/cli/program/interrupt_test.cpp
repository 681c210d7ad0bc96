#include "cli/program/interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

namespace af2::cli {
namespace {

bool becomesTrue(const std::stop_token& token) {
  for (int i = 0; i < 200 && !token.stop_requested(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return token.stop_requested();
}

TEST(Interrupt, TurnsASignalIntoARequestToStop) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Interrupt interrupt;
    EXPECT_FALSE(interrupt.requested());
    ::kill(::getpid(), signal);
    EXPECT_TRUE(becomesTrue(interrupt.token()));
  }
}

TEST(Interrupt, TakesSignalsThatComeTogetherForOne) {
  Interrupt interrupt;
  for (int i = 0; i < 3; ++i) {
    ::kill(::getpid(), SIGTERM);
    EXPECT_TRUE(becomesTrue(interrupt.token()));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(interrupt.requested()) << "and the program still runs";
}

TEST(InterruptDeathTest, ASignalThatIsRepeatedAfterTheEndKeepsTheExitCode) {
  const auto endAfterSignals = [] {
    {
      Interrupt interrupt;
      ::kill(::getpid(), SIGINT);
      becomesTrue(interrupt.token());
    }
    ::kill(::getpid(), SIGINT);
    std::_Exit(4);
  };
  EXPECT_EXIT(endAfterSignals(), ::testing::ExitedWithCode(4), "");
}

TEST(Interrupt, KeepsASignalUntilItIsAskedFor) {
  Interrupt interrupt;
  ::kill(::getpid(), SIGINT);
  EXPECT_FALSE(interrupt.requested());
  EXPECT_TRUE(becomesTrue(interrupt.token()));
}

TEST(InterruptDeathTest, ASignalForWhichNobodyAskedKeepsTheExitCode) {
  const auto endAfterSignal = [] {
    {
      const Interrupt interrupt;
      ::kill(::getpid(), SIGTERM);
    }
    std::_Exit(5);
  };
  EXPECT_EXIT(endAfterSignal(), ::testing::ExitedWithCode(5), "");
}

TEST(Interrupt, EndsQuietlyIfNothingHappens) {
  Interrupt interrupt;
  EXPECT_FALSE(interrupt.requested());
}

}  // namespace
}  // namespace af2::cli
