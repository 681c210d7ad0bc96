#include "geometry/sizes/uncovered_sources.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace af2::geometry {

namespace {

/// Sources that are found next to each other cover each other most often.
constexpr std::size_t kLast = 32;

/// Less than this share of a size covers it: clearly more than `uncovered` asks for, so that
/// rounding cannot make a difference.
constexpr double kClearly = 1 - 1e-8;

}  // namespace

UncoveredSources::UncoveredSources(double growth)
    : growth_(growth), sorted_({}, growth, std::numeric_limits<double>::infinity()) {}

bool UncoveredSources::cover(const SizeSource& source) const {
  const double limit = kClearly * source.size;
  const std::size_t first =
      std::max(sortedCount_, sources_.size() - std::min(sources_.size(), kLast));
  for (std::size_t i = sources_.size(); i-- > first;) {
    const double left = limit - sources_[i].size;
    if (!(left > 0)) continue;
    const Point3 way = source.position - sources_[i].position;
    if (growth_ * growth_ * dot(way, way) < left * left) return true;
  }
  return !sorted_.isEmpty() && sorted_.at(source.position, limit) < limit;
}

void UncoveredSources::sort() {
  if (sortedCount_ == sources_.size()) return;
  sorted_ = GrowingSize(sources_, growth_, std::numeric_limits<double>::infinity());
  sortedCount_ = sources_.size();
}

}  // namespace af2::geometry
