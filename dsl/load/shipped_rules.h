// The rule files that AF2 comes with. Their texts are part of the library, so that a program needs
// no files beside it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dsl/load/rule_file.h"
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

/// The same files with what shippedRules leaves out: the source of the rules, for their tests.
AF2_EXPORT LoadedRules loadShippedRules(std::string_view name);

/// The same options, with which rule files can also import those that AF2 comes with. Files in the
/// folders of `options` come first.
AF2_EXPORT LoadOptions withShippedImports(LoadOptions options);

/// Whether a file and all its imports are rule files that AF2 comes with, unchanged. The tests of
/// AF2 have checked these.
AF2_EXPORT bool isShipped(const LoadedRules& loaded);

/// Where a rule is written.
struct RuleSource {
  std::string file;  ///< the path; of a file that is part of the library: its name, "tri/even.af2"
  int line = 0;      ///< counted from 1
  std::string text;  ///< of the whole rule; a mirror image has that of the rule that it mirrors
};

/// By rule of the rule set, which must have been loaded without errors.
AF2_EXPORT std::vector<RuleSource> sourcesOf(const LoadedRules& loaded);

}  // namespace af2::dsl
