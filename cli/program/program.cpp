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

/// Not with fmt::print, which throws if nobody listens (`2>&-`).
void tell(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

void complain(const std::string& message) { tell("af2: error: " + message); }

int explainUsage(const CLI::App& program, const std::string& message) {
  const auto chosen = program.get_subcommands();
  const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
  complain(message);
  tell("try: af2 " + verb + "--help");
  return kUsage;
}

/// Of threads that cannot be started, of text that cannot be printed, of the file system.
std::string faultOf(const std::exception& error) {
  const std::string told = error.what();
  if (told.starts_with("cannot write to file:"))
    return "cannot write all of the output" + told.substr(told.find(':'));
  if (told.starts_with("pthread_create"))
    return told + "; give the program more memory, or fewer threads (--threads)";
  return told;
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

/// Such as `--faces "$list"` makes where a script has no list; it would count as not given.
void refuseEmptyValues(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (std::ranges::count(option->results(), "") > 0)
      throw UsageError(option->get_name() + ": its value is empty");
}

bool isVerb(std::span<const Verb> verbs, std::string_view word) {
  return std::ranges::any_of(verbs, [&](const Verb& verb) { return word == verb.name; });
}

std::string knownVerbs(std::span<const Verb> verbs) {
  std::string list;
  for (const Verb& verb : verbs) list += (list.empty() ? "" : ", ") + std::string(verb.name);
  return list;
}

/// What stands in the way of writing to standard output, if anything does. That nobody listens is
/// no fault.
std::string faultOfOutput() {
  errno = 0;
  if (std::fflush(stdout) == 0 || errno == EBADF || errno == EPIPE) return {};
  return std::strerror(errno);
}

}  // namespace

int runProgram(std::span<const Verb> verbs, int count, char** arguments) {
  CLI::App program{"Surface meshing by an advancing front that rules drive.", "af2"};
  program.get_formatter()->label("SUBCOMMAND", "VERB");
  program.require_subcommand(1);
  program.set_version_flag("--version", std::string("af2 ") + AF2_VERSION, "Tell the version");
  std::map<const CLI::App*, Action> actions;
  for (const Verb& verb : verbs) {
    CLI::App* command = program.add_subcommand(verb.name, verb.summary);
    command->group("Verbs");
    actions[command] = verb.declare(*command);
  }

  if (count < 2) return explainUsage(program, "a verb is missing; there are: " + knownVerbs(verbs));
  if (arguments[1][0] != '-' && !isVerb(verbs, arguments[1])) {
    return explainUsage(program, fmt::format("'{}' is no verb of af2; there are: {}", arguments[1],
                                             knownVerbs(verbs)));
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
