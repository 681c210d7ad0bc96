// The verbs and options of the program as a table, from which manual pages and shell completion are
// made.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace af2::cli {

/// What may stand in a place of the command line.
struct CommandValue {
  enum class Kind { None, File, Folder, Choice, Other };
  Kind kind = Kind::None;
  std::string name;                  ///< as the help shows it, such as "SIZE"
  std::vector<std::string> choices;  ///< for Kind::Choice
  bool isOptional = false;           ///< `--merge [ANGLE]`; an argument that may be left out
};

struct CommandOption {
  std::string shortName, longName;  ///< "-o", "--output"; one may be empty, both for an argument
  std::string description;
  CommandValue value;
  bool isRepeatable = false;

  std::vector<std::string> names() const;  ///< those that are not empty
};

/// The program, a verb, or a word behind a verb, such as `diff` of `af2 trace diff`.
struct Command {
  std::string name;
  std::string summary;
  std::vector<CommandOption> options;    ///< in the order of the help
  std::vector<CommandOption> arguments;  ///< MODEL and the like
  std::vector<Command> parts;            ///< the verbs of the program, the words behind a verb
};

/// Of the program itself, as it is when all verbs are declared.
Command commandTable(CLI::App& program);

}  // namespace af2::cli
