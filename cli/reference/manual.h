// Manual pages of the program and its verbs, in the language of man.
#pragma once

#include <string>
#include <vector>

#include "cli/reference/command_table.h"

namespace af2::cli {

struct ManualPage {
  std::string name;  ///< "af2", "af2-mesh"
  std::string text;
};

/// The page of the program and one for each verb. `exitCodes` is the last paragraph of the help.
std::vector<ManualPage> manualPages(const Command& program, const std::string& version,
                                    const std::string& exitCodes);

}  // namespace af2::cli
