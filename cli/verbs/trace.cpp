// af2 trace
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/meshing/trace_file.h"
#include "cli/program/exit_code.h"
#include "cli/program/verbs.h"
#include "cli/trace_view/trace_view.h"

namespace af2::cli {
namespace {

std::string textOf(const Trace& trace, const FaceTrace& entries, std::size_t at) {
  if (at >= entries.size()) return "nothing more";
  const TraceEntry& entry = entries[at];
  switch (entry.kind) {
    case TraceEntry::Kind::Begin:
      return fmt::format("a front with {} vertices begins", entry.from);
    case TraceEntry::Kind::End:
      return entry.from == 0 ? std::string("the front closes")
                             : fmt::format("the front ends with {} edges left", entry.from);
    case TraceEntry::Kind::Refused:
      return fmt::format("edge {} -> {} at level {}: no rule", entry.from, entry.to, entry.level);
    case TraceEntry::Kind::Applied:
      return fmt::format("edge {} -> {} at level {}: rule '{}', score {:.6g}", entry.from, entry.to,
                         entry.level, trace.ruleNames[entry.rule], entry.score);
    case TraceEntry::Kind::Weld:
      return fmt::format("vertex {} is welded into {}", entry.from, entry.to);
    case TraceEntry::Kind::Row:
      return fmt::format("a row is complete, and {} vertices are moved", entry.from);
    case TraceEntry::Kind::Columns:
      return fmt::format("{} vertices get counts for columns", entry.from);
    case TraceEntry::Kind::Path:
      return fmt::format("a path from {} to {} divides the loop", entry.from, entry.to);
  }
  return {};
}

/// Rules may be numbered differently in two rule sets; then their titles count.
bool areSame(const Trace& one, const TraceEntry& a, const Trace& other, const TraceEntry& b) {
  TraceEntry renamed = b;
  if (a.kind == TraceEntry::Kind::Applied && b.kind == a.kind &&
      one.ruleNames[a.rule] == other.ruleNames[b.rule])
    renamed.rule = a.rule;
  return a == renamed;
}

/// Returns whether the faces differ, after printing where.
bool differ(const Trace& one, const Trace& other, int face) {
  const FaceTrace& a = one.faces.at(face);
  const FaceTrace& b = other.faces.at(face);
  std::size_t at = 0, step = 0, front = 0;
  while (at < a.size() && at < b.size() && areSame(one, a[at], other, b[at])) {
    step += a[at].isStep();
    front += a[at].kind == TraceEntry::Kind::Begin;
    ++at;
  }
  if (at == a.size() && at == b.size()) return false;
  fmt::print("face {} parts at step {} (front {}):\n  first:  {}\n  second: {}\n", face, step + 1,
             front, textOf(one, a, at), textOf(other, b, at));
  return true;
}

int compare(const std::string& first, const std::string& second) {
  const Trace one = readTrace(first), other = readTrace(second);
  std::size_t parted = 0, common = 0;
  for (const auto& [face, entries] : one.faces) {
    if (!other.faces.contains(face)) continue;
    ++common;
    parted += differ(one, other, face);
  }
  const std::size_t alone = one.faces.size() + other.faces.size() - 2 * common;
  fmt::print("{} of {} faces took the same steps", common - parted, common);
  if (alone > 0) fmt::print(", {} are in one trace only", alone);
  fmt::print("\n");
  return parted + alone > 0 ? kUnusable : kComplete;
}

}  // namespace

Action declareTrace(CLI::App& command) {
  struct Options {
    std::string first, second;
    TraceViewOptions view;
  };
  const auto options = std::make_shared<Options>();
  command.require_subcommand(1);
  CLI::App* diff = command.add_subcommand("diff", "find the first step in which two runs part");
  diff->add_option("FIRST", options->first, "a trace (af2 mesh --trace)")
      ->type_name("")
      ->required();
  diff->add_option("SECOND", options->second, "another trace")->type_name("")->required();
  CLI::App* view = command.add_subcommand("view", "write a page that plays a run step by step");
  TraceViewOptions& shown = options->view;
  view->add_option("TRACE", shown.trace, "a trace (af2 mesh --trace)")->type_name("")->required();
  view->add_option("-o,--output", shown.output, "the page, .html")->type_name("FILE")->required();
  view->add_option("--face", shown.face, "only this face")->type_name("FACE");
  view->add_option("--from", shown.from, "the first step, from 1")->type_name("STEP");
  view->add_option("--to", shown.to, "the last step")->type_name("STEP");
  view->add_option("--charts", shown.charts, "the largest number of steps that get a chart")
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber.description(""));
  return [options, view] {
    if (view->parsed()) return viewTrace(options->view);
    return compare(options->first, options->second);
  };
}

}  // namespace af2::cli
