// af2 lsp
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/lsp/serve.h"
#include "cli/program/verbs.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rules_location.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

lsp::Surroundings surroundings(const std::vector<std::string>& plugins) {
  lsp::Surroundings result;
  result.registry = loadPlugins(plugins);
  result.version = AF2_VERSION;
  try {
    result.rules = {rulesDirectory()};
  } catch (const InputError&) {
    // Files without imports do not need the rules of AF2; for others the missing import is
    // reported.
  }
  std::error_code ignored;
  result.drawings = fs::temp_directory_path(ignored) / ("af2-pictures-" + std::to_string(getuid()));
  return result;
}

}  // namespace

Action declareLsp(CLI::App& command) {
  command.footer(
      "Editors start this program and communicate with it over standard input and output; it is "
      "not for use in a terminal.\ndocs/editors.md explains how to set up VS Code, Neovim and "
      "others.");
  const auto useStdio = std::make_shared<bool>(true);
  command.add_flag("--stdio", *useStdio, "communicate over standard input and output; always on");
  const auto plugins = std::make_shared<std::vector<std::string>>();
  addPluginOption(command, *plugins);
  return [plugins] {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    return lsp::serve(std::cin, std::cout, surroundings(*plugins));
  };
}

}  // namespace af2::cli
