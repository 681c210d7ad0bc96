#include <fmt/core.h>

#include "cli/reference/completion.h"
#include "cli/reference/word_lists.h"

namespace af2::cli {
namespace {

/// Everything before the first word that depends on the verb. `place` becomes the verb, with the
/// word behind it if the verb has such words.
constexpr const char* kBashBegin =
    R"(# Completion of the program af2 for bash: source it, or install it as completions/af2.
_af2_files() { compopt -o default; COMPREPLY=(); }
_af2_folders() { compopt -o dirnames; COMPREPLY=(); }
_af2_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "${COMP_WORDS[COMP_CWORD]}"); }

_af2() {
  local previous=${COMP_WORDS[COMP_CWORD - 1]} place=${COMP_WORDS[1]}
  COMPREPLY=()
)";

constexpr const char* kBashEnd = R"(}
complete -F _af2 af2
)";

/// What completes a value.
std::string bashAction(const CommandValue& value) {
  switch (value.kind) {
    case CommandValue::Kind::File:
      return "_af2_files";
    case CommandValue::Kind::Folder:
      return "_af2_folders";
    case CommandValue::Kind::Choice:
      return fmt::format("_af2_words '{}'", joined(value.choices, " "));
    case CommandValue::Kind::None:
    case CommandValue::Kind::Other:
      break;
  }
  return ":";
}

/// An argument is completed where no option is.
std::string bashArguments(const Command& command) {
  for (const CommandOption& argument : command.arguments)
    if (const std::string action = bashAction(argument.value); action != ":") return action;
  return ":";
}

std::string caseOf(const std::string& place, const Command& command) {
  std::string text = fmt::format("    '{}')\n      case $previous in\n", place);
  for (const CommandOption& option : command.options) {
    if (option.value.kind != CommandValue::Kind::None && !option.value.isOptional)
      text += fmt::format("        {}) {}; return ;;\n", joined(option.names(), "|"),
                          bashAction(option.value));
  }
  return text + fmt::format(
                    "      esac\n"
                    "      if [[ ${{COMP_WORDS[COMP_CWORD]}} == -* ]]; then _af2_words '{}'; else "
                    "{}; fi ;;\n",
                    joined(optionNames(command), " "), bashArguments(command));
}

/// A verb with words behind it: `place` gets the second one, once that is complete.
std::string partsOf(const Command& verb) {
  const std::string words = joined(partNames(verb), " ");
  return fmt::format(
      "  if [[ $place == {} ]]; then\n"
      "    if ((COMP_CWORD == 2)); then _af2_words '{} --help'; return; fi\n"
      "    place+=\" ${{COMP_WORDS[2]}}\"\n  fi\n",
      verb.name, words);
}

}  // namespace

std::string bashCompletion(const Command& program) {
  std::string text = kBashBegin;
  text += fmt::format("  if ((COMP_CWORD == 1)); then _af2_words '{} {}'; return; fi\n",
                      joined(partNames(program), " "), joined(optionNames(program), " "));
  std::string cases;
  for (const Command& verb : program.parts) {
    if (!verb.parts.empty()) text += partsOf(verb);
    cases += caseOf(verb.name, verb);
    for (const Command& part : verb.parts) cases += caseOf(verb.name + " " + part.name, part);
  }
  return text + "  case $place in\n" + cases + "  esac\n" + kBashEnd;
}

}  // namespace af2::cli
