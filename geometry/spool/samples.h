// Many numbers of which the mean and percentiles are wanted.
// Not installed.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "geometry/spool/spool_file.h"

namespace af2::geometry {

/// The value below which the fraction `part` (0 to 1) of `values` is, by linear interpolation
/// between neighbours; 0 if there are none. Reorders `values`.
double percentileOf(std::span<double> values, double part);

/// Keeps the numbers in memory or in a file.
class Samples {
 public:
  /// file  null: in memory
  explicit Samples(std::shared_ptr<SpoolFile> file = nullptr) : file_(std::move(file)) {}
  ~Samples();
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  void reserve(std::size_t count) {
    if (!file_) latest_.reserve(count);
  }
  void add(double value) {
    latest_.push_back(value);
    if (file_ && latest_.size() == kBlock) putAway();
  }
  std::size_t count() const { return blocks_.size() * kBlock + latest_.size(); }
  /// Not for no numbers.
  double mean() const;
  /// As percentileOf gives it.
  double percentile(double part);

 private:
  static constexpr std::size_t kBlock = 1 << 17;

  void putAway();
  template <class Visit>
  void forEach(const Visit& visit) const;
  double ranked(std::size_t rank) const;

  std::shared_ptr<SpoolFile> file_;
  std::vector<SpoolFile::Place> blocks_;
  std::vector<double> latest_;
};

}  // namespace af2::geometry
