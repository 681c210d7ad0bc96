// Finds classical rules that are mirror images of each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dsl/netgen/rls_rule.h"

namespace af2::dsl {

/// The correspondence between a rule and its mirror image.
struct Twin {
  /// By vertex of the written rule: the vertex of the mirror image.
  std::vector<int> vertices;
  bool hasOwnQuality = false;
  std::vector<int> ownForms;  ///< vertices with another tolerance in the mirror image
};

/// Nothing if `other` is not the mirror image of `rule`, apart from tolerances and quality. If it
/// is almost the mirror image, `difference` describes the difference; otherwise it is empty.
std::optional<Twin> findTwin(const ClassicRule& rule, const ClassicRule& other,
                             std::string& difference);

/// The reflected tolerance form.
ExactForm mirrored(const ExactForm& form);

}  // namespace af2::dsl
