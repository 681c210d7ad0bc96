// Explains faults of the command line in plain words.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace af2::cli {

/// One line that names the option at fault and the way out. A mistyped option is reported before a
/// missing one, because it is the likely cause.
std::string faultOf(const CLI::App& program, const CLI::ParseError& error);

}  // namespace af2::cli
