#include "geometry/occ/surfaces/pinches.h"

#include <algorithm>

namespace af2::geometry {

namespace {

/// Length of a line through points on all lines.
///
/// at(i)  the point on the i-th line
template <class At>
double widthThrough(std::size_t count, const At& at) {
  double sum = 0;
  Point3 last = at(0);
  for (std::size_t i = 1; i < count; ++i) {
    const Point3 next = at(i);
    sum += distance(last, next);
    last = next;
  }
  return sum;
}

double widthAt(const std::vector<ParameterLine>& lines, double parameter) {
  return widthThrough(lines.size(), [&](std::size_t i) { return lines[i].at(parameter).position; });
}

/// The parameter at which the lines are nearest to each other, between two.
double narrowestBetween(const std::vector<ParameterLine>& lines, double low, double high) {
  constexpr int kSteps = 70;  // to the last digits of a double
  for (int i = 0; i < kSteps; ++i) {
    const double third = (high - low) / 3;
    if (widthAt(lines, low + third) < widthAt(lines, high - third))
      high -= third;
    else
      low += third;
  }
  return (low + high) / 2;
}

/// Whether the lines meet in a plane, as meridians do at a pole. What goes on beyond that lies on
/// what is before it, and no cut parts them.
bool isFlatAt(const std::vector<ParameterLine>& lines, double parameter) {
  constexpr double kFlat = 0.9;
  Point3 sum;
  for (const ParameterLine& line : lines) sum = sum + line.at(parameter).normal;
  return length(sum) > kFlat * static_cast<double>(lines.size());
}

using Samples = std::vector<std::vector<ParameterLine::Place>>;  // by line

std::vector<double> pinchesOf(const std::vector<ParameterLine>& lines, const Samples& samples,
                              double longest) {
  constexpr double kNarrow = 0.25;      // of the widest place
  constexpr double kTowardNext = 0.01;  // of the way to the next sample
  std::vector<double> widths;
  for (std::size_t k = 0; k < samples.front().size(); ++k)
    widths.push_back(
        widthThrough(lines.size(), [&](std::size_t i) { return samples[i][k].position; }));
  const auto parameter = [&](std::size_t k) { return samples.front()[k].parameter; };
  const double narrow = kNarrow * std::ranges::max(widths);
  std::vector<double> pinches;
  for (std::size_t i = 1; i + 1 < widths.size(); ++i) {
    if (widths[i] > narrow || widths[i] > widths[i - 1] || widths[i] >= widths[i + 1]) continue;
    // A side of the face that is a point is none.
    if (std::min(widths[i - 1], widths[i + 1]) <= longest) continue;
    const double at = narrowestBetween(lines, parameter(i - 1), parameter(i + 1));
    const bool isPinch = widthAt(lines, at) <= longest &&
                         !isFlatAt(lines, at + kTowardNext * (parameter(i - 1) - at)) &&
                         !isFlatAt(lines, at + kTowardNext * (parameter(i + 1) - at));
    if (isPinch) pinches.push_back(at);
  }
  return pinches;
}

}  // namespace

void cutAtPinches(const std::vector<ParameterLine>& lines, const Samples& samples, double longest,
                  const Stretch& whole, std::vector<Stretch>& stretches) {
  for (const double pinch : pinchesOf(lines, samples, longest)) {
    if (stretches.empty()) stretches.push_back(whole);
    const auto before = std::ranges::find_if(stretches, [&](Stretch s) { return s.has(pinch); });
    if (before == stretches.end()) continue;
    Stretch after = *before;
    before->high = justBefore(pinch, whole.high - whole.low);
    before->calmHigh = std::min(before->calmHigh, before->high);
    after.low = pinch;
    after.calmLow = std::max(after.calmLow, pinch);
    stretches.insert(before + 1, after);
  }
}

}  // namespace af2::geometry
