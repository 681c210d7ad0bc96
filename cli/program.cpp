#include "cli/program.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "cli/exit_code.h"
#include "cli/usage_error.h"
#include "dsl/words.h"
#include "engine/error.h"

namespace af2::cli {
namespace {

/// Not with fmt::print, which throws if nobody listens (`2>&-`).
void tell(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

void complain(const std::string& message) { tell("af2: error: " + message); }

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

int explainUsage(const CLI::App& program, const std::string& message) {
  const auto chosen = program.get_subcommands();
  const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
  complain(message);
  tell("try: af2 " + verb + "--help");
  return kUsage;
}

int runAction(const CLI::App& program, const Action& action) {
  try {
    return action();
  } catch (const UsageError& error) {
    return explainUsage(program, error.what());
  } catch (const InputError& error) {
    complain(error.what());
  } catch (const GeometryError& error) {
    complain(error.what());
  } catch (const InternalError& error) {
    complain(fmt::format("this is a defect of AF2, please report it: {}", error.what()));
  } catch (const std::bad_alloc&) {
    complain("not enough memory; try a larger --size");
  } catch (const std::exception& error) {  // of the file system, for one
    complain(error.what());
  }
  return kUnusable;
}

bool isVerb(std::span<const Verb> verbs, std::string_view word) {
  return std::ranges::any_of(verbs, [&](const Verb& verb) { return word == verb.name; });
}

std::string knownVerbs(std::span<const Verb> verbs) {
  std::string list;
  for (const Verb& verb : verbs) list += (list.empty() ? "" : ", ") + std::string(verb.name);
  return list;
}

/// What is wrong with the words of a command: a mistyped option rather than that the right one is
/// missing.
std::string faultOf(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  if (chosen.empty()) return firstLine(error.what());
  std::vector<std::string> options;
  for (const CLI::Option* option : chosen.front()->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  const std::vector<std::string> strangers = chosen.front()->remaining();
  for (const std::string& word : strangers) {
    if (!word.starts_with('-')) continue;
    const std::string name = word.substr(0, word.find('='));
    const std::string help = dsl::didYouMean(name, options).text();
    return fmt::format("there is no option '{}'{}{}", name, help.empty() ? "" : "; ", help);
  }
  return strangers.empty() ? firstLine(error.what())
                           : fmt::format("'{}' is one word too many", strangers.front());
}

}  // namespace

int runProgram(std::span<const Verb> verbs, int count, char** arguments) {
  CLI::App program{"Surface meshing by an advancing front that rules drive.", "af2"};
  program.require_subcommand(1);
  std::map<const CLI::App*, Action> actions;
  for (const Verb& verb : verbs) {
    CLI::App* command = program.add_subcommand(verb.name, verb.summary);
    actions[command] = verb.declare(*command);
  }

  if (count > 1 && arguments[1][0] != '-' && !isVerb(verbs, arguments[1])) {
    return explainUsage(program, fmt::format("'{}' is no verb of af2; there are: {}", arguments[1],
                                             knownVerbs(verbs)));
  }
  try {
    program.parse(count, arguments);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return explainUsage(program, faultOf(program, error));
  }
  return runAction(program, actions.at(program.get_subcommands().front()));
}

}  // namespace af2::cli
