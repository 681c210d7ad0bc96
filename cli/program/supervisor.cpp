#include "cli/program/supervisor.h"

#include <fmt/core.h>

#include "cli/program/exit_code.h"
#include "cli/program/interrupt.h"
#include "engine/base/error.h"

#if __has_include(<sys/wait.h>) && __has_include(<sys/mman.h>)
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#if __has_include(<sys/prctl.h>)
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <new>
#include <optional>
#include <set>

namespace af2::cli {
namespace {

/// Lies in memory that both processes share.
struct SharedLog {
  static constexpr std::size_t kThreads = 1024;
  std::atomic<std::uint64_t> beats = 0;
  std::atomic<int> threads = 0;
  std::atomic<int> crashed = 0;  ///< the face of the thread that crashed
  std::array<std::atomic<int>, kThreads> face{};
};

// Global because a signal handler can reach nothing else.
SharedLog* crashLog = nullptr;
thread_local int crashFace = 0;
thread_local int threadSlot = -1;

class ChildLog final : public RunLog {
 public:
  explicit ChildLog(SharedLog& log) : log_(log) {}
  void begin(int face) override {
    note(face);
    beat();
  }
  void finish() override {
    note(0);
    beat();
  }
  void beat() override { ++log_.beats; }

 private:
  void note(int face) {
    crashFace = face;
    if (threadSlot < 0) threadSlot = log_.threads++;
    if (static_cast<std::size_t>(threadSlot) < SharedLog::kThreads)
      log_.face[static_cast<std::size_t>(threadSlot)] = face;
  }
  SharedLog& log_;
};

constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// Records the face at fault and raises the signal again with its default action, which ends the
/// process.
extern "C" void noteCrash(int signal) {
  crashLog->crashed = crashFace;
  raise(signal);
}

void catchCrashes(SharedLog& log) {
  crashLog = &log;
  struct sigaction action {};
  action.sa_handler = noteCrash;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : kCrashes) sigaction(signal, &action, nullptr);
}

sigset_t watchedSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGCHLD, SIGINT, SIGTERM}) sigaddset(&signals, signal);
  return signals;
}

double processorSeconds(pid_t process) {
  clockid_t clock;
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::set<int> facesAtFault(const SharedLog& log) {
  if (log.crashed > 0) return {log.crashed};
  std::set<int> faces;
  for (const auto& face : log.face)
    if (face > 0) faces.insert(face);
  return faces;
}

/// How a child ended.
struct End {
  int status = 0;
  std::optional<double> hung;  ///< the limit that it ran into, in processor seconds
  bool isCancelled = false;    ///< by more than one request to stop
};

End watch(pid_t child, const SharedLog& log, const RunLimits& limits) {
  const sigset_t signals = watchedSignals();
  std::uint64_t beats = 0;
  double lastBeat = 0;
  StopRequests requests;
  End end;
  while (waitpid(child, &end.status, WNOHANG) == 0) {
    const timespec pause{0, 200'000'000};
    siginfo_t info{};
    const int signal = sigtimedwait(&signals, &info, &pause);
    // Signals from the terminal reach the child directly.
    if (signal == SIGTERM || (signal == SIGINT && info.si_code == SI_USER)) kill(child, signal);
    // While it reads, it keeps all requests for later.
    if ((signal == SIGTERM || signal == SIGINT) && requests.addAndTestAgain()) {
      kill(child, SIGKILL);
      waitpid(child, &end.status, 0);
      end.isCancelled = true;
      return end;
    }
    const double now = processorSeconds(child);
    if (log.beats != beats) {
      beats = log.beats;
      lastBeat = now;
    }
    // Between faces only AF2's own loops run, which always end, however large the mesh.
    if (beats > 0 && facesAtFault(log).empty()) lastBeat = now;
    const double limit = beats == 0 ? limits.first : limits.next;
    if (now - lastBeat < limit) continue;
    kill(child, SIGKILL);
    waitpid(child, &end.status, 0);
    end.hung = limit;
    return end;
  }
  return end;
}

bool isCrash(int status) {
  if (!WIFSIGNALED(status)) return false;
  for (const int signal : kCrashes)
    if (WTERMSIG(status) == signal) return true;
  return false;
}

std::string nameOf(const End& end) {
  return end.hung ? fmt::format("the run made no progress in {:g} s of processor time", *end.hung)
                  : fmt::format("the run crashed ({})", strsignal(WTERMSIG(end.status)));
}

/// The exit code of a child that ended normally or was killed from outside.
int codeOf(int status) {
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  // The reader of the output has closed it: `af2 inspect part.step | head`.
  if (WTERMSIG(status) == SIGPIPE) raise(SIGPIPE);
  throw InputError(
      fmt::format("the run was killed from outside ({}), perhaps because memory ran out",
                  strsignal(WTERMSIG(status))));
}

class SharedMemory {
 public:
  SharedMemory()
      : room_(mmap(nullptr, sizeof(SharedLog), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS,
                   -1, 0)) {
    if (room_ != MAP_FAILED) log_ = new (room_) SharedLog;
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  SharedLog* log() { return log_; }

 private:
  void* room_;  // never unmapped: threads may still write to it
  SharedLog* log_ = nullptr;
};

/// Blocks the signals that the supervisor waits for.
class BlockedSignals {
 public:
  BlockedSignals() {
    const sigset_t signals = watchedSignals();
    sigprocmask(SIG_BLOCK, &signals, &before_);
  }
  ~BlockedSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

/// The end of a child; no value in the child itself.
std::optional<End> forkAndWatch(SharedLog& log, const RunLimits& limits) {
  const BlockedSignals blocked;
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child > 0) return watch(child, log, limits);
  if (child == 0) {
#ifdef PR_SET_PDEATHSIG
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent) _exit(1);
    catchCrashes(log);
  }
  return std::nullopt;  // the child, or the system could not make one
}

}  // namespace

int supervise(RunLimits limits, const std::function<int(RunLog&, const GivenUp&)>& run) {
  const double least = limits.next / 8;  // a sound face may take a second, too
  GivenUp givenUp;
  while (true) {
    SharedMemory shared;
    SharedLog local;
    SharedLog& log = shared.log() ? *shared.log() : local;
    const std::optional<End> end = forkAndWatch(log, limits);
    if (!end) {
      ChildLog childLog(log);
      return run(childLog, givenUp);
    }
    if (end->isCancelled) return kCancelled;
    if (!end->hung && !isCrash(end->status)) return codeOf(end->status);
    const std::set<int> faces = facesAtFault(log);
    if (faces.empty()) throw RunEnded(nameOf(*end));
    if (end->hung) limits.next = std::max(limits.next / 2, least);
    for (const int face : faces) givenUp[face] = "when it was tried, " + nameOf(*end);
  }
}

}  // namespace af2::cli

#else

namespace af2::cli {
namespace {
struct NoLog final : RunLog {
  void begin(int) override {}
  void finish() override {}
  void beat() override {}
};
}  // namespace

int supervise(RunLimits, const std::function<int(RunLog&, const GivenUp&)>& run) {
  NoLog log;
  return run(log, {});
}
}  // namespace af2::cli

#endif
