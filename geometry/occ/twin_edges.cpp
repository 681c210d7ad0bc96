#include "geometry/occ/twin_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/occ/points.h"
#include "geometry/occ/touching_edges.h"

namespace af2::geometry {

namespace {

double distanceTo(const BRepAdaptor_Curve& curve, const EdgeRange& range, const Point3& point) {
  double least = 1e300;
  const Extrema_ExtPC extrema(toOcc(point), curve, range.first, range.last);
  if (!extrema.IsDone()) return least;
  for (int i = 1; i <= extrema.NbExt(); ++i)
    least = std::min(least, std::sqrt(extrema.SquareDistance(i)));
  return least;
}

/// From the tip of a wedge: the vertex at which both edges end, if at its other end one of them
/// only passes the end of the other. Infinite: there is no wedge.
double fromTip(const EdgePart& one, const EdgePart& other, const Point3& place) {
  const auto isEnd = [](const EdgePart& part, std::uint32_t end) {
    return (part.isFirst && end == part.ends.first) || (part.isLast && end == part.ends.last);
  };
  const auto isTip = [&](std::uint32_t end) { return isEnd(one, end) && isEnd(other, end); };
  if (isTip(one.ends.first) == isTip(one.ends.last)) return std::numeric_limits<double>::infinity();
  return distance(place, isTip(one.ends.first) ? one.samples.start : one.samples.end);
}

/// Whether some points between the ends of one part lie on the other.
bool runsAlong(const ModelShape& model, const EdgePart& one, const EdgePart& other) {
  constexpr int kPoints = 4;
  const int edge = static_cast<int>(one.edge) + 1, earlier = static_cast<int>(other.edge) + 1;
  const double wanted = one.samples.wanted;
  const double reach = reachOfEdge(model, edge, BRep_Tool::Tolerance(model.edge(earlier)), wanted);
  const BRepAdaptor_Curve curve(model.edge(edge)), along(model.edge(earlier));
  const EdgeRange range = one.range();
  for (int i = 1; i <= kPoints; ++i) {
    const double parameter = range.first + (range.last - range.first) * i / (kPoints + 1);
    const Point3 place = toPoint(curve.Value(parameter));
    const double from = fromTip(one, other, place);
    const double most = std::isfinite(from) ? reachInWedge(reach, wanted, from) : reach;
    if (!(distanceTo(along, other.range(), place) <= most)) return false;
  }
  return true;
}

/// Parts of each edge: [0] is edge 1.
std::vector<std::vector<std::size_t>> byEdge(const std::vector<EdgePart>& parts, int edges) {
  std::vector<std::vector<std::size_t>> all(static_cast<std::size_t>(edges));
  for (std::size_t i = 0; i < parts.size(); ++i) all[parts[i].edge].push_back(i);
  return all;
}

}  // namespace

std::vector<std::optional<std::size_t>> twinsOf(const ModelShape& model,
                                                const std::vector<EdgePart>& parts) {
  std::vector<std::optional<std::size_t>> twins(parts.size());
  const auto ofEdge = byEdge(parts, model.edges.Extent());
  for (int id = 1; id <= model.faces.Extent(); ++id) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> between;
    for (TopExp_Explorer it(model.face(id), TopAbs_EDGE); it.More(); it.Next())
      for (const std::size_t part :
           ofEdge[static_cast<std::size_t>(model.edges.FindIndex(it.Current())) - 1]) {
        std::vector<std::size_t>& others =
            between[std::minmax(parts[part].ends.first, parts[part].ends.last)];
        if (std::ranges::find(others, part) == others.end()) others.push_back(part);
      }
    for (auto& [points, found] : between) {
      std::ranges::sort(found);
      for (std::size_t i = 1; i < found.size(); ++i)
        for (std::size_t k = 0; k < i && !twins[found[i]]; ++k)
          if (runsAlong(model, parts[found[i]], parts[found[k]])) twins[found[i]] = found[k];
    }
  }
  return twins;
}

}  // namespace af2::geometry
