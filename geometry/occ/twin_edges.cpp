#include "geometry/occ/twin_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>

#include "geometry/occ/points.h"

namespace af2::geometry {

namespace {

double distanceTo(const BRepAdaptor_Curve& curve, const Point3& point) {
  double least = 1e300;
  const Extrema_ExtPC extrema(toOcc(point), curve);
  if (!extrema.IsDone()) return least;
  for (int i = 1; i <= extrema.NbExt(); ++i)
    least = std::min(least, std::sqrt(extrema.SquareDistance(i)));
  return least;
}

/// Whether some points between the ends of one edge lie on the other.
bool runsAlong(const ModelShape& model, std::size_t one, std::size_t other,
               const EdgeSamples& samples) {
  constexpr int kPoints = 4;
  constexpr double kMost = 1e-3;  // of the wanted size, whatever the tolerances say
  const TopoDS_Edge edge = model.edge(static_cast<int>(one) + 1);
  const TopoDS_Edge earlier = model.edge(static_cast<int>(other) + 1);
  const double blur = std::max(1e-9 * model.diagonal, kUnseen * samples.wanted);
  const double tolerance =
      std::min(BRep_Tool::Tolerance(edge) + BRep_Tool::Tolerance(earlier), kMost * samples.wanted) +
      blur;
  const BRepAdaptor_Curve curve(edge), along(earlier);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  for (int i = 1; i <= kPoints; ++i) {
    const double parameter = first + (last - first) * i / (kPoints + 1);
    if (!(distanceTo(along, toPoint(curve.Value(parameter))) <= tolerance)) return false;
  }
  return true;
}

}  // namespace

std::vector<std::optional<std::size_t>> twinsOf(const ModelShape& model,
                                                const std::vector<Ends>& ends,
                                                const std::vector<EdgeSamples>& samples) {
  std::vector<std::optional<std::size_t>> twins(samples.size());
  for (int id = 1; id <= model.faces.Extent(); ++id) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> between;
    for (TopExp_Explorer it(model.face(id), TopAbs_EDGE); it.More(); it.Next()) {
      const auto edge = static_cast<std::size_t>(model.edges.FindIndex(it.Current())) - 1;
      if (samples[edge].pieces.empty()) continue;
      std::vector<std::size_t>& others = between[std::minmax(ends[edge].first, ends[edge].last)];
      if (std::ranges::find(others, edge) == others.end()) others.push_back(edge);
    }
    for (auto& [points, edges] : between) {
      std::ranges::sort(edges);
      for (std::size_t i = 1; i < edges.size(); ++i)
        for (std::size_t k = 0; k < i && !twins[edges[i]]; ++k)
          if (runsAlong(model, edges[i], edges[k], samples[edges[i]])) twins[edges[i]] = edges[k];
    }
  }
  return twins;
}

}  // namespace af2::geometry
