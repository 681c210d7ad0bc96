// The progress of many faces as one, told one call at a time.
// Not installed.
#pragma once

#include <algorithm>
#include <functional>
#include <mutex>
#include <vector>

#include "geometry/meshing/meshing_options.h"

namespace af2::geometry {

/// Adds up how far the faces have come and tells it, one caller at a time.
class ProgressSum {
 public:
  /// tell, work  are kept as references
  ProgressSum(const std::function<void(const ModelProgress&)>& tell,
              const std::vector<double>& work)
      : tell_(tell), work_(work), parts_(work.size()) {
    sum_.faces = static_cast<int>(work.size());
    for (const double w : work) sum_.workTotal += w;
  }

  void advance(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    update(index, elements, std::min(static_cast<double>(elements), 0.99 * work_[index]));
    tell();
  }
  void finish(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    update(index, elements, work_[index]);
    ++sum_.facesDone;
    tell();
  }

 private:
  void update(std::size_t index, std::size_t elements, double done) {
    sum_.elements += elements - parts_[index].elements;
    sum_.workDone += done - parts_[index].done;
    parts_[index] = {elements, done};
  }
  void tell() const {
    if (tell_) tell_(sum_);
  }

  struct Part {
    std::size_t elements = 0;
    double done = 0;
  };
  const std::function<void(const ModelProgress&)>& tell_;
  const std::vector<double>& work_;
  std::vector<Part> parts_;  // by face
  ModelProgress sum_;
  std::mutex mutex_;
};

}  // namespace af2::geometry
