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

/// Whether a face goes on beyond an edge as a strip: edges leave both of its ends side by side.
bool beginsStrip(const ModelShape& model, int face, std::size_t edge, const std::vector<Ends>& ends,
                 const std::vector<EdgeSamples>& samples) {
  constexpr double kAlong = 0.985;  // cosine of ten degrees
  const auto atPoint =
      endsByPoint(model.edgesOfFaces[static_cast<std::size_t>(face) - 1], ends, samples);
  const auto leavesAlong = [&](const Point3& direction) {
    return std::ranges::any_of(atPoint.at(ends[edge].last), [&](EdgeEnd other) {
      return other.edge != edge && dot(direction, directionFrom(other, samples)) > kAlong;
    });
  };
  return std::ranges::any_of(atPoint.at(ends[edge].first), [&](EdgeEnd one) {
    return one.edge != edge && leavesAlong(directionFrom(one, samples));
  });
}

/// Between faces one of which is no strip. Where both are, as at the corner of a thin plate, what
/// is beyond their other edges would meet at no angle.
bool endsSliver(const ModelShape& model, std::size_t edge, const std::vector<Ends>& ends,
                const std::vector<EdgeSamples>& samples) {
  const std::vector<int>& faces = model.facesOfEdges[edge];
  return ends[edge].first != ends[edge].last && faces.size() > 1 &&
         !std::ranges::all_of(
             faces, [&](int face) { return beginsStrip(model, face, edge, ends, samples); });
}

}  // namespace

double spanOf(const EdgeSamples& samples, const Ends& ends) {
  return ends.first == ends.last ? extentOf(samples) : samples.length;
}

double pointLength(const ModelShape& model, int id, const std::vector<Ends>& ends,
                   const std::vector<EdgeSamples>& samples) {
  const auto i = static_cast<std::size_t>(id) - 1;
  const double wanted = samples[i].wanted;
  const bool isSliver = samples[i].length > kUnseen * wanted &&
                        samples[i].length <= kUnseenSliver * wanted &&
                        endsSliver(model, i, ends, samples);
  const double unseen =
      std::max(kBlur * model.diagonal, (isSliver ? kUnseenSliver : kUnseen) * wanted);
  const TopoDS_Edge edge = model.edge(id);
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  if (first.IsNull() || last.IsNull()) return unseen;
  const double tolerance = std::max(BRep_Tool::Tolerance(first), BRep_Tool::Tolerance(last));
  return std::max(unseen, std::min(tolerance, kPointLike * wanted));
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
