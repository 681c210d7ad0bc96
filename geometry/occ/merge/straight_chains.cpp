#include "geometry/occ/merge/straight_chains.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/base/elementary.h"
#include "geometry/occ/base/points.h"

namespace af2::geometry {

namespace {

class ChainFinder {
 public:
  ChainFinder(const GroupingInput& input, const FaceGrouping& grouping)
      : in_(input), grouping_(grouping), ends_(input.joints.size()), isTaken_(input.joints.size()) {
    for (std::size_t e = 0; e < ends_.size(); ++e) addEnds(e);
  }

  std::vector<EdgeChain> find() {
    for (std::size_t e = 0; e < ends_.size(); ++e)
      if (!isTaken_[e] && isEligible(e)) addRun(runThrough(e));
    return std::move(chains_);
  }

 private:
  struct Ends {
    int first = 0, last = 0;  // vertices; 0: it has none
  };
  struct Place {
    int kept = 0;           // ends of edges that the mesh follows
    bool hasInner = false;  // an edge that the mesh crosses ends here
    bool isFixed = false;   // something else is here
    std::vector<std::size_t> edges;
  };
  /// Edges one after the other, and whether the last one ends where the first one begins.
  struct Run {
    std::vector<ChainLink> links;
    bool isClosed = false;
  };

  void addEnds(std::size_t e) {
    const TopoDS_Edge edge = TopoDS::Edge(in_.model.edge(static_cast<int>(e) + 1));
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    if (!first.IsNull()) ends_[e].first = in_.model.vertices.FindIndex(first);
    if (!last.IsNull()) ends_[e].last = in_.model.vertices.FindIndex(last);
    for (const int v : {ends_[e].first, ends_[e].last}) {
      if (v == 0) continue;
      Place& place = places_[v];
      if (BRep_Tool::Degenerated(edge)) place.isFixed = true;
      if (BRep_Tool::Degenerated(edge)) continue;
      if (grouping_.isInner[e]) {
        place.hasInner = place.hasInner || !in_.joints[e].isSeam();
        continue;
      }
      ++place.kept;
      place.isFixed = place.isFixed || !isEligible(e);
      place.edges.push_back(e);
    }
  }

  /// Whether an edge may be part of a chain: all its faces are meshed in a way that can do it.
  bool isEligible(std::size_t e) const {
    const std::vector<int>& faces = in_.model.facesOfEdges[e];
    const TopoDS_Edge edge = in_.model.edge(static_cast<int>(e) + 1);
    return !grouping_.isInner[e] && !in_.isKept[e] && !BRep_Tool::Degenerated(edge) &&
           ends_[e].first > 0 && ends_[e].last > 0 && ends_[e].first != ends_[e].last &&
           !faces.empty() && std::ranges::all_of(faces, [&](int face) {
             const auto f = static_cast<std::size_t>(face) - 1;
             return in_.mayMerge[f] && !grouping_.isAlone[f];
           });
  }

  bool isShort(std::size_t e) const { return in_.lengths[e] < shortAt(in_, e); }

  /// Whether a vertex may be left out, as far as its turn is not concerned.
  bool mayGo(int vertex) const {
    const Place& place = places_.at(vertex);
    if (place.isFixed || place.kept != 2 || place.edges[0] == place.edges[1]) return false;
    return place.hasInner || isShort(place.edges[0]) || isShort(place.edges[1]);
  }

  int startOf(const ChainLink& link) const {
    const Ends& ends = ends_[static_cast<std::size_t>(link.edge) - 1];
    return link.isReversed ? ends.last : ends.first;
  }
  int endOf(const ChainLink& link) const { return startOf({link.edge, !link.isReversed}); }

  /// The edge that follows in a run.
  ChainLink after(const ChainLink& link) const {
    const int vertex = endOf(link);
    const Place& place = places_.at(vertex);
    const std::size_t here = static_cast<std::size_t>(link.edge) - 1;
    const std::size_t next = place.edges[place.edges[0] == here ? 1 : 0];
    return {static_cast<int>(next) + 1, ends_[next].first != vertex};
  }

  Run runThrough(std::size_t edge) {
    Run run;
    ChainLink link{static_cast<int>(edge) + 1, false};
    while (mayGo(startOf(link))) {  // back to where it begins
      const ChainLink before = after({link.edge, !link.isReversed});
      link = {before.edge, !before.isReversed};
      if (link.edge == static_cast<int>(edge) + 1) {
        run.isClosed = true;
        break;
      }
    }
    const int first = link.edge;
    do {
      run.links.push_back(link);
      isTaken_[static_cast<std::size_t>(link.edge) - 1] = true;
      if (!mayGo(endOf(link))) break;
      link = after(link);
    } while (link.edge != first);
    return run;
  }

  Point3 directionAt(const ChainLink& link, bool atStart) const {
    const BRepAdaptor_Curve curve(in_.model.edge(link.edge));
    const bool atFirst = atStart != link.isReversed;
    gp_Pnt place;
    gp_Vec tangent;
    curve.D1(atFirst ? curve.FirstParameter() : curve.LastParameter(), place, tangent);
    const Point3 along = unit(toPoint(tangent));
    return link.isReversed ? -1 * along : along;
  }

  double turnBetween(const ChainLink& one, const ChainLink& next) const {
    const Point3 a = directionAt(one, false), b = directionAt(next, true);
    return angleBetween(a, b);
  }

  double mostTurn(const ChainLink& link) const {
    return mostTurnAt(in_, static_cast<std::size_t>(link.edge) - 1);
  }

  /// By link: whether the vertex before it stays. Short edges between two others count by the turn
  /// from the one to the other.
  std::vector<bool> cornersOf(const Run& run) const {
    const std::size_t count = run.links.size();
    std::vector<bool> isCorner(count, false);
    if (!run.isClosed) isCorner[0] = true;
    std::vector<std::size_t> longer;
    for (std::size_t i = 0; i < count; ++i)
      if (!isShort(static_cast<std::size_t>(run.links[i].edge) - 1)) longer.push_back(i);
    for (std::size_t k = 0; k < longer.size(); ++k) {
      const bool isLast = k + 1 == longer.size();
      if (isLast && !run.isClosed) break;
      const std::size_t here = longer[k], next = longer[isLast ? 0 : k + 1];
      const std::size_t gap = (next + count - here) % count;  // 0: the only one in a closed run
      if (turnBetween(run.links[here], run.links[next]) > mostTurn(run.links[here]) ||
          isWide(run, here, gap))
        isCorner[(here + 1) % count] = true;
    }
    return isCorner;
  }

  /// Whether short edges together are longer than a short edge may be.
  bool isWide(const Run& run, std::size_t after, std::size_t gap) const {
    double sum = 0, most = 0;
    for (std::size_t i = 1; i < gap; ++i) {
      const auto edge =
          static_cast<std::size_t>(run.links[(after + i) % run.links.size()].edge) - 1;
      sum += in_.lengths[edge];
      most = shortAt(in_, edge);
    }
    return gap > 1 && sum > most;
  }

  void addRun(Run run) {
    std::vector<bool> isCorner = cornersOf(run);
    const auto first = std::ranges::find(isCorner, true) - isCorner.begin();
    if (first > 0 && static_cast<std::size_t>(first) < isCorner.size()) {
      std::ranges::rotate(run.links, run.links.begin() + first);
      std::rotate(isCorner.begin(), isCorner.begin() + first, isCorner.end());
    }
    EdgeChain chain;
    for (std::size_t i = 0; i < run.links.size(); ++i) {
      if (i > 0 && isCorner[i]) flush(chain);
      chain.links.push_back(run.links[i]);
    }
    flush(chain);
  }

  void flush(EdgeChain& chain) {
    if (chain.links.size() > 1) chains_.push_back(chain);
    chain.links.clear();
  }

  const GroupingInput& in_;
  const FaceGrouping& grouping_;
  std::vector<Ends> ends_;  // by edge
  std::vector<bool> isTaken_;
  std::map<int, Place> places_;
  std::vector<EdgeChain> chains_;
};

}  // namespace

std::vector<EdgeChain> straightChains(const GroupingInput& input, const FaceGrouping& grouping) {
  return ChainFinder(input, grouping).find();
}

}  // namespace af2::geometry
