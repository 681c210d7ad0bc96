#include "geometry/occ/edges/twin_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Extrema_ExtPC.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/base/constants.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/touching_edges.h"

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

/// Whether some points between the ends of one part lie within `reach` of the other.
bool runsAlong(const ModelShape& model, const EdgePart& one, const EdgePart& other, double reach) {
  constexpr int kPoints = 4;
  const int edge = static_cast<int>(one.edge) + 1, earlier = static_cast<int>(other.edge) + 1;
  const double wanted = one.samples.wanted;
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

class TwinFinder {
 public:
  TwinFinder(const ModelShape& model, const std::vector<EdgePart>& parts)
      : model_(model),
        parts_(parts),
        ofEdge_(byEdge(parts, model.edges.Extent())),
        twins_(parts.size()),
        uses_(ofEdge_.size(), 0),
        isReversed_(ofEdge_.size(), false) {}

  std::vector<std::optional<std::size_t>> find() {
    for (int id = 1; id <= model_.faces.Extent(); ++id) findOnFace(id);
    findBetweenFaces();
    return std::move(twins_);
  }

 private:
  using PartsBetween = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>>;

  void findOnFace(int face) {
    PartsBetween between;
    const bool isTurned = model_.face(face).Orientation() == TopAbs_REVERSED;
    for (const EdgeUse& use : model_.edgesOfFaces[static_cast<std::size_t>(face) - 1]) {
      const auto edge = static_cast<std::size_t>(use.id) - 1;
      const TopAbs_Orientation way = use.edge.Orientation();
      ++uses_[edge];
      isReversed_[edge] = way == (isTurned ? TopAbs_FORWARD : TopAbs_REVERSED);
      for (const std::size_t part : ofEdge_[edge]) {
        if (parts_[part].isChain) continue;
        std::vector<std::size_t>& others = at(between, part);
        if (std::ranges::find(others, part) == others.end()) others.push_back(part);
      }
    }
    for (auto& [points, found] : between) {
      std::ranges::sort(found);
      for (std::size_t i = 1; i < found.size(); ++i)
        for (std::size_t k = 0; k < i && !twins_[found[i]]; ++k)
          if (runsAlong(model_, parts_[found[i]], parts_[found[k]], reachOf(found[i], found[k])))
            twins_[found[i]] = found[k];
    }
  }

  /// Each bounds one face only, from one side and the other: faces that were not sewn there.
  void findBetweenFaces() {
    constexpr double kNear = 1e-3;  // of the wanted size, whatever the tolerances say
    std::vector<bool> isTaken(parts_.size(), false);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (twins_[i]) isTaken[i] = isTaken[*twins_[i]] = true;
    PartsBetween between;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (uses_[parts_[i].edge] == 1 && !isTaken[i] && !parts_[i].isChain)
        at(between, i).push_back(i);
    for (auto& [points, found] : between) {
      if (points.first == points.second) continue;
      for (std::size_t i = 1; i < found.size(); ++i)
        for (std::size_t k = 0; k < i && !isTaken[found[i]]; ++k) {
          const EdgePart &later = parts_[found[i]], &earlier = parts_[found[k]];
          if (isTaken[found[k]] || startOf(later) == startOf(earlier)) continue;
          if (!runsAlong(model_, later, earlier, kNear * later.samples.wanted)) continue;
          twins_[found[i]] = found[k];
          isTaken[found[i]] = isTaken[found[k]] = true;
        }
    }
  }

  std::vector<std::size_t>& at(PartsBetween& between, std::size_t part) const {
    return between[std::minmax(parts_[part].ends.first, parts_[part].ends.last)];
  }
  /// How far two parts of edges of one face may be apart.
  double reachOf(std::size_t one, std::size_t other) const {
    const int edge = static_cast<int>(parts_[one].edge) + 1;
    const int earlier = static_cast<int>(parts_[other].edge) + 1;
    const double wanted = parts_[one].samples.wanted;
    const double reach =
        reachOfEdge(model_, edge, BRep_Tool::Tolerance(model_.edge(earlier)), wanted);
    return isShared(edge) && isShared(earlier) ? std::max(reach, kUnseenSliver * wanted) : reach;
  }
  bool isShared(int edge) const {
    return model_.facesOfEdges[static_cast<std::size_t>(edge) - 1].size() > 1;
  }
  /// Where the only face of an edge comes from when it runs along it.
  std::uint32_t startOf(const EdgePart& part) const {
    return isReversed_[part.edge] ? part.ends.last : part.ends.first;
  }

  const ModelShape& model_;
  const std::vector<EdgePart>& parts_;
  std::vector<std::vector<std::size_t>> ofEdge_;
  std::vector<std::optional<std::size_t>> twins_;
  std::vector<int> uses_;         // by edge: how often faces run along it
  std::vector<bool> isReversed_;  // by edge: on the face that came last
};

}  // namespace

std::vector<std::optional<std::size_t>> twinsOf(const ModelShape& model,
                                                const std::vector<EdgePart>& parts) {
  return TwinFinder(model, parts).find();
}

}  // namespace af2::geometry
