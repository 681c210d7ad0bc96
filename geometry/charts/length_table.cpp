#include "geometry/charts/length_table.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {

namespace {

constexpr int kMinPieces = 32, kMaxHalvings = 6;
/// Speeds at both ends of a piece differ by no more than this share, where halving can bring it
/// about.
constexpr double kMaxChange = 0.03;
/// A speed below this share of the largest one counts as zero.
constexpr double kMinSpeed = 1e-3;

}  // namespace

std::optional<LengthTable> LengthTable::make(double from, double to,
                                             const std::function<double(double)>& speed) {
  if (!(to > from) || !std::isfinite(to - from)) return std::nullopt;
  struct Sample {
    double parameter, speed;
  };
  std::vector<Sample> samples;
  const auto sampleAt = [&](double t) { return Sample{t, speed(t)}; };
  const auto addBetween = [&](auto&& self, const Sample& a, const Sample& b, int halvings) -> void {
    if (halvings > 0 && std::abs(a.speed - b.speed) > kMaxChange * std::max(a.speed, b.speed)) {
      const Sample middle = sampleAt(0.5 * (a.parameter + b.parameter));
      self(self, a, middle, halvings - 1);
      self(self, middle, b, halvings - 1);
    } else {
      samples.push_back(b);
    }
  };
  samples.push_back(sampleAt(from));
  for (int i = 1; i <= kMinPieces; ++i) {
    const Sample last = samples.back();
    addBetween(addBetween, last, sampleAt(from + (to - from) * i / kMinPieces), kMaxHalvings);
  }
  const auto [least, most] = std::ranges::minmax(samples, {}, &Sample::speed);
  if (!(least.speed > kMinSpeed * most.speed) || !std::isfinite(most.speed)) return std::nullopt;

  LengthTable table;
  table.nodes_.push_back({from, 0});
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample &a = samples[i - 1], &b = samples[i];
    const double middle = speed(0.5 * (a.parameter + b.parameter));  // Simpson's rule
    const double mean = (a.speed + 4 * middle + b.speed) / 6;
    if (!(mean > 0) || !std::isfinite(mean)) return std::nullopt;
    table.nodes_.push_back(
        {b.parameter, table.nodes_.back().length + mean * (b.parameter - a.parameter)});
  }
  return table;
}

namespace {

template <class Nodes, class From, class To>
double interpolate(const Nodes& nodes, double value, From from, To to) {
  const auto after = std::ranges::upper_bound(nodes.begin() + 1, nodes.end() - 1, value, {}, from);
  const auto& a = *(after - 1);
  const auto& b = *after;
  return a.*to + (value - a.*from) * ((b.*to - a.*to) / (b.*from - a.*from));
}

}  // namespace

double LengthTable::lengthAt(double parameter) const {
  return interpolate(nodes_, parameter, &Node::parameter, &Node::length);
}

double LengthTable::parameterAt(double length) const {
  return interpolate(nodes_, length, &Node::length, &Node::parameter);
}

}  // namespace af2::geometry
