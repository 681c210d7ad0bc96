// Lengths along a parameter, and back.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace af2::geometry {

/// The integral of a speed from the start of an interval, as straight pieces between nodes that lie
/// closer where the speed changes. Each direction is exactly the other's inverse.
class LengthTable {
 public:
  /// Nothing if the speed vanishes somewhere, nearly so, or is no number.
  static std::optional<LengthTable> make(double from, double to,
                                         const std::function<double(double)>& speed);

  /// Beyond the ends, the last pieces go on.
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
