#include "geometry/occ/base/trial.h"

#if __has_include(<unistd.h>) && __has_include(<sys/wait.h>)
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
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

namespace {

using Clock = std::chrono::steady_clock;

Clock::time_point after(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

bool writeAll(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(file, bytes, count);
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

/// Each result is sent as its length and its text; work that throws sends no text.
constexpr std::uint64_t kThrew = ~std::uint64_t(0);

[[noreturn]] void sendResults(std::size_t first, std::size_t count,
                              const std::function<std::string(std::size_t)>& work, int file) {
  forgetSignalHandlers();
  for (std::size_t i = first; i < count; ++i) {
    std::string text;
    std::uint64_t length = kThrew;
    try {
      text = work(i);
      length = text.size();
    } catch (...) {
    }
    if (!writeAll(file, reinterpret_cast<const char*>(&length), sizeof length) ||
        !writeAll(file, text.data(), text.size()))
      break;
  }
  ::_exit(0);
}

/// The results of one child, read until it ends or a limit is reached.
class ResultReader {
 public:
  ResultReader(int file, Clock::time_point end) : file_(file), end_(end) {}

  /// False if the child has ended, or was too slow.
  bool read(double seconds, std::optional<std::string>& result) {
    const Clock::time_point end = std::min(end_, after(seconds));
    std::uint64_t length = 0;
    if (!fill(sizeof length, end)) return false;
    std::memcpy(&length, bytes_.data(), sizeof length);
    bytes_.erase(0, sizeof length);
    if (length == kThrew) return true;
    if (!fill(length, end)) return false;
    result = bytes_.substr(0, length);
    bytes_.erase(0, length);
    return true;
  }

 private:
  bool fill(std::size_t count, Clock::time_point end) {
    while (bytes_.size() < count) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      pollfd waiting{file_, POLLIN, 0};
      if (left <= 0 || ::poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 1000))) < 0)
        return false;
      if (waiting.revents == 0) continue;
      char buffer[4096];
      const ssize_t got = ::read(file_, buffer, sizeof buffer);
      if (got <= 0) return false;
      bytes_.append(buffer, static_cast<std::size_t>(got));
    }
    return true;
  }

  int file_;
  Clock::time_point end_;
  std::string bytes_;
};

}  // namespace

std::vector<std::optional<std::string>> resultsOf(
    std::size_t count, const std::function<std::string(std::size_t)>& work,
    const TrialLimits& limits) {
  std::vector<std::optional<std::string>> results(count);
  const Clock::time_point end = after(limits.all);
  // A child that crashes or hangs ends with the work that it was at; the next one goes on after it.
  for (std::size_t next = 0; next < count && Clock::now() < end; ++next) {
    int ends[2];
    if (::pipe(ends) != 0) break;
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(ends[0]);
      sendResults(next, count, work, ends[1]);
    }
    ::close(ends[1]);
    ResultReader reader(ends[0], end);
    while (child > 0 && next < count && reader.read(limits.each, results[next])) ++next;
    ::close(ends[0]);
    if (child < 0) break;
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  return results;
}

}  // namespace af2::geometry

#else

namespace af2::geometry {

bool survives(const std::function<void()>&, std::chrono::seconds) { return true; }

std::vector<std::optional<std::string>> resultsOf(
    std::size_t count, const std::function<std::string(std::size_t)>& work, const TrialLimits&) {
  std::vector<std::optional<std::string>> results(count);
  for (std::size_t i = 0; i < count; ++i) {
    try {
      results[i] = work(i);
    } catch (const std::exception&) {
    }
  }
  return results;
}

}  // namespace af2::geometry

#endif
