// The progress of many faces as one, told one call at a time.
// Not installed.
#pragma once

#include <algorithm>
#include <mutex>
#include <vector>

#include "geometry/occ/model/meshing_options.h"

namespace af2::geometry {

/// Adds up how far the faces have come and tells it, one caller at a time.
class ProgressSum {
 public:
  ProgressSum(const ModelMeshingOptions& options, const std::vector<double>& work)
      : options_(options), work_(work), elements_(work.size(), 0) {
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
    sum_.elements += elements - elements_[index].count;
    sum_.workDone += done - elements_[index].done;
    elements_[index] = {elements, done};
  }
  void tell() const {
    if (options_.progress) options_.progress(sum_);
  }

  struct Part {
    Part(std::size_t c = 0, double d = 0) : count(c), done(d) {}
    std::size_t count;
    double done;
  };
  const ModelMeshingOptions& options_;
  const std::vector<double>& work_;
  std::vector<Part> elements_;
  ModelProgress sum_;
  std::mutex mutex_;
};

}  // namespace af2::geometry
