#include "cli/program.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <new>
#include <string_view>

#include "cli/exit_code.h"
#include "cli/usage_error.h"
#include "engine/error.h"

namespace af2::cli {
namespace {

void complain(const std::string& message) { fmt::print(stderr, "af2: error: {}\n", message); }

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

int explainUsage(const CLI::App& program, const std::string& message) {
  const auto chosen = program.get_subcommands();
  const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
  complain(message);
  fmt::print(stderr, "try: af2 {}--help\n", verb);
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
    return explainUsage(program, firstLine(error.what()));
  }
  return runAction(program, actions.at(program.get_subcommands().front()));
}

}  // namespace af2::cli
