// The rule files that AF2 comes with. Their texts are part of the library, so that a program needs
// no files beside it.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/base/export.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

struct ShippedFile {
  std::string_view name;  ///< within the folder of rules: "tri/even.af2"
  std::string_view text;
};

/// All rule files that AF2 comes with, by name.
AF2_EXPORT std::span<const ShippedFile> shippedFiles();

/// The rule set of a file that AF2 comes with, by the name of the file: "quad/paving.af2". Throws
/// InputError if there is no such file.
AF2_EXPORT std::shared_ptr<const RuleSet> shippedRules(std::string_view name);

/// The rules for triangles that `af2 mesh` uses unless told otherwise.
AF2_EXPORT std::shared_ptr<const RuleSet> defaultRules();

}  // namespace af2::dsl
