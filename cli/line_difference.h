// What differs between two texts, line by line.
#pragma once

#include <string>

namespace af2::cli {

/// A unified diff with three lines around each change; empty if the texts are equal.
std::string lineDifference(const std::string& name, const std::string& before,
                           const std::string& after);

}  // namespace af2::cli
