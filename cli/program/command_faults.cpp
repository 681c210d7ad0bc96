#include "cli/program/command_faults.h"

#include <fmt/core.h>

#include <optional>
#include <regex>
#include <string_view>
#include <vector>

#include "dsl/text/words.h"

namespace af2::cli {
namespace {

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// "wanted edge length" of "--size is required", or nothing.
std::string descriptionOf(const CLI::App& command, const std::string& option) {
  const CLI::Option* found = command.get_option_no_throw(option);
  return found ? found->get_description() : "";
}

/// What the library for command lines says of an option, said so that it tells the way out.
std::string reworded(const CLI::App& command, const std::string& told) {
  std::smatch part;
  const auto is = [&](const char* form) { return std::regex_match(told, part, std::regex(form)); };
  if (is("(.+) is required")) {
    const std::string description = descriptionOf(command, part[1]);
    return told + (description.empty() ? "" : ": " + description);
  }
  if (is("(.+): [0-9]+ required .* missing")) return part[1].str() + ": its value is missing";
  if (is("(.+): At Most 1 required but received ([0-9]+)"))
    return fmt::format("{} stands there {} times; give it once", part[1].str(), part[2].str());
  if (is("Could not convert: (.+) = (.*)"))
    return fmt::format("{} '{}': give a whole number", part[1].str(), part[2].str());
  if (is("(.+): Value (.*) not in range (.+) to (.+)"))
    return fmt::format("{} '{}': give a whole number from {} to {}", part[1].str(), part[2].str(),
                       part[3].str(), part[4].str());
  if (is("(.+): (.*) not in \\{(.*)\\}"))
    return fmt::format("{} '{}': there are {}", part[1].str(), part[2].str(),
                       std::regex_replace(part[3].str(), std::regex(","), ", "));
  return told;
}

/// The first word that looks like an option and is none.
std::optional<std::string> strangeOption(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") break;  // no options follow
    if (word.starts_with('-')) return word.substr(0, word.find('='));
  }
  return std::nullopt;
}

}  // namespace

std::string faultOf(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  if (chosen.empty()) return firstLine(error.what());
  const CLI::App& command = *chosen.front();
  std::vector<std::string> words = command.remaining();
  if (const auto name = strangeOption(words)) {
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options())
      for (const std::string& own : option->get_lnames()) options.push_back("--" + own);
    const std::string help = dsl::didYouMean(*name, options).text();
    return fmt::format("there is no option '{}'{}{}", *name, help.empty() ? "" : "; ", help);
  }
  std::erase(words, "--");
  return words.empty() ? reworded(command, firstLine(error.what()))
                       : fmt::format("'{}' is one word too many", words.front());
}

}  // namespace af2::cli
