#include "cli/reference/command_table.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace af2::cli {
namespace {

/// What the check of an option says of a word that no option accepts; empty without a check.
std::string refusalOf(CLI::Option& option) {
  try {
    return (*option.get_validator(0))(std::string("no such word"));
  } catch (const CLI::Error&) {  // there is no check, or it throws what it refuses
    return "";
  }
}

/// The words that an option accepts, which only its check knows: it lists them when it refuses one.
std::vector<std::string> choicesOf(CLI::Option& option) {
  std::vector<std::string> choices;
  const std::string refusal = refusalOf(option);
  const std::size_t begin = refusal.find(" not in {"), end = refusal.rfind('}');
  if (begin == std::string::npos || end == std::string::npos) return choices;
  const std::size_t first = refusal.find('{', begin) + 1;
  std::istringstream words(refusal.substr(first, end - first));
  for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  return choices;
}

bool isFolder(const std::string& name) { return name == "DIR"; }

/// Arguments of these names, and options with values of these names.
bool isFile(const std::string& name) {
  static constexpr const char* kFiles[] = {"FILE",  "FILES",  "MODEL", "MESH", "TRACE",
                                           "FIRST", "SECOND", "RULES", "A",    "B"};
  return std::ranges::find(kFiles, name) != std::end(kFiles);
}

CommandValue valueOf(CLI::Option& option) {
  CommandValue value;
  if (option.get_items_expected_max() == 0) return value;
  value.name = option.get_positional() ? option.get_name(true) : option.get_type_name();
  value.isOptional = option.get_positional() ? !option.get_required() : value.name.starts_with('[');
  value.choices = choicesOf(option);
  value.kind = !value.choices.empty() ? CommandValue::Kind::Choice
               : isFolder(value.name) ? CommandValue::Kind::Folder
               : isFile(value.name)   ? CommandValue::Kind::File
                                      : CommandValue::Kind::Other;
  return value;
}

CommandOption optionOf(CLI::Option& option) {
  CommandOption made;
  if (!option.get_snames().empty()) made.shortName = "-" + option.get_snames().front();
  if (!option.get_lnames().empty()) made.longName = "--" + option.get_lnames().front();
  made.description = option.get_description();
  made.value = valueOf(option);
  made.isRepeatable = option.get_expected_max() > 1 ||
                      option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  return made;
}

Command commandOf(CLI::App& app) {
  Command command{app.get_name(), app.get_description(), {}, {}, {}};
  for (CLI::Option* option : app.get_options([](CLI::Option*) { return true; }))
    (option->get_positional() ? command.arguments : command.options).push_back(optionOf(*option));
  for (CLI::App* part : app.get_subcommands([](CLI::App*) { return true; }))
    command.parts.push_back(commandOf(*part));
  return command;
}

}  // namespace

std::vector<std::string> CommandOption::names() const {
  std::vector<std::string> names;
  for (const std::string& name : {shortName, longName})
    if (!name.empty()) names.push_back(name);
  return names;
}

Command commandTable(CLI::App& program) { return commandOf(program); }

}  // namespace af2::cli
