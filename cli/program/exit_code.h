// What the exit code of the program says.
#pragma once

namespace af2::cli {

enum ExitCode : int {
  kComplete = 0,   ///< done, and checked
  kUnusable = 1,   ///< the input cannot be used; findings, for verbs that look for some
  kUsage = 2,      ///< the command line makes no sense
  kPartial = 3,    ///< some faces could not be meshed, the others are
  kCancelled = 4,  ///< stopped by the user
};

}  // namespace af2::cli
