#include "geometry/spool/samples.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

namespace af2::geometry {

namespace {

/// Unsigned numbers in the order of the doubles.
std::uint64_t keyOf(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  return bits & kSign ? ~bits : bits | kSign;
}

/// The value at `place`, between those of the two ranks around it.
double between(double below, double above, double place) {
  return below + (place - static_cast<double>(static_cast<std::size_t>(place))) * (above - below);
}

}  // namespace

double percentileOf(std::span<double> values, double part) {
  if (values.empty()) return 0;
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at, values.end());
  if (below + 1 == values.size()) return *at;
  return between(*at, *std::min_element(at + 1, values.end()), place);
}

Samples::~Samples() {
  for (const SpoolFile::Place& block : blocks_) file_->release(block);
}

void Samples::putAway() {
  blocks_.push_back(file_->reserve(latest_.size() * sizeof(double)));
  file_->write(blocks_.back().begin, std::span<const double>(latest_));
  latest_.clear();
}

template <class Visit>
void Samples::forEach(const Visit& visit) const {
  std::vector<double> values(kBlock);
  for (const SpoolFile::Place& block : blocks_) {
    file_->read(block.begin, std::span(values));
    for (const double value : values) visit(value);
  }
  for (const double value : latest_) visit(value);
}

double Samples::mean() const {
  double sum = 0;
  if (blocks_.empty())
    sum = std::reduce(latest_.begin(), latest_.end());
  else
    forEach([&](double value) { sum += value; });
  return sum / static_cast<double>(count());
}

double Samples::percentile(double part) {
  if (blocks_.empty()) return percentileOf(latest_, part);
  const double place = part * static_cast<double>(count() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double value = ranked(below);
  return below + 1 == count() ? value : between(value, ranked(below + 1), place);
}

/// Counts the numbers in ever narrower ranges until those in the range of the rank are few.
double Samples::ranked(std::size_t rank) const {
  constexpr std::size_t kFew = 1 << 17;
  constexpr int kDigit = 16;
  std::uint64_t low = 0;
  std::size_t inRange = count();
  int shift = 64;
  const auto isIn = [&](std::uint64_t key) { return shift == 64 || key >> shift == low >> shift; };
  while (inRange > kFew && shift > 0) {
    std::vector<std::size_t> counts(std::size_t{1} << kDigit, 0);
    const int next = shift - kDigit;
    forEach([&](double value) {
      const std::uint64_t key = keyOf(value);
      if (isIn(key)) ++counts[key >> next & (counts.size() - 1)];
    });
    std::size_t digit = 0;
    for (; rank >= counts[digit]; ++digit) rank -= counts[digit];
    low |= static_cast<std::uint64_t>(digit) << next;
    inRange = counts[digit];
    shift = next;
  }
  std::vector<double> few;
  forEach([&](double value) {
    if (isIn(keyOf(value)) && few.size() < kFew) few.push_back(value);
  });
  if (shift == 0) return few.front();  // they are all the same
  const auto at = few.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(few.begin(), at, few.end());
  return *at;
}

}  // namespace af2::geometry
