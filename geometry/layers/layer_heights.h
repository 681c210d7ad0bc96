// How high layers of quadrilaterals along an edge are. Not installed.
#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "engine/base/elementary.h"

namespace af2::geometry {

/// Where there is no room, layers become thinner, down to this share of the heights asked for.
/// Below that, there are fewer of them.
inline constexpr double kThinnest = 0.4;

/// Layers along an edge, seen from a face: heights grow away from the edge.
struct LayerHeights {
  double first = 0;   ///< height of the first layer, > 0
  double growth = 1;  ///< ratio of the heights of successive layers, > 0
  int count = 0;      ///< > 0

  double of(int layer) const { return first * power(growth, layer - 1); }  ///< 1: the first
  /// The distance from the edge to the top of each layer; [0] is 0.
  std::vector<double> tops() const {
    std::vector<double> tops{0};
    for (int layer = 1; layer <= count; ++layer) tops.push_back(tops.back() + of(layer));
    return tops;
  }
  bool operator==(const LayerHeights&) const = default;
};

/// By divided edge: the layers of one face along it.
using EdgeLayers = std::map<int, LayerHeights>;

/// By divided edge, and whether it is at the start of the edge: the lengths, from the end of the
/// edge, at which it has vertices because layers of a face end on it.
using LayerEnds = std::map<std::pair<int, bool>, std::vector<double>>;

}  // namespace af2::geometry
