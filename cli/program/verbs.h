// The verbs of the program, `af2 VERB ...`, each in its own file.
#pragma once

#include <CLI/App.hpp>
#include <functional>

namespace af2::cli {

/// The action of a verb after the command line is parsed; returns the exit code. Throws UsageError,
/// InputError and GeometryError, whose messages are shown to the user.
using Action = std::function<int()>;

/// Declares the options of a verb on its subcommand.
struct Verb {
  const char* name;
  const char* summary;  ///< for `af2 --help`
  Action (*declare)(CLI::App& command);
  bool describesVerbs = false;  ///< it needs the options of all
};

Action declareMesh(CLI::App& command);
Action declareQuality(CLI::App& command);
Action declareCompare(CLI::App& command);
Action declareExplain(CLI::App& command);
Action declareStats(CLI::App& command);
Action declareTrace(CLI::App& command);
Action declareInspect(CLI::App& command);
Action declareCheck(CLI::App& command);
Action declareTest(CLI::App& command);
Action declareFmt(CLI::App& command);
Action declareDraw(CLI::App& command);
Action declareDoc(CLI::App& command);
Action declareNew(CLI::App& command);
Action declareEval(CLI::App& command);
Action declareCompile(CLI::App& command);
Action declareExplainCode(CLI::App& command);
Action declareImport(CLI::App& command);
Action declarePlayground(CLI::App& command);
Action declareLsp(CLI::App& command);
Action declareCompletion(CLI::App& command);
Action declareManual(CLI::App& command);
Action declareVersion(CLI::App& command);

}  // namespace af2::cli
