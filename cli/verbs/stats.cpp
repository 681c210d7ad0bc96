// af2 stats
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/meshing/replay.h"
#include "cli/meshing/rule_statistics.h"
#include "cli/program/exit_code.h"
#include "cli/program/verbs.h"

namespace af2::cli {

Action declareStats(CLI::App& command) {
  struct Options {
    std::string trace, format = "pretty";
  };
  const auto options = std::make_shared<Options>();
  command.add_option("TRACE", options->trace, "a trace (af2 mesh --trace)")
      ->type_name("")
      ->required();
  command.add_option("--format", options->format, "pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""));
  return [options] {
    const Trace trace = readTrace(options->trace);
    const Replay replay(trace);
    RuleCounters counters(replay.rules().rules().size());
    const geometry::ModelMesh mesh = replay.run([&](int) { return counters.observerOfFace(); });
    const RunStatistics statistics = statisticsOf(replay.rules(), mesh, counters);
    if (options->format == "json")
      fmt::print("{}\n", toJson(replay.rules(), statistics));
    else
      fmt::print("{}", toText(replay.rules(), statistics));
    return kComplete;
  };
}

}  // namespace af2::cli
