// Libraries that `--plugin` names: they register functions, metrics and shapes for rule files.
#pragma once

#include <string>
#include <vector>

#include "dsl/program/registry.h"

namespace CLI {
class App;
}

namespace af2::cli {

/// Declares --plugin, which may be given several times.
void addPluginOption(CLI::App& command, std::vector<std::string>& files);

/// What these libraries register. They stay loaded until the program ends, because rules call them.
///
/// Throws InputError, in one line, if one cannot be loaded, is no plugin, was compiled for another
/// version of AF2, or cannot register its names.
dsl::Registry loadPlugins(const std::vector<std::string>& files);

}  // namespace af2::cli
