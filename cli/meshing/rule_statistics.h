// What each rule did in a run, how good its elements are, and where the worst elements come from.
#pragma once

#include <array>
#include <cstddef>
#include <list>
#include <mutex>
#include <string>
#include <vector>

#include "cli/meshing/finish_counts.h"
#include "engine/rule/refusal.h"
#include "engine/rule/rule_set.h"
#include "engine/step/observer.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// What came of one rule in all steps of a run.
struct RuleCounts {
  static constexpr std::size_t kReasons = static_cast<std::size_t>(Refusal::Beaten) + 1;
  std::array<std::size_t, kReasons> refused{};  ///< steps by reason
  std::size_t matches = 0, chosen = 0;
  double levels = 0;  ///< summed over the steps in which it was chosen
  int highestLevel = 0;
  double seconds = 0;  ///< for finding and testing all its matches; not reproducible

  RuleCounts& operator+=(const RuleCounts& other);
};

/// Observes the faces of a run, which may be meshed by several threads.
class RuleCounters {
 public:
  explicit RuleCounters(std::size_t rules) : rules_(rules) {}
  /// The observer of one face. Valid as long as the counters.
  AF2MeshingObserver* observerOfFace();
  /// By rule, over all faces.
  std::vector<RuleCounts> total() const;
  /// What was changed after the fronts had closed, on all faces.
  FinishCounts finish() const;

 private:
  class Counter final : public AF2MeshingObserver {
   public:
    explicit Counter(std::size_t rules) : counts(rules) {}
    bool wantsRefusals() const override { return true; }
    void stepTaken(const StepReport& step) override;
    void rulesRefused(const StepReport& step, std::span<const RuleRefusal> refusals) override;
    FinishObserver* finishing() override { return &finish; }
    std::vector<RuleCounts> counts;
    FinishCounts finish;
  };

  std::size_t rules_;
  std::mutex mutex_;
  std::list<Counter> counters_;  // which stay where they are
};

/// What made an element. The first four follow from what its rule does to the front.
enum class ElementSource {
  Row,      ///< a rule that replaces the base edge alone, by new vertices
  Corner,   ///< a rule that joins edges next to the base edge
  Meeting,  ///< a rule that joins vertices that the pattern does not reach along the front
  LoopEnd,  ///< a rule that uses up a whole loop of the front
  Closing,  ///< no rule
  Fan,      ///< no rule
  Changed,  ///< optimisation gave it other corners
};
constexpr std::size_t kElementSources = static_cast<std::size_t>(ElementSource::Changed) + 1;

/// How the source is called in tables and reports.
const char* toString(ElementSource source);

/// The source of the elements of a rule.
ElementSource sourceOf(const AF2Rule& rule);

/// Statistics of a run and of its mesh.
struct RunStatistics {
  std::vector<RuleCounts> counts;           ///< by rule
  std::vector<std::vector<float>> scores;   ///< by rule: of the elements that it made, ascending
  std::vector<float> changed, withoutRule;  ///< scores of the other elements, ascending
  struct Source {
    std::size_t elements = 0;
    std::size_t worst = 0;  ///< of the elements with the worst scores
  };
  std::array<Source, kElementSources> sources{};  ///< by ElementSource
  FinishCounts finish;                            ///< what was changed after the fronts had closed
  FrontActCounts acts;                            ///< of the fronts that were kept: see FaceReport
  std::size_t worst = 0;  ///< the number of elements with the worst scores, one in a hundred
};

RunStatistics statisticsOf(const RuleSet& rules, const geometry::ModelMesh& mesh,
                           const RuleCounters& counters);

/// Tables for people.
std::string toText(const RuleSet& rules, const RunStatistics& statistics);
/// An object with `rules`, `acts`, `sources` and `finish`.
std::string toJson(const RuleSet& rules, const RunStatistics& statistics);

}  // namespace af2::cli
