// Sums the progress of many faces and reports it, one call at a time.
// Not installed.
#pragma once

#include <algorithm>
#include <functional>
#include <mutex>
#include <vector>

#include "geometry/meshing/meshing_options.h"

namespace af2::geometry {

/// Sums the progress of the faces and reports it, one caller at a time.
class ProgressSum {
 public:
  /// report, work  are kept as references
  ProgressSum(const std::function<void(const ModelProgress&)>& report,
              const std::vector<double>& work)
      : report_(report), work_(work), parts_(work.size()) {
    sum_.faces = static_cast<int>(work.size());
    for (const double w : work) sum_.workTotal += w;
  }

  void advance(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    update(index, elements, std::min(static_cast<double>(elements), 0.99 * work_[index]));
    report();
  }
  void finish(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    update(index, elements, work_[index]);
    ++sum_.facesDone;
    report();
  }

 private:
  void update(std::size_t index, std::size_t elements, double done) {
    sum_.elements += elements - parts_[index].elements;
    sum_.workDone += done - parts_[index].done;
    parts_[index] = {elements, done};
  }
  void report() const {
    if (report_) report_(sum_);
  }

  struct Part {
    std::size_t elements = 0;
    double done = 0;
  };
  const std::function<void(const ModelProgress&)>& report_;
  const std::vector<double>& work_;
  std::vector<Part> parts_;  // by face
  ModelProgress sum_;
  std::mutex mutex_;
};

}  // namespace af2::geometry
