// Size sources that are found one after the other, of which most add nothing to those before them.
// Not installed.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

/// Tells before a source is examined further that `uncovered` will remove it. The sources are
/// points: they have no radius.
class UncoveredSources {
 public:
  explicit UncoveredSources(double growth);

  /// Whether a smaller size than its own is known at the position of a source. The last sources and
  /// the sorted ones are looked at.
  bool cover(const SizeSource& source) const;
  void add(const SizeSource& source) { sources_.push_back(source); }
  /// Sorts all sources added so far.
  void sort();
  std::vector<SizeSource> take() { return std::move(sources_); }

 private:
  double growth_;
  std::vector<SizeSource> sources_;
  GrowingSize sorted_;
  std::size_t sortedCount_ = 0;
};

}  // namespace af2::geometry
