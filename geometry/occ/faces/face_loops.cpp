#include "geometry/occ/faces/face_loops.h"

#include <Standard_Failure.hxx>
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "geometry/layers/layer_ends.h"
#include "geometry/occ/edges/tip_fans.h"

namespace af2::geometry {

namespace {

using PointPair = std::pair<std::uint32_t, std::uint32_t>;  // points, the lower index first

/// The counts to which the segments of a boundary belong.
std::map<PointPair, std::size_t> countsOf(const FaceBoundary& boundary,
                                          const DividedEdges& divided) {
  std::map<PointPair, std::size_t> counts;
  for (const SegmentUse& use : boundary.uses) {
    const DividedEdge& edge = divided.edges[static_cast<std::size_t>(use.edge) - 1];
    const auto part = std::ranges::upper_bound(edge.stops, use.segment) - edge.stops.begin();
    counts[std::minmax(edge.points[use.segment], edge.points[use.segment + 1])] =
        edge.counts[static_cast<std::size_t>(part)];
  }
  return counts;
}

/// Before fans are left out.
CountedLoop countedLoop(const std::vector<BoundaryCorner>& loop, const FaceBoundary& boundary,
                        const std::map<PointPair, std::size_t>& counts,
                        const DividedEdges& divided) {
  std::map<std::size_t, std::size_t> segments;  // by count
  CountedLoop counted;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t from = boundary.points[loop[i].vertex.value];
    const std::uint32_t to = boundary.points[loop[(i + 1) % loop.size()].vertex.value];
    const auto found = counts.find(std::minmax(from, to));
    if (found == counts.end())
      counted.hasOddRest = !counted.hasOddRest;
    else
      ++segments[found->second];
  }
  for (const auto& [count, used] : segments)
    counted.counts.insert(counted.counts.end(), used / divided.counts[count].segments, count);
  return counted;
}

/// At sharp tips, the rims of fans take the place of segments of edges.
void addLoops(const FaceSurface& surface, FaceBoundary boundary, const DividedEdges& divided,
              FanElements fans, std::vector<CountedLoop>& loops) {
  const std::map<PointPair, std::size_t> counts = countsOf(boundary, divided);
  const auto first = loops.size();
  std::vector<std::size_t> sizes;
  for (const auto& loop : boundary.input.loops) {
    sizes.push_back(loop.size());
    loops.push_back(countedLoop(loop, boundary, counts, divided));
  }
  leaveOutFans(surface, fans, boundary);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if ((boundary.input.loops[i].size() + sizes[i]) % 2 == 1)
      loops[first + i].hasOddRest = !loops[first + i].hasOddRest;
}

}  // namespace

std::vector<BoundedCell> boundedCells(const ModelShape& model, int face,
                                      const DividedEdges& divided,
                                      const std::vector<FaceOnFace>& onFaces) {
  const auto found = model.cells.find(face);
  if (found == model.cells.end() || found->second.isOne()) return {};
  const auto isUnder = [&](const FaceOnFace& lying) { return lying.under == face; };
  if (std::ranges::any_of(onFaces, isUnder)) return {};
  const FaceCells& cells = found->second;
  std::vector<BoundedCell> bounded;
  try {
    for (FaceCell id; id.u < cells.u.size(); ++id.u)
      for (id.v = 0; id.v < cells.v.size(); ++id.v) {
        const FaceSurface surface =
            FaceSurface::ofCell(model.face(face), cells.u[id.u], cells.v[id.v]);
        FaceBoundary boundary = findBoundary(model, face, id, divided, surface);
        if (!boundary.input.loops.empty()) bounded.push_back({id, std::move(boundary)});
      }
  } catch (const GeometryError&) {
    return {};
  }
  if (bounded.size() < 2) bounded.clear();
  return bounded;
}

void addLayerEndsOfFace(const ModelShape& model, int face, const EdgeLayers& layers,
                        const DividedEdges& divided, const std::vector<FaceOnFace>& onFaces,
                        LayerEnds& ends) {
  if (std::ranges::count(onFaces, face, &FaceOnFace::face) > 0) return;
  try {
    const std::vector<BoundedCell> cells = boundedCells(model, face, divided, onFaces);
    for (const BoundedCell& cell : cells) addLayerEnds(cell.boundary, layers, divided, ends);
    if (!cells.empty()) return;
    const FaceSurface surface = model.surface(face);
    addLayerEnds(findBoundary(model, face, divided, surface, onFaces), layers, divided, ends);
  } catch (const GeometryError&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
}

std::vector<CountedLoop> countedLoops(const ModelShape& model, int face,
                                      const DividedEdges& divided,
                                      const std::vector<FaceOnFace>& onFaces, FanElements fans) {
  std::vector<CountedLoop> loops;
  if (std::ranges::count(onFaces, face, &FaceOnFace::face) > 0) return loops;
  try {
    std::vector<BoundedCell> cells = boundedCells(model, face, divided, onFaces);
    for (BoundedCell& cell : cells) {
      const FaceCells& stretches = model.cells.at(face);
      const FaceSurface surface =
          FaceSurface::ofCell(model.face(face), stretches.u[cell.id.u], stretches.v[cell.id.v]);
      addLoops(surface, std::move(cell.boundary), divided, fans, loops);
    }
    if (!cells.empty()) return loops;
    const FaceSurface surface = model.surface(face);
    addLoops(surface, findBoundary(model, face, divided, surface, onFaces), divided, fans, loops);
  } catch (const Standard_Failure& failure) {
    throw GeometryError(std::string("OpenCASCADE: ") + failure.DynamicType()->Name());
  }
  return loops;
}

}  // namespace af2::geometry
