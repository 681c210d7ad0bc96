#include "cli/inspect/inspect_tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>

#include "engine/base/place_text.h"

namespace af2::cli {
namespace {

using geometry::Defect;

/// At most this many defects of a kind are listed; more would hide the others.
constexpr std::size_t kMaxListed = 10;

std::string placeText(const Defect& defect) {
  std::string text;
  const auto part = [&](const char* kind, int id) {
    if (id > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", kind, id);
  };
  part("face", defect.face);
  part("edge", defect.edge);
  part("vertex", defect.vertex);
  return text + " at " + textOf(defect.place);
}

void printDefect(const Defect& defect, double size) {
  const std::string extent =
      defect.extent > 0 ? fmt::format("{:>10.3g}  {:>8.2g}", defect.extent, defect.extent / size)
                        : fmt::format("{:>10}  {:>8}", "", "");
  const std::string detail = defect.detail.empty() ? "" : ": " + defect.detail;
  fmt::print("{:<18}  {}  {}{}\n", geometry::toString(defect.kind), extent, placeText(defect),
             detail);
}

/// "3, 7-9" of ascending ids.
std::string rangesText(const std::vector<int>& ids) {
  std::string text;
  for (std::size_t i = 0; i < ids.size();) {
    std::size_t last = i;
    while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(ids[i]);
    if (last > i) text += (last > i + 1 ? "-" : ", ") + std::to_string(ids[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace

void printGroups(const std::vector<geometry::FaceGroup>& groups) {
  if (groups.empty()) return;
  fmt::print("{:>8}  {:<12}  {}\n", "faces", "group", "name");
  for (const geometry::FaceGroup& group : groups)
    fmt::print("{:>8}  {:<12}  {}\n", group.faces.size(), geometry::toString(group.kind),
               group.name);
}

void printMerging(const geometry::Merging& merging, double size) {
  if (merging.groups.empty())
    fmt::print("no faces would be merged at a mesh size of {:.3g}\n", size);
  else
    fmt::print("merged at a mesh size of {:.3g}, without {} vertices:\n{:>8}  {:<30}  {}\n", size,
               merging.vertices.size(), "faces", "ids", "edges that the mesh crosses");
  for (const geometry::MergedGroup& group : merging.groups) {
    std::vector<int> edges = group.smoothEdges;
    edges.insert(edges.end(), group.narrowEdges.begin(), group.narrowEdges.end());
    std::ranges::sort(edges);
    std::string text = rangesText(edges);
    if (!group.narrowEdges.empty())
      text += fmt::format(" (beside narrow faces: {})", rangesText(group.narrowEdges));
    fmt::print("{:>8}  {:<30}  {}\n", group.faces.size(), rangesText(group.faces), text);
  }
  for (const std::vector<int>& chain : merging.chains) {
    std::string ids;
    for (const int edge : chain) ids += (ids.empty() ? "" : ", ") + std::to_string(edge);
    fmt::print("{:>8}  divided as one edge: {}\n", "", ids);
  }
  for (const geometry::Merging::Kept& kept : merging.kept)
    fmt::print("{:>8}  face {} is not merged: {}\n", "", kept.face, kept.reason);
}

void printBoundaries(const std::vector<geometry::EdgeGroup>& boundaries) {
  if (boundaries.empty()) return;
  fmt::print("{:>8}  {:<12}  {}\n", "edges", "boundary", "name");
  for (const geometry::EdgeGroup& boundary : boundaries)
    fmt::print("{:>8}  {:<12}  {}\n", boundary.edges.size(), boundary.number, boundary.name);
}

void printEdges(const std::vector<geometry::EdgeEntry>& edges) {
  fmt::print("{:>8}  {:<10}  {:>12}  {:<14}  {}\n", "edge", "curve", "length", "faces", "from, to");
  for (const geometry::EdgeEntry& edge : edges) {
    std::string faces;
    for (const int face : edge.faces) faces += fmt::format("{}{}", faces.empty() ? "" : ", ", face);
    fmt::print("{:>8}  {:<10}  {:>12.6g}  {:<14}  {}, {}\n", edge.id, edge.curve, edge.length,
               faces, textOf(edge.from), textOf(edge.to));
  }
}

void printDefects(const std::vector<Defect>& defects, double size, bool all) {
  if (defects.empty()) return fmt::print("no defects at a mesh size of {:.3g}\n", size);
  fmt::print("{} defects at a mesh size of {:.3g}\n", defects.size(), size);
  fmt::print("{:<18}  {:>10}  {:>8}  {}\n", "defect", "extent", "of size", "where");
  std::map<geometry::DefectKind, std::size_t> listed, left;
  for (const Defect& defect : defects) {
    if (all || listed[defect.kind]++ < kMaxListed)
      printDefect(defect, size);
    else
      ++left[defect.kind];
  }
  for (const auto& [kind, count] : left)
    fmt::print("and {} more of the kind '{}' (--all lists them)\n", count,
               geometry::toString(kind));
}

}  // namespace af2::cli
