// af2 doc
#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "cli/program/exit_code.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/gallery.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_files.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

struct DocOptions {
  std::string file, output;
  std::vector<std::string> plugins;
};

int document(const DocOptions& options) {
  const auto& [file, output, plugins] = options;
  const dsl::LoadedRules loaded = loadRuleFile(file, {plugins, dsl::Externs::Declared});
  if (dsl::hasErrors(loaded.diagnostics)) {
    fmt::print(stderr, "{}", dsl::toPretty(loaded.diagnostics));
    throw InputError(fmt::format("the rule file '{}' has errors, see above", file));
  }
  const fs::path folder = output.empty() ? stemOf(file) + "-doc" : output;
  for (const auto& [path, content] : makeGallery(loaded)) {
    const fs::path target = folder / path;
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    if (error) {
      throw UsageError(fmt::format("cannot create the folder '{}': {}",
                                   target.parent_path().string(), error.message()));
    }
    writeText(target.string(), content);
  }
  fmt::print("wrote {}\n", (folder / "index.html").string());
  return kComplete;
}

}  // namespace

Action declareDoc(CLI::App& command) {
  const auto options = std::make_shared<DocOptions>();
  command.add_option("FILE", options->file, "rule file, or - for stdin")->type_name("")->required();
  command
      .add_option("-o,--output", options->output,
                  "output folder; default: the name of the rule file with -doc appended")
      ->type_name("DIR");
  addPluginOption(command, options->plugins);
  return [options] { return document(*options); };
}

}  // namespace af2::cli
