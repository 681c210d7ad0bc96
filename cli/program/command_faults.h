// What is wrong with the words of a command, in plain words.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace af2::cli {

/// One line that names the option at fault and the way out. A mistyped option is told rather than
/// that the right one is missing.
std::string faultOf(const CLI::App& program, const CLI::ParseError& error);

}  // namespace af2::cli
