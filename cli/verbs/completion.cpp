// af2 completion
#include <fmt/core.h>

#include <memory>
#include <string>

#include "cli/program/exit_code.h"
#include "cli/program/verbs.h"
#include "cli/reference/completion.h"

namespace af2::cli {

Action declareCompletion(CLI::App& command) {
  const auto shell = std::make_shared<std::string>();
  command.add_option("SHELL", *shell, "bash, zsh or fish")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}).description(""));
  return [shell, &command] {
    const Command table = commandTable(*command.get_parent());
    fmt::print("{}", *shell == "bash"  ? bashCompletion(table)
                     : *shell == "zsh" ? zshCompletion(table)
                                       : fishCompletion(table));
    return kComplete;
  };
}

}  // namespace af2::cli
