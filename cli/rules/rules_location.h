// Finds the rule files that come with AF2.
#pragma once

#include <filesystem>

namespace af2::cli {

/// The folder of rules: the environment variable AF2_RULES if it is set, otherwise the folder
/// beside the program in an installation or a build tree. Throws InputError if there is none.
std::filesystem::path rulesDirectory();

/// The file that the user means with `name`: a path, or a name within rulesDirectory(), with or
/// without ".af2". Throws InputError if there is no such file.
std::filesystem::path findRuleFile(const std::filesystem::path& name);

}  // namespace af2::cli
