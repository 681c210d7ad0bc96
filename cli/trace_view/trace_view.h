// af2 trace view: from a trace to the page that plays the run.
#pragma once

#include <string>

namespace af2::cli {

struct TraceViewOptions {
  std::string trace, output;
  int face = 0;          ///< only this face; 0: all
  int from = 0, to = 0;  ///< steps of the face; 0: the first and the last one
  int charts = 20000;    ///< at most this many steps get a chart
};

/// Writes the page and prints what it holds. Returns the exit code.
///
/// Throws UsageError if the trace has no such face or step, InputError if the trace cannot be read
/// or the run cannot be made again.
int viewTrace(const TraceViewOptions& options);

}  // namespace af2::cli
