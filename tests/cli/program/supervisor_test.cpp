#include "cli/program/supervisor.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

#include "cli/program/exit_code.h"
#include "cli/program/interrupt.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

/// The child goes on with the test program: it must end here, and say nothing.
int runHere(const RunLimits& limits, const std::function<int(RunLog&, const GivenUp&)>& run) {
  const pid_t self = getpid();
  const int code = supervise(limits, run);
  if (getpid() != self) _exit(code);
  return code;
}

[[noreturn]] void spin() {
  std::atomic<bool> forever = true;
  while (forever) {
  }
  _exit(0);
}

TEST(Supervisor, GivesTheExitCodeOfTheRun) {
  EXPECT_EQ(runHere({}, [](RunLog&, const GivenUp&) { return 3; }), 3);
}

TEST(Supervisor, LeavesOutTheFaceThatCrashes) {
  const int code = runHere({}, [](RunLog& log, const GivenUp& givenUp) {
    log.begin(4);
    log.finish();
    log.begin(7);
    if (!givenUp.contains(7)) std::raise(SIGSEGV);
    return givenUp.size() == 1 ? 5 : 6;
  });
  EXPECT_EQ(code, 5);
}

TEST(Supervisor, LeavesOutSeveralFacesOneAfterTheOther) {
  const int code = runHere({}, [](RunLog& log, const GivenUp& givenUp) {
    for (const int face : {1, 2, 3}) {
      if (givenUp.contains(face)) continue;
      log.begin(face);
      if (face != 2) std::raise(SIGABRT);
      log.finish();
    }
    return static_cast<int>(givenUp.size());
  });
  EXPECT_EQ(code, 2);
}

/// As while it reads a model: it keeps the requests.
TEST(Supervisor, EndsARunThatDoesNotListenAtTheSecondRequest) {
  const int code = runHere({}, [](RunLog&, const GivenUp&) {
    const Interrupt interrupt;
    kill(getppid(), SIGTERM);
    std::this_thread::sleep_for(kSameRequest + std::chrono::milliseconds(200));
    kill(getppid(), SIGTERM);
    std::this_thread::sleep_for(std::chrono::seconds(20));
    return 0;
  });
  EXPECT_EQ(code, kCancelled);
}

TEST(Supervisor, LeavesOutTheFaceThatDoesNotEnd) {
  const int code = runHere({1, 0.2}, [](RunLog& log, const GivenUp& givenUp) {
    log.begin(9);
    if (!givenUp.contains(9)) spin();
    return givenUp.at(9).find("no progress in 0.2 s") != std::string::npos ? 5 : 6;
  });
  EXPECT_EQ(code, 5);
}

TEST(Supervisor, WaitsHalfAsLongAfterEachHang) {
  const int code = runHere({1, 0.8}, [](RunLog& log, const GivenUp& givenUp) {
    for (const int face : {1, 2, 3}) {
      log.begin(face);
      if (!givenUp.contains(face)) spin();
      log.finish();
    }
    std::string limits;
    for (const auto& [face, why] : givenUp) limits += why.substr(why.find(" in ")) + ";";
    const std::string ending = " s of processor time;";
    return limits == " in 0.8" + ending + " in 0.4" + ending + " in 0.2" + ending ? 5 : 6;
  });
  EXPECT_EQ(code, 5);
}

TEST(Supervisor, LetsWhatComesAfterTheFacesTakeItsTime) {
  const int code = runHere({1, 0.2}, [](RunLog& log, const GivenUp&) {
    log.begin(9);
    log.finish();
    const std::clock_t end = std::clock() + CLOCKS_PER_SEC;
    while (std::clock() < end) {
    }
    return 7;
  });
  EXPECT_EQ(code, 7);
}

TEST(Supervisor, TellsOfACrashOutsideOfFaces) {
  EXPECT_THROW(runHere({},
                       [](RunLog&, const GivenUp&) -> int {
                         std::raise(SIGSEGV);
                         return 0;
                       }),
               InputError);
}

TEST(Supervisor, TellsOfAHangOutsideOfFaces) {
  EXPECT_THROW(runHere({0.2, 1}, [](RunLog&, const GivenUp&) -> int { spin(); }), InputError);
}

TEST(Supervisor, EndsLikeTheRunWhenNobodyReadsItsOutput) {
  const auto run = [](RunLog&, const GivenUp&) { return std::raise(SIGPIPE); };
  EXPECT_EXIT(supervise({}, run), ::testing::KilledBySignal(SIGPIPE), "^$");
}

TEST(Supervisor, PassesOnThatTheRunWasEndedFromOutside) {
  EXPECT_THROW(runHere({},
                       [](RunLog&, const GivenUp&) -> int {
                         std::raise(SIGKILL);
                         return 0;
                       }),
               InputError);
}

}  // namespace
}  // namespace af2::cli
