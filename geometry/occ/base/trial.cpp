#include "geometry/occ/base/trial.h"

#if __has_include(<unistd.h>) && __has_include(<sys/wait.h>)
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace af2::geometry {

namespace {

/// A crash here is expected: no handler of the host program shall report it.
void forgetSignalHandlers() {
  for (const int signalNumber : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    ::signal(signalNumber, SIG_DFL);
}

[[noreturn]] void runInChild(const std::function<void()>& work) {
  forgetSignalHandlers();
  try {
    work();
  } catch (...) {  // the parent meets the same exception
  }
  ::_exit(0);
}

}  // namespace

bool survives(const std::function<void()>& work, std::chrono::seconds limit) {
  const pid_t child = ::fork();
  if (child < 0) return true;
  if (child == 0) runInChild(work);

  const auto end = std::chrono::steady_clock::now() + limit;
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return WIFEXITED(status);
}

}  // namespace af2::geometry

#else

namespace af2::geometry {
bool survives(const std::function<void()>&, std::chrono::seconds) { return true; }
}  // namespace af2::geometry

#endif
