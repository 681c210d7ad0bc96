// Makes the run of a trace once more, which gives the same decisions, and watches it.
#pragma once

#include <functional>
#include <memory>

#include "cli/meshing/trace_file.h"
#include "engine/rule/rule_set.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// A run that is made again.
class Replay {
 public:
  /// Throws InputError if files of the run are missing or have changed since.
  explicit Replay(const Trace& trace);

  const RuleSet& rules() const { return *rules_; }
  /// By rule: where it is written.
  const std::vector<geometry::RuleText>& ruleTexts() const { return ruleTexts_; }
  /// The rule file, with its whole path.
  const std::filesystem::path& ruleFile() const { return ruleFile_; }

  /// observer  of a face, or null; called from several threads
  geometry::ModelMesh run(const std::function<AF2MeshingObserver*(int face)>& observer) const;

 private:
  const Trace& trace_;
  std::shared_ptr<const RuleSet> rules_;
  std::vector<geometry::RuleText> ruleTexts_;
  std::filesystem::path ruleFile_;
};

}  // namespace af2::cli
