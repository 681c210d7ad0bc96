// One line at the bottom of a terminal that shows the progress of a run.
#pragma once

#include <chrono>
#include <string>

namespace af2::cli {

/// The width of the terminal behind stderr; 0 if stderr is not a terminal.
int terminalWidth();

/// The bar as a text of at most `width` characters, e.g. "meshing ######----  60 %  12/20 faces".
/// `fraction` is clamped to 0..1.
std::string progressLine(const std::string& title, double fraction, const std::string& details,
                         int width);

/// Draws on stderr if that is a terminal, at most ten times a second, and erases the line when it
/// is destroyed. Not thread-safe.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const std::string& title, double fraction, const std::string& details);

 private:
  using Clock = std::chrono::steady_clock;

  bool wanted_;
  bool drawn_ = false;
  Clock::time_point next_ = Clock::now();
};

}  // namespace af2::cli
