#include <fmt/core.h>

#include "cli/reference/completion.h"
#include "cli/reference/word_lists.h"

namespace af2::cli {
namespace {

std::string fishQuoted(const std::string& text) { return "'" + escaped(text, "'\\") + "'"; }

/// What completes a value: -r wants one, -f has no files, -x is both.
std::string fishAction(const CommandValue& value) {
  switch (value.kind) {
    case CommandValue::Kind::File:
      return " -r -F";
    case CommandValue::Kind::Folder:
      return " -x -a '(__fish_complete_directories)'";
    case CommandValue::Kind::Choice:
      return " -x -a " + fishQuoted(joined(value.choices, " "));
    case CommandValue::Kind::Other:
      return value.isOptional ? "" : " -x";
    case CommandValue::Kind::None:
      break;
  }
  return "";
}

std::string optionLine(const std::string& condition, const CommandOption& option) {
  std::string line = "complete -c af2";
  if (!condition.empty()) line += " -n " + fishQuoted(condition);
  if (!option.shortName.empty()) line += " -s " + option.shortName.substr(1);
  if (!option.longName.empty()) line += " -l " + option.longName.substr(2);
  return line + fishAction(option.value) + " -d " + fishQuoted(option.description) + "\n";
}

std::string wordLine(const std::string& condition, const Command& word) {
  return fmt::format("complete -c af2 -n {} -f -a {} -d {}\n", fishQuoted(condition), word.name,
                     fishQuoted(word.summary));
}

std::string argumentLine(const std::string& condition, const CommandOption& argument) {
  const std::string begin = "complete -c af2 -n " + fishQuoted(condition);
  if (argument.value.kind == CommandValue::Kind::Choice)
    return begin + " -f -a " + fishQuoted(joined(argument.value.choices, " ")) + "\n";
  return argument.value.kind == CommandValue::Kind::File ? begin + " -F\n" : "";
}

std::string linesOf(const std::string& condition, const Command& command) {
  std::string text;
  for (const CommandOption& option : command.options) text += optionLine(condition, option);
  for (const CommandOption& argument : command.arguments) text += argumentLine(condition, argument);
  if (command.parts.empty()) return text;
  const std::string none =
      condition + "; and not __fish_seen_subcommand_from " + joined(partNames(command), " ");
  for (const Command& part : command.parts) {
    text += wordLine(none, part);
    text += linesOf(condition + "; and __fish_seen_subcommand_from " + part.name, part);
  }
  return text;
}

}  // namespace

std::string fishCompletion(const Command& program) {
  std::string text =
      "# Completion of the program af2 for fish: source it, or install it as "
      "completions/af2.fish.\n"
      "complete -c af2 -f\n";
  for (const CommandOption& option : program.options)
    text += optionLine("__fish_use_subcommand", option);
  for (const Command& verb : program.parts) text += wordLine("__fish_use_subcommand", verb);
  for (const Command& verb : program.parts)
    text += linesOf("__fish_seen_subcommand_from " + verb.name, verb);
  return text;
}

}  // namespace af2::cli
