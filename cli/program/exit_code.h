// The exit codes of the program.
#pragma once

namespace af2::cli {

enum ExitCode : int {
  kComplete = 0,  ///< done and checked
  /// The input cannot be used; or there are findings, for verbs that search for them.
  kUnusable = 1,
  kUsage = 2,      ///< the command line is wrong
  kPartial = 3,    ///< some faces could not be meshed; the others were
  kCancelled = 4,  ///< stopped by the user
};

}  // namespace af2::cli
