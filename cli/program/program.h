// Finds the verb that the command line names, runs it, and turns errors into messages and exit
// codes.
#pragma once

#include <span>

#include "cli/program/verbs.h"

namespace af2::cli {

/// Returns the exit code of the program.
int runProgram(std::span<const Verb> verbs, int count, char** arguments);

}  // namespace af2::cli
