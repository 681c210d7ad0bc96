// af2 playground
#include <fmt/core.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stop_token>

#include "cli/playground/server.h"
#include "cli/program/exit_code.h"
#include "cli/program/interrupt.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rules_location.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

struct PlaygroundOptions {
  std::string file;
  std::vector<std::string> plugins;
  int port = 0;
  bool watch = false, open = false;
};

lsp::Surroundings surroundingsOf(const PlaygroundOptions& options) {
  lsp::Surroundings result;
  result.version = AF2_VERSION;
  result.registry = loadPlugins(options.plugins);
  try {
    result.rules = {rulesDirectory()};
  } catch (const InputError&) {
    // Files without imports do not need the rules of AF2; for others the missing import is
    // reported.
  }
  return result;
}

void openBrowser(std::string address) {
  std::string program = "xdg-open";
  char* arguments[] = {program.data(), address.data(), nullptr};
  // The browser must not inherit that Interrupt blocks signals.
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  const int fault =
      posix_spawnp(&process, program.c_str(), nullptr, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  if (fault != 0)
    fmt::print(stderr, "af2: there is no program xdg-open; open the address in a browser\n");
}

int playground(const PlaygroundOptions& options) {
  Interrupt interrupt;  // before the server starts threads
  playground::Server server({std::filesystem::absolute(findRuleFile(options.file)), options.watch,
                             options.port, surroundingsOf(options)});
  fmt::print("{}\n", server.address());
  std::fflush(stdout);
  if (options.open) openBrowser(server.address());
  const std::stop_callback onStop(interrupt.token(), [&server] { server.end(); });
  server.serve();
  return kComplete;
}

}  // namespace

Action declarePlayground(CLI::App& command) {
  command.footer(
      "Prints the address of a page on this machine; open it in a browser. Ctrl-C ends the "
      "program.");
  const auto options = std::make_shared<PlaygroundOptions>();
  command
      .add_option("RULES", options->file, "the rule file: a path, or a name in the rules of AF2")
      ->type_name("")
      ->required();
  command.add_option("--port", options->port, "port of 127.0.0.1; 0, the default, is a free one")
      ->type_name("N")
      ->check(CLI::Range(0, 65535).description(""));
  command.add_flag("--watch", options->watch,
                   "show the file on disk and follow its changes, without an editor");
  command.add_flag("--open", options->open, "open the page in the browser");
  addPluginOption(command, options->plugins);
  return [options] { return playground(*options); };
}

}  // namespace af2::cli
