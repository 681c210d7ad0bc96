#include "cli/meshing/merge_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

/// "10deg" or "10".
double parseAngle(std::string text) {
  const std::string typed = text;
  if (text.ends_with("deg")) text.resize(text.size() - 3);
  double angle = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), angle);
  if (error != std::errc() || end != text.data() + text.size() || !(angle > 0 && angle <= 60))
    throw UsageError(fmt::format(
        "--merge '{}': give an angle up to 60 degrees, such as 10deg, or no value; write --merge "
        "after the model if it has none",
        typed));
  return angle;
}

double parseShare(const std::string& text) {
  double share = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
  if (error != std::errc() || end != text.data() + text.size() || !(share >= 0 && share <= 0.5))
    throw UsageError(
        fmt::format("--merge-narrow '{}': give a share of the size, from 0 to 0.5", text));
  return share;
}

}  // namespace

void declareMerge(CLI::App& command, MergeOptions& options) {
  command
      .add_option("--merge", options.angle,
                  "mesh faces of a CAD model together where they meet by no more than this angle, "
                  "without the edges and vertices between them; default: 10deg")
      ->type_name("[ANGLE]")
      ->expected(0, 1);
  command
      .add_option("--merge-narrow", options.narrow,
                  "with --merge: faces that are narrower, and edges that are shorter, than this "
                  "share of the size do not count; default: 0.2; 0: all do")
      ->type_name("SHARE");
  command
      .add_option("--merge-keep", options.kept,
                  "with --merge: edges that the mesh follows in any case, by id, e.g. 3,7-9, or "
                  "the name of faces or groups: the edges around these")
      ->type_name("EDGES")
      ->take_all()
      ->expected(1);
}

MergeAsked checkedMerge(const MergeOptions& options, ModelKind kind, bool hasFewest) {
  MergeAsked asked;
  asked.isAsked = !options.angle.empty();
  if (!asked.isAsked) {
    if (!options.narrow.empty()) throw UsageError("--merge-narrow needs --merge");
    if (!options.kept.empty()) throw UsageError("--merge-keep needs --merge");
    return asked;
  }
  if (kind != ModelKind::Cad)
    throw UsageError("--merge is for " + formatNames(ModelKind::Cad, "and") + " files");
  if (hasFewest) throw UsageError("--merge cannot be combined with --fewest");
  if (!options.angle.front().empty()) asked.request.angle = parseAngle(options.angle.front());
  if (!options.narrow.empty()) asked.request.narrow = parseShare(options.narrow);
  for (const std::string& text : options.kept) {
    const FaceList list = parseFaces("--merge-keep", text);
    asked.request.keptEdges.insert(list.ids.begin(), list.ids.end());
    std::ranges::copy(list.names, std::back_inserter(asked.request.keptAround));
  }
  return asked;
}

}  // namespace af2::cli
