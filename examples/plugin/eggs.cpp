// A plugin for rules.af2: a zone shape, a function and a metric.
#include <af2/dsl/plugin.h>

#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "../registered_shape/egg.h"

namespace {

/// 1 at the middle of the base edge, and less the farther a point is from it.
std::optional<double> heat(std::span<const double> at) {
  const double x = at[0] - 0.5, y = at[1];
  return std::exp(-x * x - y * y);
}

/// 0 for the triangle whose edges have the wanted length.
class EvenEdges final : public af2::AF2ElementMetric {
 public:
  std::optional<double> badness(std::span<const af2::Point2> corners) const override {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double length = distance(corners[i], corners[(i + 1) % corners.size()]);
      if (!(length > 0)) return std::nullopt;
      sum += length + 1 / length - 2;
    }
    return sum;
  }
};

}  // namespace

AF2_PLUGIN(registry) {
  registry.addFunction({.name = "heat", .parameters = "p", .value = heat});
  registry.addShape({.name = "egg", .parameters = "ppn", .make = makeEgg});
  registry.addMetric("even_edges", std::make_shared<EvenEdges>());
}
