// Where the rule files are that AF2 comes with.
#pragma once

#include <filesystem>

namespace af2::cli {

/// The folder of rules: the environment variable AF2_RULES if it is set; else the one beside the
/// program, as it was installed or as it was built. Throws InputError if there is none.
std::filesystem::path rulesDirectory();

/// The file that the user means with `name`: as a path, or else within rulesDirectory(), with or
/// without ".af2". Throws InputError if there is no such file.
std::filesystem::path findRuleFile(const std::filesystem::path& name);

}  // namespace af2::cli
