#include "geometry/occ/edges/point_edges.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <optional>

#include "engine/base/error.h"
#include "geometry/base/constants.h"
#include "geometry/occ/edges/edge_on_face.h"
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

/// The two edges of a face that leave the ends of an edge side by side.
struct Strip {
  int face = 0;
  EdgeEnd one, other;
};

/// How a face goes on beyond an edge, if it does so as a strip.
std::optional<Strip> stripBeyond(const ModelShape& model, int face, std::size_t edge,
                                 const std::vector<Ends>& ends,
                                 const std::vector<EdgeSamples>& samples) {
  constexpr double kAlong = 0.985;  // cosine of ten degrees
  const auto atPoint =
      endsByPoint(model.edgesOfFaces[static_cast<std::size_t>(face) - 1], ends, samples);
  for (const EdgeEnd& one : atPoint.at(ends[edge].first))
    for (const EdgeEnd& other : atPoint.at(ends[edge].last))
      if (one.edge != edge && other.edge != edge &&
          dot(directionFrom(one, samples), directionFrom(other, samples)) > kAlong)
        return Strip{face, one, other};
  return std::nullopt;
}

/// The outward normal, of any length, of a face at the end of an edge; 0 if unknown.
Point3 normalAt(const ModelShape& model, int id, const EdgeEnd& end,
                const std::vector<EdgeSamples>& samples) {
  const std::vector<EdgePiece>& pieces = samples[end.edge].pieces;
  const double parameter =
      end.isStart ? pieces.front().parameters.front() : pieces.back().parameters.back();
  const TopoDS_Face face = model.face(id);
  const TopoDS_Edge edge = model.edge(static_cast<int>(end.edge) + 1);
  try {
    const Point3 normal =
        normalOnEdge(model.surface(id), TopoDS::Face(face.Oriented(TopAbs_FORWARD)),
                     TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), parameter);
    return (face.Orientation() == TopAbs_REVERSED ? -1. : 1.) * normal;
  } catch (const GeometryError&) {  // a face without a surface fails by itself
    return {};
  }
}

/// Of the faces beyond the side of a strip, where it begins.
std::vector<Point3> normalsBeyond(const ModelShape& model, int strip, const EdgeEnd& side,
                                  const std::vector<EdgeSamples>& samples) {
  std::vector<Point3> normals;
  for (const int id : model.facesOfEdges[side.edge])
    if (id != strip) normals.push_back(normalAt(model, id, side, samples));
  return normals;
}

/// Whether the faces on both sides of a strip would fold over each other if it were closed, as the
/// sides of a thin plate would. At a step they would be one.
bool wouldFold(const ModelShape& model, const Strip& strip,
               const std::vector<EdgeSamples>& samples) {
  constexpr double kFold = -0.5;  // cosine of 120 degrees
  const std::vector<Point3> ones = normalsBeyond(model, strip.face, strip.one, samples),
                            others = normalsBeyond(model, strip.face, strip.other, samples);
  if (ones.empty() || others.empty()) return true;
  for (const Point3& one : ones)
    for (const Point3& other : others)
      if (!(dot(one, other) > kFold * length(one) * length(other))) return true;
  return false;
}

/// Between faces one of which is no strip, or where nothing folds if all are closed.
bool endsSliver(const ModelShape& model, std::size_t edge, const std::vector<Ends>& ends,
                const std::vector<EdgeSamples>& samples) {
  const std::vector<int>& faces = model.facesOfEdges[edge];
  if (ends[edge].first == ends[edge].last || faces.size() < 2) return false;
  std::vector<Strip> strips;
  for (const int face : faces)
    if (const auto strip = stripBeyond(model, face, edge, ends, samples)) strips.push_back(*strip);
  return strips.size() < faces.size() || std::ranges::none_of(strips, [&](const Strip& strip) {
           return wouldFold(model, strip, samples);
         });
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
