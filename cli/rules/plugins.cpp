#include "cli/rules/plugins.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string_view>

#include "dsl/program/plugin.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

using Interface = const char*();
using Register = void(dsl::Registry&);

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw InputError(fmt::format("--plugin '{}': {}", file, what));
}

/// The loader's own words, without the path that stands in front of them.
std::string loaderFault(const std::string& path) {
  const char* const given = dlerror();
  const std::string text = given ? given : "it cannot be loaded";
  const std::string prefix = path + ": ";
  return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

void* openPlugin(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) fail(file, "there is no such file");
  // Without a '/', the loader would look in the folders of the system.
  const std::string path = std::filesystem::absolute(file, error).string();
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) fail(file, loaderFault(path));
  return library;
}

template <class Function>
Function* find(void* library, const char* name) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

void registerFrom(const std::string& file, dsl::Registry& registry) {
  void* const library = openPlugin(file);
  const auto interface = find<Interface>(library, "af2_plugin_interface");
  const auto enter = find<Register>(library, "af2_register");
  if (!interface || !enter)
    fail(file,
         "it is no plugin of AF2: its entry point, AF2_PLUGIN in <af2/dsl/plugin.h>, is missing");
  if (const std::string_view given = interface(); given != AF2_PLUGIN_INTERFACE)
    fail(file, fmt::format("it was compiled for '{}', and this program is '{}'; compile it anew",
                           given, AF2_PLUGIN_INTERFACE));
  try {
    enter(registry);
  } catch (const std::exception& fault) {
    fail(file, fault.what());
  }
}

}  // namespace

static_assert(std::string_view(AF2_PLUGIN_INTERFACE).substr(4, 3) ==
                  std::string_view(AF2_VERSION).substr(0, 3),
              "plugin.h names another release");

void addPluginOption(CLI::App& command, std::vector<std::string>& files) {
  command
      .add_option("--plugin", files,
                  "library that registers functions, metrics or shapes for the rules")
      ->type_name("FILE")
      ->allow_extra_args(false);
}

dsl::Registry loadPlugins(const std::vector<std::string>& files) {
  dsl::Registry registry;
  for (const std::string& file : files) registerFrom(file, registry);
  return registry;
}

}  // namespace af2::cli
