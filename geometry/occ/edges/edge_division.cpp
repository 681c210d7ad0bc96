#include "geometry/occ/edges/edge_division.h"

#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>

#include "geometry/occ/base/merged_points.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/beside_tips.h"
#include "geometry/occ/edges/corner_edges.h"
#include "geometry/occ/edges/crease_reach.h"
#include "geometry/occ/edges/cusps.h"
#include "geometry/occ/edges/edge_chains.h"
#include "geometry/occ/edges/narrow_strips.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/edges/part_division.h"
#include "geometry/occ/edges/point_edges.h"
#include "geometry/occ/edges/tip_fans.h"
#include "geometry/occ/edges/touching_edges.h"
#include "geometry/occ/sizes/sizing.h"

namespace af2::geometry {

namespace {

/// From the samples of edges to their parts.
class Preparation {
 public:
  Preparation(const ModelShape& model, const SampledEdges& sampled, const CadSizes& sizes,
              int threads, const std::stop_token& stop, const EdgePoints& given,
              const CollapsedEdges& asPoints, const MergedEdges& merged, KnownStrips* strips)
      : model_(model),
        sizes_(sizes),
        given_(given),
        asPoints_(asPoints),
        merged_(merged),
        samples_(limitedSamples(model, sampled, sizes, threads, stop)),
        isMerged_(samples_.size(), false) {
    findEnds();
    leaveOutMerged();
    mergePoints();
    findTips();
    limitInStrips(model_, sizes_, ends_, threads, samples_, merged_.narrowFaces, strips);
    takeChains();
    limitAtShortEdges(model_, sizes_, ends_, samples_);
    beginEdges();
    makeParts();
    gradeAll();
  }

  EdgeParts take() { return std::move(made_); }

 private:
  void findEnds() {
    for (int id = 1; id <= model_.vertices.Extent(); ++id)
      made_.edges.points.push_back(toPoint(BRep_Tool::Pnt(model_.vertex(id))));
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const TopoDS_Edge edge =
          TopoDS::Edge(model_.edge(static_cast<int>(i) + 1).Oriented(TopAbs_FORWARD));
      ends_.push_back(endsOf(edge, samples_[i]));
    }
  }

  /// What the mesh does not follow has no samples, and no edge of a chain is a point.
  void leaveOutMerged() {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      isMerged_[i] = merged_.removes(i);
      if (isMerged_[i]) samples_[i].pieces.clear();
    }
    for (const EdgeChain& chain : merged_.chains)
      for (const ChainLink& link : chain.links) isMerged_[indexOf(link)] = true;
  }

  /// From here on the edges of a chain are one.
  void takeChains() {
    for (const EdgeChain& chain : merged_.chains) {
      chains_.push_back(chainedSamples(model_, chain, samples_));
      for (const ChainLink& link : chain.links) samples_[indexOf(link)].pieces.clear();
    }
    std::erase_if(made_.cusps, [&](const auto& cusp) { return isMerged_[cusp.first.edge]; });
  }

  static std::size_t indexOf(const ChainLink& link) {
    return static_cast<std::size_t>(link.edge) - 1;
  }

  /// An edge may lack vertices, e.g. a full circle; it then gets points of its own.
  Ends endsOf(const TopoDS_Edge& edge, const EdgeSamples& samples) {
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    Ends ends;
    ends.first = first.IsNull() ? made_.addPoint(samples.start) : indexOf(first);
    const bool closed = distance(samples.start, samples.end) <= 1e-9 * model_.diagonal;
    if (!last.IsNull())
      ends.last = indexOf(last);
    else
      ends.last = closed ? ends.first : made_.addPoint(samples.end);
    return ends;
  }

  std::uint32_t indexOf(const TopoDS_Vertex& vertex) const {
    return static_cast<std::uint32_t>(model_.vertices.FindIndex(vertex) - 1);
  }

  double pointLengthOf(std::size_t i) const {
    return pointLength(model_, static_cast<int>(i) + 1, ends_, samples_);
  }

  bool isAskedToBePoint(std::size_t i) const { return asPoints_.contains(static_cast<int>(i) + 1); }

  /// Given divisions are used unchanged.
  bool mayBePoint(std::size_t i) const {
    return !givenFor(i) &&
           (isAskedToBePoint(i) || spanOf(samples_[i], ends_[i]) <= pointLengthOf(i));
  }

  /// How far apart points may be that become one because this edge is none.
  double mostExtent(std::size_t i) const {
    const auto found = asPoints_.find(static_cast<int>(i) + 1);
    return found != asPoints_.end() ? found->second : 2 * pointLengthOf(i);
  }

  /// The shortest first. Many short edges one after the other may make a long one, which is none.
  void mergeAlongShortEdges(MergedPoints& merging) {
    std::vector<std::size_t> edges;
    std::vector<double> most(samples_.size(), 0);  // as long as all edges have their samples
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (isMerged_[i] || !samples_[i].problem.empty()) continue;
      const bool isPoint = samples_[i].pieces.empty();
      if (!isPoint && !mayBePoint(i)) continue;
      edges.push_back(i);
      if (!isPoint) most[i] = mostExtent(i);
    }
    std::ranges::stable_sort(edges, {}, [&](std::size_t i) { return samples_[i].length; });
    std::vector<std::pair<std::size_t, double>> asked;
    for (const std::size_t i : edges) {
      const Ends ends = ends_[i];
      const bool isPoint =
          samples_[i].pieces.empty() || merging.find(ends.first) == merging.find(ends.last);
      if (!isPoint && merging.extent(ends.first, ends.last) > most[i]) continue;
      if (isAskedToBePoint(i)) asked.emplace_back(i, extentOf(samples_[i]));
      samples_[i].pieces.clear();
      merging.merge(ends.first, ends.last);
    }
    for (const auto& [i, extent] : asked) made_.blind[merging.find(ends_[i].first)] += extent;
  }

  void mergePoints() {
    MergedPoints merging(made_.edges.points);
    mergeAlongShortEdges(merging);
    apply(merging);
    for (const auto& [end, start] : gaps()) merging.merge(end, start);
    apply(merging);
    creases_ = CreaseReach(model_, [&](std::uint32_t point) { return merging.find(point); });
    for (const auto& [point, reach] : creases_.byPoint())
      made_.blind[point] = std::max(made_.blind[point], reach / kTimesBlind);
  }

  void findTips() {
    std::vector<bool> isGiven;
    for (std::size_t i = 0; i < samples_.size(); ++i) isGiven.push_back(givenFor(i) != nullptr);
    made_.tips = segmentsAtTips(model_, ends_, samples_, isGiven);
    if (limitBesideTips(model_, sizes_, ends_, made_.tips, isGiven, samples_))
      made_.tips = segmentsAtTips(model_, ends_, samples_, isGiven);
    made_.cusps = cuspsOf(model_, ends_, samples_);
  }

  void apply(MergedPoints& merging) {
    for (Ends& ends : ends_) ends = {merging.find(ends.first), merging.find(ends.last)};
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> gaps() const {
    std::vector<bool> isUsed = isMerged_;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (!samples_[i].pieces.empty()) isUsed[i] = true;
    return gapsBetweenEnds(model_, sizes_.size, ends_, isUsed, made_.edges.points);
  }

  void beginEdges() {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      DividedEdge& edge = made_.edges.edges.emplace_back();
      edge.problem = samples_[i].problem;
      edge.wanted = samples_[i].wanted;
      if (samples_[i].pieces.empty() && isAskedToBePoint(i)) edge.point = ends_[i].first;
    }
  }

  /// Of the samples, which go to the parts. Given divisions are not divided any further.
  void makeParts() {
    std::vector<bool> mayBeSplit;
    for (std::size_t i = 0; i < samples_.size(); ++i) mayBeSplit.push_back(!givenFor(i));
    const auto stops = stopsOf(model_, ends_, samples_, made_.edges.points, mayBeSplit);
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (!samples_[i].pieces.empty()) addParts(i, stops[i]);
    for (std::size_t c = 0; c < chains_.size(); ++c)
      if (!chains_[c].pieces.empty())
        made_.parts.push_back(chainPart(merged_.chains[c], std::move(chains_[c]), ends_));
    std::ranges::stable_sort(made_.parts, {}, &EdgePart::edge);
  }

  void addParts(std::size_t edge, const std::vector<Stop>& stops) {
    for (EdgePart& part : partsBetween(edge, std::move(samples_[edge]), ends_[edge], stops)) {
      if (!givenFor(edge)) creases_.leaveOut(part);
      made_.parts.push_back(std::move(part));
    }
  }

  /// Sizes at shared ends agree, and grow from there no faster than wanted.
  void gradeAll() {
    constexpr int kRounds = 3;  // a short edge passes a small size on to the edges beyond it
    std::vector<double> atPoint(made_.edges.points.size(), 1e300);
    for (const auto& [edge, points] : given_) limitBesideGiven(edge, points, atPoint);
    for (int round = 0; round < kRounds; ++round) {
      for (EdgePart& part : made_.parts) {
        if (givenFor(part.edge)) continue;
        double &first = atPoint[part.ends.first], &last = atPoint[part.ends.last];
        gradeSizes(part.samples, first, last, sizes_.growth);
        first = std::min(first, part.samples.pieces.front().sizes.front());
        last = std::min(last, part.samples.pieces.back().sizes.back());
      }
    }
  }

  /// The edges beyond the ends of a given one are to go on from its segments there.
  void limitBesideGiven(int edge, const std::vector<Point3>& points,
                        std::vector<double>& atPoint) const {
    const Ends ends = ends_[static_cast<std::size_t>(edge) - 1];
    if (points.empty()) return;
    for (const std::uint32_t end : {ends.first, ends.last}) {
      const Point3& p = made_.edges.points[end];
      const double segment = std::min(distance(p, points.front()), distance(p, points.back()));
      atPoint[end] = std::min(atPoint[end], bounded(sizes_, segment));
    }
  }

  const std::vector<Point3>* givenFor(std::size_t edge) const {
    return pointsGivenFor(given_, edge);
  }

  const ModelShape& model_;
  const CadSizes& sizes_;
  const EdgePoints& given_;
  const CollapsedEdges& asPoints_;
  const MergedEdges& merged_;
  std::vector<EdgeSamples> samples_;
  std::vector<bool> isMerged_;       // by edge: it is crossed, or in a chain
  std::vector<EdgeSamples> chains_;  // in the order of merged_
  std::vector<Ends> ends_;
  CreaseReach creases_;  // by point
  EdgeParts made_;
};

}  // namespace

DividedEdges divideEdges(const ModelShape& model, const SampledEdges& sampled,
                         const CadSizes& sizes, int threads, const std::stop_token& stop,
                         const EdgePoints& given, const CollapsedEdges& asPoints,
                         const SegmentChanges& changes, const MergedEdges& merged,
                         const LayerEnds& ends, KnownStrips* strips) {
  return divideParts(
      model, sizes, {given, changes, merged, ends}, threads,
      Preparation(model, sampled, sizes, threads, stop, given, asPoints, merged, strips).take());
}

}  // namespace af2::geometry
