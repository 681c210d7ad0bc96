#include "geometry/occ/given_points.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <algorithm>
#include <cstdio>
#include <limits>

#include "engine/error.h"
#include "geometry/occ/points.h"

namespace af2::geometry {
namespace {

std::string textOf(const Point3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return text;
}

struct Foot {
  double parameter = 0, distance = std::numeric_limits<double>::infinity();
};

/// The nearest point of a curve.
Foot footOf(const Point3& point, const BRepAdaptor_Curve& curve, const EdgeRange& range) {
  Foot best;
  const Extrema_ExtPC extrema(toOcc(point), curve, range.first, range.last);
  if (!extrema.IsDone()) return best;
  for (int i = 1; i <= extrema.NbExt(); ++i) {
    const double away = std::sqrt(extrema.SquareDistance(i));
    if (away < best.distance) best = {extrema.Point(i).Parameter(), away};
  }
  return best;
}

[[noreturn]] void refuse(int edge, std::size_t index, const Point3& point,
                         const std::string& fault) {
  throw InputError("point " + std::to_string(index + 1) + " given for edge " +
                   std::to_string(edge) + ", " + textOf(point) + ": " + fault);
}

}  // namespace

GivenPoints placeOnEdge(const ModelShape& model, int edgeId, std::vector<Point3> points,
                        const EdgeRange& range) {
  constexpr double kShareOfSegment = 0.01;
  const TopoDS_Edge edge = model.edge(edgeId);
  const BRepAdaptor_Curve curve(edge);
  const double segment = range.length / static_cast<double>(points.size() + 1);
  const double tolerance =
      std::max({BRep_Tool::Tolerance(edge), kShareOfSegment * segment, range.tolerance});
  GivenPoints given;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Foot foot = footOf(points[i], curve, range);
    if (!(foot.distance <= tolerance))
      refuse(edgeId, i, points[i],
             foot.distance < 1e300
                 ? "it lies " + std::to_string(foot.distance) + " beside the edge"
                 : "it lies beside the ends of the edge; give the points between them");
    given.parameters.push_back(foot.parameter);
  }
  if (points.size() > 1 && given.parameters.front() > given.parameters.back()) {
    std::reverse(points.begin(), points.end());
    std::reverse(given.parameters.begin(), given.parameters.end());
  }
  given.parameters.insert(given.parameters.begin(), range.first);
  given.parameters.push_back(range.last);
  for (std::size_t i = 0; i + 1 < given.parameters.size(); ++i)
    if (!(given.parameters[i] < given.parameters[i + 1]))
      refuse(edgeId, std::min(i, points.size() - 1), points[std::min(i, points.size() - 1)],
             "the points are not in order along the edge, or one is given twice");
  given.points = std::move(points);
  return given;
}

}  // namespace af2::geometry
