// af2 manual
#include "cli/reference/manual.h"

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>

#include "cli/program/exit_code.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"

namespace af2::cli {
namespace {

struct ManualOptions {
  std::string verb, folder;
};

void writePages(const std::vector<ManualPage>& pages, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw UsageError(
        fmt::format("cannot create the folder '{}': {}", folder.string(), error.message()));
  }
  for (const ManualPage& page : pages) writeText((folder / (page.name + ".1")).string(), page.text);
}

void printPage(const std::vector<ManualPage>& pages, const std::string& verb) {
  const std::string name = verb.empty() ? "af2" : "af2-" + verb;
  for (const ManualPage& page : pages)
    if (page.name == name) return fmt::print("{}", page.text);
  throw UsageError(fmt::format("'{}' is not a verb of af2; `af2 --help` lists them", verb));
}

}  // namespace

Action declareManual(CLI::App& command) {
  const auto options = std::make_shared<ManualOptions>();
  command.add_option("VERB", options->verb, "print the page of this verb; default: of the program")
      ->type_name("");
  command
      .add_option("-o,--output", options->folder,
                  "write all pages to this folder, as af2.1, af2-mesh.1 and so on")
      ->type_name("DIR");
  return [options, &command] {
    CLI::App& program = *command.get_parent();
    const auto pages = manualPages(commandTable(program), AF2_VERSION, program.get_footer());
    if (options->folder.empty())
      printPage(pages, options->verb);
    else
      writePages(pages, options->folder);
    return kComplete;
  };
}

}  // namespace af2::cli
