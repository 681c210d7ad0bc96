// Pictures of the tests in rule files.
#pragma once

#include <string>

#include "dsl/load/rule_file.h"
#include "dsl/picture/piece_picture.h"

namespace af2::cli {

/// The front of a test, with its outcome and one rule: the rule that was applied; or the rule that
/// the test names, if that was not applied; or else the rule that came farthest.
///
/// Throws UsageError if the file has no such test.
std::string drawTest(const dsl::LoadedRules& rules, const std::string& title,
                     dsl::PictureFormat format, const dsl::PiecePictureOptions& options);

}  // namespace af2::cli
