// Rule sets as Python holds them.
#pragma once

#include <af2/dsl/rule_file.h>
#include <af2/engine/algorithm.h>
#include <af2/geometry/model_mesh.h>

#include <memory>
#include <vector>

#include "python/bindings/common.h"

namespace af2::python {

/// A loaded rule file. Immutable, so that threads may use it at once.
class Rules {
 public:
  explicit Rules(dsl::LoadedRules loaded);

  const dsl::LoadedRules& loaded() const { return loaded_; }
  /// Null if the file has errors, or no rule set.
  const AF2Algorithm* algorithm() const { return algorithm_.get(); }
  const std::vector<geometry::RuleText>& texts() const { return texts_; }
  /// Throws InputError if the file has no rule set.
  const RuleSet& ruleSet() const;

 private:
  dsl::LoadedRules loaded_;
  std::unique_ptr<const AF2Algorithm> algorithm_;
  std::vector<geometry::RuleText> texts_;
};

}  // namespace af2::python
