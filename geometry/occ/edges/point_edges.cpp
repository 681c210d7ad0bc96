#include "geometry/occ/edges/point_edges.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>

#include "geometry/base/constants.h"
#include "geometry/occ/edges/edge_parts.h"

namespace af2::geometry {

namespace {

/// An edge that is shorter than this share of the wanted size, and than the tolerances of its
/// vertices, is collapsed to a point.
constexpr double kPointLike = 1e-3;
/// So is an edge that is shorter than this share of the model, where the precision of coordinates
/// ends, or too short to be visible, independent of the tolerances.
constexpr double kBlur = 1e-10;

/// Vertices with tolerances beyond this share of the model are damaged.
constexpr double kMaxTolerance = 0.01;

}  // namespace

double spanOf(const EdgeSamples& samples, const Ends& ends) {
  return ends.first == ends.last ? extentOf(samples) : samples.length;
}

double pointLength(const ModelShape& model, int id, const EdgeSamples& samples) {
  const double unseen = std::max(kBlur * model.diagonal, kUnseen * samples.wanted);
  const TopoDS_Edge edge = model.edge(id);
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  if (first.IsNull() || last.IsNull()) return unseen;
  const double tolerance = std::max(BRep_Tool::Tolerance(first), BRep_Tool::Tolerance(last));
  return std::max(unseen, std::min(tolerance, kPointLike * samples.wanted));
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> gapsBetweenEnds(
    const ModelShape& model, double size, const std::vector<Ends>& ends,
    const std::vector<bool>& isUsed, const std::vector<Point3>& points) {
  const double blur = std::min(kBlur * model.diagonal, kPointLike * size);
  std::vector<double> tolerance(points.size(), blur);
  for (int id = 1; id <= model.vertices.Extent(); ++id)
    tolerance[static_cast<std::size_t>(id) - 1] +=
        std::min(BRep_Tool::Tolerance(model.vertex(id)), kMaxTolerance * model.diagonal);
  return gapsInWires(model, ends, isUsed, points, tolerance);
}

}  // namespace af2::geometry
