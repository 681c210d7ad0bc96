#include "cli/program/interrupt.h"

#include <pthread.h>

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

Interrupt::Interrupt() {
  const sigset_t signals = handledSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

Interrupt::~Interrupt() {
  if (waiting_.joinable()) {
    over_ = true;
    pthread_kill(waiting_.native_handle(), SIGTERM);
    waiting_.join();
  } else {
    takeKept();
  }
  // The run ends anyway: a signal that repeats the first one, as of `timeout`, must not change its
  // exit code.
  if (stop_.stop_requested()) return;
  const sigset_t signals = handledSignals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

// A thread that waits for the signals may call functions that a signal handler may not.
std::stop_token Interrupt::token() {
  if (!waiting_.joinable()) waiting_ = std::thread([this] { waitForSignals(); });
  return stop_.get_token();
}

void Interrupt::takeKept() {
  const sigset_t signals = handledSignals();
  const timespec atOnce{};
  while (sigtimedwait(&signals, nullptr, &atOnce) > 0) stop_.request_stop();
}

void Interrupt::waitForSignals() {
  const sigset_t signals = handledSignals();
  StopRequests requests;
  while (true) {
    int signal = 0;
    sigwait(&signals, &signal);
    if (over_) return;
    if (requests.addAndTestAgain()) std::_Exit(kCancelled);
    stop_.request_stop();
  }
}

}  // namespace af2::cli
