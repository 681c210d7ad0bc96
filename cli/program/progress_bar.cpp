#include "cli/program/progress_bar.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace af2::cli {
namespace {

constexpr int kUsualWidth = 80, kLongestBar = 40, kShortestBar = 5;
constexpr std::chrono::milliseconds kPause{100};
constexpr const char* kEraseLine = "\r\x1b[K";

}  // namespace

int terminalWidth() {
  if (::isatty(STDERR_FILENO) == 0) return 0;
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsualWidth;
  return size.ws_col;
}

std::string progressLine(const std::string& title, double fraction, const std::string& details,
                         int width) {
  const double part = std::clamp(fraction, 0.0, 1.0);
  // Does not show 100 % before the work is done.
  const std::string tail = fmt::format(" {:3d} %  {}", static_cast<int>(part * 100), details);
  const int room = width - static_cast<int>(title.size() + 1 + tail.size());
  const int length = std::min(room, kLongestBar);
  std::string bar;
  if (length >= kShortestBar) {
    const auto full = static_cast<std::size_t>(part * length);
    bar = std::string(full, '#') + std::string(static_cast<std::size_t>(length) - full, '-');
  }
  return (title + " " + bar + tail).substr(0, static_cast<std::size_t>(std::max(width, 0)));
}

ProgressBar::ProgressBar(bool wanted) : wanted_(wanted && terminalWidth() > 0) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs(kEraseLine, stderr);
}

void ProgressBar::show(const std::string& title, double fraction, const std::string& details) {
  if (!wanted_ || Clock::now() < next_) return;
  next_ = Clock::now() + kPause;
  drawn_ = true;
  fmt::print(stderr, "{}{}", kEraseLine,
             progressLine(title, fraction, details, terminalWidth() - 1));
  std::fflush(stderr);
}

}  // namespace af2::cli
