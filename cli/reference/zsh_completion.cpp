#include <fmt/core.h>

#include "cli/reference/completion.h"
#include "cli/reference/word_lists.h"

namespace af2::cli {
namespace {

/// Within single quotes, which end for a quote of the text.
std::string zshQuoted(const std::string& text) {
  std::string made;
  for (const char character : text) {
    if (character == '\'')
      made += "'\\''";
    else
      made += character;
  }
  return "'" + made + "'";
}

/// The message and the action of a value, ":SIZE:" and ":FILE:_files".
std::string zshAction(const CommandValue& value) {
  const std::string name = ":" + escaped(value.name, ":[]\\") + ":";
  switch (value.kind) {
    case CommandValue::Kind::None:
      return "";
    case CommandValue::Kind::File:
      return name + "_files";
    case CommandValue::Kind::Folder:
      return name + "_files -/";
    case CommandValue::Kind::Choice:
      return name + "(" + joined(value.choices, " ") + ")";
    case CommandValue::Kind::Other:
      break;
  }
  return (value.isOptional ? ":" : "") + name;
}

/// One specification for each name: those of an option exclude each other, unless it may come
/// again.
std::string optionLines(const CommandOption& option) {
  std::string text;
  for (const std::string& name : option.names()) {
    const std::string others = option.isRepeatable ? "*" : "(" + joined(option.names(), " ") + ")";
    text += " \\\n      " + zshQuoted(others + name + "[" + escaped(option.description, ":[]\\") +
                                      "]" + zshAction(option.value));
  }
  return text;
}

std::string zshArguments(const Command& command) {
  std::string text = "_arguments";
  for (const CommandOption& option : command.options) text += optionLines(option);
  for (const CommandOption& argument : command.arguments) {
    const std::string many = argument.isRepeatable ? "*" : "";
    const std::string optional = argument.value.isOptional && many.empty() ? ":" : "";
    text += " \\\n      " + zshQuoted(many + optional + zshAction(argument.value));
  }
  return text;
}

std::string descriptions(const Command& command) {
  std::string text;
  for (const Command& part : command.parts)
    text += " \\\n      " + zshQuoted(escaped(part.name, ":") + ":" + part.summary);
  return text;
}

std::string functionOf(const std::string& name, const Command& command);

/// Completes the first word, and leaves the others to the function of that word.
std::string choiceBetweenParts(const std::string& name, const Command& command) {
  std::string text = fmt::format(
      "{0}() {{\n  local state\n  local -a words_of\n  _arguments -C{1} \\\n      '1:word:->first' "
      "'*::argument:->rest'\n  case $state in\n    first)\n      words_of=({2})\n      "
      "_describe word words_of ;;\n    rest) (( $+functions[{0}_$words[1]] )) && {0}_$words[1] "
      ";;\n  esac\n}}\n",
      name,
      [&] {
        std::string options;
        for (const CommandOption& option : command.options) options += optionLines(option);
        return options;
      }(),
      descriptions(command));
  for (const Command& part : command.parts) text += functionOf(name + "_" + part.name, part);
  return text;
}

std::string functionOf(const std::string& name, const Command& command) {
  if (!command.parts.empty()) return choiceBetweenParts(name, command);
  return name + "() {\n  " + zshArguments(command) + "\n}\n";
}

}  // namespace

std::string zshCompletion(const Command& program) {
  return "#compdef af2\n# Completion of the program af2 for zsh: install it as _af2 in a folder of "
         "$fpath.\n" +
         functionOf("_af2", program) + "_af2 \"$@\"\n";
}

}  // namespace af2::cli
