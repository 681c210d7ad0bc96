// Lists of words in the texts that are made of the table of commands.
#pragma once

#include <string>
#include <vector>

#include "cli/reference/command_table.h"

namespace af2::cli {

std::string joined(const std::vector<std::string>& words, const std::string& separator);

/// All names of all options.
std::vector<std::string> optionNames(const Command& command);

/// The verbs of the program, or the words behind a verb.
std::vector<std::string> partNames(const Command& command);

/// A copy of the text with a backslash before each of these characters.
std::string escaped(const std::string& text, const std::string& characters);

}  // namespace af2::cli
