#include "geometry/io/line_elements.h"

#include <algorithm>
#include <map>

namespace af2::geometry {
namespace {

using Ends = std::pair<VertexId, VertexId>;  // the lower one first

std::vector<LineElement> wantedLines(const ModelMesh& mesh, LinesAlong along) {
  std::map<int, int> boundaryOf;  // by edge
  for (const EdgeGroup& boundary : mesh.boundaries)
    for (const int edge : boundary.edges) boundaryOf[edge] = boundary.number;
  std::vector<LineElement> lines;
  for (const EdgeSegment& segment : mesh.segments) {
    const auto marked = boundaryOf.find(segment.edge);
    const int boundary = marked == boundaryOf.end() ? 0 : marked->second;
    if (along == LinesAlong::AllEdges || boundary != 0)
      lines.push_back({segment.from, segment.to, {}, segment.edge, boundary});
  }
  return lines;
}

/// Sides of elements that some line is, with the vertices at their middles.
class SidesOnLines {
 public:
  SidesOnLines(const ModelMesh& mesh, const std::vector<LineElement>& lines)
      : mesh_(mesh), isOnLine_(mesh.vertices.size(), false) {
    for (const LineElement& line : lines)
      for (const VertexId v : {line.from, line.to}) isOnLine_[v.value] = true;
    forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) { addSidesOf(slice, i); });
    std::ranges::sort(sides_);
  }

  /// Null if no element has this side.
  const VertexId* middleOf(VertexId from, VertexId to) const {
    const Ends ends = std::minmax(from, to);
    const auto side = std::ranges::lower_bound(sides_, ends, {}, &Side::first);
    return side != sides_.end() && side->first == ends ? &side->second : nullptr;
  }

 private:
  using Side = std::pair<Ends, VertexId>;

  void addSidesOf(const MeshSlice& slice, std::size_t e) {
    const auto corners = slice.elements[e].vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const VertexId from = corners[i], to = corners[(i + 1) % corners.size()];
      if (isOnLine(from) && isOnLine(to))
        sides_.push_back({std::minmax(from, to), mesh_.midsides.empty()
                                                     ? VertexId()
                                                     : mesh_.midsides[slice.firstElement + e][i]});
    }
  }

  bool isOnLine(VertexId v) const { return v.value < isOnLine_.size() && isOnLine_[v.value]; }

  const ModelMesh& mesh_;
  std::vector<bool> isOnLine_;  // by vertex
  std::vector<Side> sides_;
};

}  // namespace

std::vector<LineElement> lineElements(const ModelMesh& mesh, LinesAlong along) {
  std::vector<LineElement> lines = wantedLines(mesh, along);
  if (lines.empty()) return lines;
  const SidesOnLines sides(mesh, lines);
  std::erase_if(lines, [&](const LineElement& line) {  // the face beside it failed
    return !sides.middleOf(line.from, line.to);
  });
  for (LineElement& line : lines) line.middle = *sides.middleOf(line.from, line.to);
  std::ranges::stable_sort(lines, {}, &LineElement::edge);
  return lines;
}

}  // namespace af2::geometry
