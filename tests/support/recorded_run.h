// Runs in a plane with options, and an observer that remembers what it hears.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/meshing.h"

namespace af2::testing {

inline MeshingResult run(const FrontInput& input, double size, const FrontOptions& options,
                         std::shared_ptr<const RuleSet> set = triangleSet()) {
  return AF2Algorithm(std::move(set)).execute(FlatMaker(), input, UniformSize(size), options);
}

class Recorder : public AF2MeshingObserver {
 public:
  explicit Recorder(bool wantsRefusals) : wantsRefusals_(wantsRefusals) {}
  void stepTaken(const StepReport& step) override { steps.push_back(step); }
  bool wantsRefusals() const override { return wantsRefusals_; }
  void rulesRefused(const StepReport& step, std::span<const RuleRefusal> list) override {
    EXPECT_EQ(step.elements, steps.back().elements);
    refusals.emplace_back(list.begin(), list.end());
  }
  std::vector<StepReport> steps;
  std::vector<std::vector<RuleRefusal>> refusals;

 private:
  bool wantsRefusals_;
};

}  // namespace af2::testing
