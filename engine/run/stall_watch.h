// Whether a front still advances.
#pragma once

#include <cstddef>

#include "engine/run/algorithm.h"

namespace af2 {

/// How far a run has come.
struct RunState {
  std::size_t steps = 0, candidates = 0;
  std::size_t gains = 0;  ///< elements, and acts that shorten or divide loops
  std::size_t frontEdges = 0;
};

/// Says when to report, and whether the front has stalled since.
class StallWatch {
 public:
  /// Keeps a reference to the options.
  explicit StallWatch(const FrontOptions& options) : options_(options) {}

  bool isReportDue(std::size_t steps, std::size_t candidates) {
    if (steps % kReportSteps != 0 && candidates < nextReport_) return false;
    nextReport_ = candidates + kReportCandidates;
    return true;
  }

  /// To be called at each report.
  bool isStalled(const RunState& now) {
    const bool bySteps = isStalledBySteps(now), byCandidates = isStalledByCandidates(now);
    return bySteps || byCandidates;
  }

 private:
  bool isStalledBySteps(const RunState& now) {
    if (options_.stallSteps <= 0) return false;
    constexpr int kMinReports = 2;
    const bool hasGained = now.gains >= gainsReported_ + kMinGain;
    idleReports_ = hasGained ? 0 : idleReports_ + 1;
    if (hasGained) stepsAtGain_ = now.steps;
    gainsReported_ = now.gains;
    return idleReports_ >= kMinReports &&
           now.steps - stepsAtGain_ >=
               static_cast<std::size_t>(options_.stallSteps) * now.frontEdges;
  }

  /// The limit grows with the front. Edges may need many candidates until they reach the level at
  /// which they match: where this holds for all edges of a long strip, 10 to 90 candidates each.
  bool isStalledByCandidates(const RunState& now) {
    constexpr std::size_t kForEachEdge = 60;
    if (now.gains >= gainsAtGain_ + kMinGain) {
      gainsAtGain_ = now.gains;
      candidatesAtGain_ = now.candidates;
    }
    return options_.stallCandidates > 0 &&
           now.candidates - candidatesAtGain_ >
               options_.stallCandidates + kForEachEdge * now.frontEdges;
  }

  /// The largest numbers of steps and of candidates between two reports.
  static constexpr std::size_t kReportSteps = 1024, kReportCandidates = 1 << 18;
  /// Fewer gains than this between two reports do not count as progress.
  static constexpr std::size_t kMinGain = 16;

  const FrontOptions& options_;
  std::size_t nextReport_ = kReportCandidates, gainsReported_ = 0;
  int idleReports_ = 0;          ///< consecutive reports without progress
  std::size_t stepsAtGain_ = 0;  ///< steps at the last progress
  std::size_t gainsAtGain_ = 0, candidatesAtGain_ = 0;
};

}  // namespace af2
