#include "cli/program/program.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>
#include <new>
#include <string>
#include <string_view>

#include "cli/program/command_faults.h"
#include "cli/program/exit_code.h"
#include "cli/program/usage_error.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0: success. 1: the input cannot be used, a file cannot be written, or something "
    "was "
    "found by a verb that searches. 2: the command line is wrong. 3: some faces are not meshed. 4: "
    "stopped by a signal.";

/// Does not use fmt::print, which throws if stderr is closed (`2>&-`).
void printLine(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

void complain(const std::string& message) { printLine("af2: error: " + message); }

int explainUsage(const CLI::App& program, const std::string& message) {
  const auto chosen = program.get_subcommands();
  const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
  complain(message);
  printLine("try: af2 " + verb + "--help");
  return kUsage;
}

/// Message of an error from threads, output or the file system.
std::string faultOf(const std::exception& error) {
  const std::string message = error.what();
  if (message.starts_with("cannot write to file:"))
    return "cannot write all of the output" + message.substr(message.find(':'));
  if (message.starts_with("pthread_create"))
    return message + "; give the program more memory, or fewer threads (--threads)";
  return message;
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
  } catch (const std::exception& error) {
    complain(faultOf(error));
  }
  return kUnusable;
}

/// A script may pass an empty variable, such as `--faces "$list"`, which would count as not given.
void refuseEmptyValues(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_expected_min() > 0 && std::ranges::count(option->results(), "") > 0)
      throw UsageError(option->get_name() + ": its value is empty");
}

/// The verb that a command line begins with; null: none.
const Verb* firstVerb(std::span<const Verb> verbs, int count, char** arguments) {
  const auto isFirst = [&](const Verb& verb) {
    return count > 1 && std::string_view(arguments[1]) == verb.name;
  };
  const auto found = std::ranges::find_if(verbs, isFirst);
  return found == verbs.end() ? nullptr : &*found;
}

std::string knownVerbs(std::span<const Verb> verbs) {
  std::string list;
  for (const Verb& verb : verbs) list += (list.empty() ? "" : ", ") + std::string(verb.name);
  return list;
}

/// Why standard output could not be written; empty if it was. A closed standard output is not a
/// fault.
std::string faultOfOutput() {
  errno = 0;
  if (std::fflush(stdout) == 0 || errno == EBADF || errno == EPIPE) return {};
  return std::strerror(errno);
}

}  // namespace

int runProgram(std::span<const Verb> verbs, int count, char** arguments) {
  CLI::App program{"Meshes surfaces with an advancing front and rules from files.", "af2"};
  program.get_formatter()->label("SUBCOMMAND", "VERB");
  program.require_subcommand(1);
  program.set_version_flag("--version", std::string("af2 ") + AF2_VERSION, "Print the version");
  std::map<const CLI::App*, Action> actions;
  const Verb* const first = firstVerb(verbs, count, arguments);
  for (const Verb& verb : verbs) {
    CLI::App* command = program.add_subcommand(verb.name, verb.summary);
    command->group("Verbs");
    // There are many options, and to declare all takes longer than to run some verbs.
    if (!first || first == &verb || first->describesVerbs)
      actions[command] = verb.declare(*command);
  }
  program.footer(kExitCodes);  // verbs would inherit it

  if (count < 2)
    return explainUsage(program, "a verb is missing; the verbs are: " + knownVerbs(verbs));
  if (arguments[1][0] != '-' && !first) {
    return explainUsage(program, fmt::format("'{}' is not a verb of af2; the verbs are: {}",
                                             arguments[1], knownVerbs(verbs)));
  }
  try {
    program.parse(count, arguments);
    refuseEmptyValues(*program.get_subcommands().front());
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return explainUsage(program, faultOf(program, error));
  } catch (const UsageError& error) {
    return explainUsage(program, error.what());
  }
  const int code = runAction(program, actions.at(program.get_subcommands().front()));
  const std::string fault = code == kComplete ? faultOfOutput() : "";
  if (fault.empty()) return code;
  complain("cannot write all of the output: " + fault);
  return kUnusable;
}

}  // namespace af2::cli
