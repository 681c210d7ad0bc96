// The difference between two texts, line by line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace af2::cli {

/// A unified diff with three lines around each change; empty if the texts are equal.
std::string lineDifference(const std::string& name, const std::string& before,
                           const std::string& after);

/// Lines of one text, replaced by lines of another.
struct LineChange {
  std::size_t first = 0, count = 0;  ///< lines of the old text, from 0
  std::string text;                  ///< with line breaks
};

/// The replacements that turn `before` into `after`, from the top; line breaks belong to their
/// lines.
std::vector<LineChange> lineChanges(std::string_view before, std::string_view after);

}  // namespace af2::cli
