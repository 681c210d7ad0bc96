// What finishing the meshes of a run did, by kind of change, for `af2 stats`.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/optimize/finish_observer.h"

namespace af2::cli {

class FinishCounts final : public FinishObserver {
 public:
  void actKept(const FinishAct& act) override;
  void add(const FinishCounts& other);

  /// A table with a line for each kind that occurred; empty if there is none.
  std::string toText() const;
  /// [{"change", "number", "better", "mean_worst_before", "mean_worst_after"}]
  nlohmann::ordered_json toJson() const;

 private:
  struct Count {
    std::size_t number = 0, better = 0;  ///< `better`: the worst element became better
    double before = 0, after = 0;        ///< sums of the badness of the worst elements
    std::size_t finite = 0;              ///< changes in the sums
    double mean(double sum) const { return sum / static_cast<double>(finite); }
  };
  std::array<Count, kFinishActKinds> counts_{};
};

}  // namespace af2::cli
