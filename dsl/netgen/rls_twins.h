// Which classical rules are mirror images of each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dsl/netgen/rls_rule.h"

namespace af2::dsl {

/// How one rule is the mirror image of another.
struct Twin {
  /// By vertex of the rule that is written out: the twin's vertex.
  std::vector<int> vertices;
  bool hasOwnQuality = false;
  std::vector<int> ownForms;  ///< vertices of the written rule whose tolerance the twin changes
};

/// Nothing if `other` is not what `rule` looks like in the mirror, tolerances and quality aside.
/// If it comes close, `difference` tells what keeps them apart, otherwise it is left empty.
std::optional<Twin> findTwin(const ClassicRule& rule, const ClassicRule& other,
                             std::string& difference);

/// A tolerance form seen in the mirror.
ExactForm mirrored(const ExactForm& form);

}  // namespace af2::dsl
