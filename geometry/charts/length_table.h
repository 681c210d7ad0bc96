// Converts a parameter to a length along a curve, and back.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace af2::geometry {

/// The integral of a speed from the start of an interval, piecewise linear between nodes that are
/// closer together where the speed changes. The two directions are exact inverses of each other.
class LengthTable {
 public:
  /// Nothing if the speed is zero or almost zero somewhere, or not a number.
  static std::optional<LengthTable> make(double from, double to,
                                         const std::function<double(double)>& speed);

  /// Beyond the ends, the last pieces are extrapolated.
  double lengthAt(double parameter) const;
  double parameterAt(double length) const;

 private:
  LengthTable() = default;
  struct Node {
    double parameter, length;
  };
  std::vector<Node> nodes_;  // both ascending
};

}  // namespace af2::geometry
