#include "cli/program/interrupt.h"

#include <pthread.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

#include "cli/program/exit_code.h"

namespace af2::cli {
namespace {

sigset_t handledSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

// A thread that waits for the signals may call functions that a signal handler may not.
Interrupt::Interrupt() {
  const sigset_t signals = handledSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  waiting_ = std::thread([this] { waitForSignals(); });
}

Interrupt::~Interrupt() {
  over_ = true;
  pthread_kill(waiting_.native_handle(), SIGTERM);
  waiting_.join();
  // The run ends anyway: a signal that repeats the first one, as of `timeout`, must not change its
  // exit code.
  if (stop_.stop_requested()) return;
  const sigset_t signals = handledSignals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void Interrupt::waitForSignals() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kSame(500);
  const sigset_t signals = handledSignals();
  Clock::time_point first;
  while (true) {
    int signal = 0;
    sigwait(&signals, &signal);
    if (over_) return;
    if (!stop_.stop_requested()) {
      first = Clock::now();
      stop_.request_stop();
    } else if (Clock::now() - first > kSame) {
      std::_Exit(kCancelled);
    }
  }
}

}  // namespace af2::cli
