// Sums the progress of many faces and reports it, one call at a time.
// Not installed.
#pragma once

#include <algorithm>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "geometry/meshing/meshing_options.h"

namespace af2::geometry {

/// Sums the progress of the faces and reports it, one caller at a time. Only the first mesh of each
/// face counts; others report that the work goes on.
class ProgressSum {
 public:
  /// report  is kept as a reference
  /// work    of each face
  ProgressSum(const std::function<void(const ModelProgress&)>& report, std::vector<double> work)
      : report_(report), work_(std::move(work)), parts_(work_.size()) {
    sum_.faces = static_cast<int>(work_.size());
    for (const double w : work_) sum_.workTotal += w;
  }

  const std::vector<double>& work() const { return work_; }
  void advance(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    if (!parts_[index].isFinished)
      update(index, elements, std::min(static_cast<double>(elements), 0.99 * work_[index]));
    report();
  }
  void finish(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    if (std::exchange(parts_[index].isFinished, true)) return;
    update(index, elements, work_[index]);
    ++sum_.facesDone;
    report();
  }

 private:
  void update(std::size_t index, std::size_t elements, double done) {
    sum_.elements += elements - parts_[index].elements;
    sum_.workDone += done - parts_[index].done;
    parts_[index].elements = elements;
    parts_[index].done = done;
  }
  void report() const {
    if (report_) report_(sum_);
  }

  struct Part {
    std::size_t elements = 0;
    double done = 0;
    bool isFinished = false;
  };
  const std::function<void(const ModelProgress&)>& report_;
  const std::vector<double> work_;
  std::vector<Part> parts_;  // by face
  ModelProgress sum_;
  std::mutex mutex_;
};

}  // namespace af2::geometry
