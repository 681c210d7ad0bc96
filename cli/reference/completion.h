// Scripts that complete the command line of the program in shells.
#pragma once

#include <string>

#include "cli/reference/command_table.h"

namespace af2::cli {

/// For the file that `source` reads, or that lies in the folder of the shell's completions.
std::string bashCompletion(const Command& program);
std::string zshCompletion(const Command& program);
std::string fishCompletion(const Command& program);

}  // namespace af2::cli
