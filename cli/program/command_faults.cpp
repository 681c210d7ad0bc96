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

/// Rewords a message of the command-line library so that it says what to do.
std::string reworded(const CLI::App& command, const std::string& message) {
  std::smatch part;
  const auto is = [&](const char* form) {
    return std::regex_match(message, part, std::regex(form));
  };
  if (is("(.+) is required")) {
    const std::string description = descriptionOf(command, part[1]);
    return message + (description.empty() ? "" : ": " + description);
  }
  if (is("(.+): [0-9]+ required .* missing")) return part[1].str() + ": its value is missing";
  if (is("(.+): At Most 1 required but received ([0-9]+)"))
    return fmt::format("{} is given {} times; give it once", part[1].str(), part[2].str());
  if (is("Could not convert: (.+) = (.*)"))
    return fmt::format("{} '{}': give a whole number", part[1].str(), part[2].str());
  if (is("(.+): Value (.*) not in range (.+) to (.+)"))
    return fmt::format("{} '{}': give a whole number from {} to {}", part[1].str(), part[2].str(),
                       part[3].str(), part[4].str());
  if (is("(.+): (.*) not in \\{(.*)\\}"))
    return fmt::format("{} '{}': choose one of {}", part[1].str(), part[2].str(),
                       std::regex_replace(part[3].str(), std::regex(","), ", "));
  return message;
}

/// The first word that looks like an option but is not a known one.
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
    return fmt::format("unknown option '{}'{}{}", *name, help.empty() ? "" : "; ", help);
  }
  std::erase(words, "--");
  return words.empty() ? reworded(command, firstLine(error.what()))
                       : fmt::format("unexpected argument '{}'", words.front());
}

}  // namespace af2::cli
