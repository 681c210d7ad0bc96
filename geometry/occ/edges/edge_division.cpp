#include "geometry/occ/edges/edge_division.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>
#include <optional>

#include "engine/base/error.h"
#include "geometry/base/parallel.h"
#include "geometry/edges/curve_division.h"
#include "geometry/occ/base/merged_points.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/beside_tips.h"
#include "geometry/occ/edges/corner_edges.h"
#include "geometry/occ/edges/crease_reach.h"
#include "geometry/occ/edges/cusps.h"
#include "geometry/occ/edges/edge_chains.h"
#include "geometry/occ/edges/given_points.h"
#include "geometry/occ/edges/layer_parts.h"
#include "geometry/occ/edges/narrow_strips.h"
#include "geometry/occ/edges/open_ends.h"
#include "geometry/occ/edges/point_edges.h"
#include "geometry/occ/edges/tip_fans.h"
#include "geometry/occ/edges/touching_edges.h"
#include "geometry/occ/edges/twin_edges.h"
#include "geometry/occ/sizes/sizing.h"

namespace af2::geometry {

namespace {

class Division {
 public:
  Division(const ModelShape& model, const SampledEdges& sampled, const CadSizes& sizes, int threads,
           const std::stop_token& stop, const EdgePoints& given, const CollapsedEdges& asPoints,
           const SegmentChanges& changes, const MergedEdges& merged, const LayerEnds& layers,
           KnownStrips* strips)
      : model_(model),
        sizes_(sizes),
        given_(given),
        asPoints_(asPoints),
        changes_(changes),
        merged_(merged),
        layerEnds_(layers),
        threads_(threads),
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

  DividedEdges result() {
    twins_ = twinsOf(model_, parts_);
    std::vector<CurveEnds> ends;
    for (const EdgePart& part : parts_) ends.push_back({part.ends.first, part.ends.last});
    const std::vector<std::size_t> least = leastSegments(ends);
    const std::vector<DividedCurve> curves = divideAlone(least);
    for (std::size_t i = 0; i < parts_.size(); ++i) dividePart(i, least[i], curves[i]);
    joinParts();
    return std::move(result_);
  }

 private:
  void findEnds() {
    for (int id = 1; id <= model_.vertices.Extent(); ++id)
      result_.points.push_back(toPoint(BRep_Tool::Pnt(model_.vertex(id))));
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
    std::erase_if(cusps_, [&](const auto& cusp) { return isMerged_[cusp.first.edge]; });
  }

  static std::size_t indexOf(const ChainLink& link) {
    return static_cast<std::size_t>(link.edge) - 1;
  }

  /// An edge may lack vertices, e.g. a full circle; it then gets points of its own.
  Ends endsOf(const TopoDS_Edge& edge, const EdgeSamples& samples) {
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    Ends ends;
    ends.first = first.IsNull() ? addPoint(samples.start) : indexOf(first);
    const bool closed = distance(samples.start, samples.end) <= 1e-9 * model_.diagonal;
    if (!last.IsNull())
      ends.last = indexOf(last);
    else
      ends.last = closed ? ends.first : addPoint(samples.end);
    return ends;
  }

  std::uint32_t indexOf(const TopoDS_Vertex& vertex) const {
    return static_cast<std::uint32_t>(model_.vertices.FindIndex(vertex) - 1);
  }
  std::uint32_t addPoint(const Point3& point) {
    result_.points.push_back(point);
    return static_cast<std::uint32_t>(result_.points.size() - 1);
  }

  double pointLengthOf(std::size_t i) const {
    return pointLength(model_, static_cast<int>(i) + 1, samples_[i]);
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
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (!isMerged_[i] && samples_[i].problem.empty() &&
          (samples_[i].pieces.empty() || mayBePoint(i)))
        edges.push_back(i);
    std::ranges::stable_sort(edges, {}, [&](std::size_t i) { return samples_[i].length; });
    std::vector<std::pair<std::size_t, double>> asked;
    for (const std::size_t i : edges) {
      const Ends ends = ends_[i];
      const bool isPoint =
          samples_[i].pieces.empty() || merging.find(ends.first) == merging.find(ends.last);
      if (!isPoint && merging.extent(ends.first, ends.last) > mostExtent(i)) continue;
      if (isAskedToBePoint(i)) asked.emplace_back(i, extentOf(samples_[i]));
      samples_[i].pieces.clear();
      merging.merge(ends.first, ends.last);
    }
    for (const auto& [i, extent] : asked) blind_[merging.find(ends_[i].first)] += extent;
  }

  void mergePoints() {
    MergedPoints merging(result_.points);
    mergeAlongShortEdges(merging);
    apply(merging);
    for (const auto& [end, start] : gaps()) merging.merge(end, start);
    apply(merging);
    creases_ = CreaseReach(model_, [&](std::uint32_t point) { return merging.find(point); });
    for (const auto& [point, reach] : creases_.byPoint())
      blind_[point] = std::max(blind_[point], reach / kTimesBlind);
  }

  void findTips() {
    std::vector<bool> isGiven;
    for (std::size_t i = 0; i < samples_.size(); ++i) isGiven.push_back(givenFor(i) != nullptr);
    tips_ = segmentsAtTips(model_, ends_, samples_, isGiven);
    if (limitBesideTips(model_, sizes_, ends_, tips_, isGiven, samples_))
      tips_ = segmentsAtTips(model_, ends_, samples_, isGiven);
    cusps_ = cuspsOf(model_, ends_, samples_);
  }

  void apply(MergedPoints& merging) {
    for (Ends& ends : ends_) ends = {merging.find(ends.first), merging.find(ends.last)};
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> gaps() const {
    std::vector<bool> isUsed = isMerged_;
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (!samples_[i].pieces.empty()) isUsed[i] = true;
    return gapsBetweenEnds(model_, sizes_.size, ends_, isUsed, result_.points);
  }

  void beginEdges() {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      DividedEdge& edge = result_.edges.emplace_back();
      edge.problem = samples_[i].problem;
      edge.wanted = samples_[i].wanted;
      if (samples_[i].pieces.empty() && isAskedToBePoint(i)) edge.point = ends_[i].first;
    }
  }

  /// Of the samples, which go to the parts. Given divisions are not divided any further.
  void makeParts() {
    std::vector<bool> mayBeSplit;
    for (std::size_t i = 0; i < samples_.size(); ++i) mayBeSplit.push_back(!givenFor(i));
    const auto stops = stopsOf(model_, ends_, samples_, result_.points, mayBeSplit);
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (!samples_[i].pieces.empty()) addParts(i, stops[i]);
    for (std::size_t c = 0; c < chains_.size(); ++c)
      if (!chains_[c].pieces.empty())
        parts_.push_back(chainPart(merged_.chains[c], std::move(chains_[c]), ends_));
    std::ranges::stable_sort(parts_, {}, &EdgePart::edge);
  }

  void addParts(std::size_t edge, const std::vector<Stop>& stops) {
    for (EdgePart& part : partsBetween(edge, std::move(samples_[edge]), ends_[edge], stops)) {
      if (!givenFor(edge)) creases_.leaveOut(part);
      parts_.push_back(std::move(part));
    }
  }

  const std::vector<Point3>* givenFor(std::size_t edge) const {
    const auto found = given_.find(static_cast<int>(edge) + 1);
    return found == given_.end() ? nullptr : &found->second;
  }

  /// Sizes at shared ends agree, and grow from there no faster than wanted.
  void gradeAll() {
    constexpr int kRounds = 3;  // a short edge passes a small size on to the edges beyond it
    std::vector<double> atPoint(result_.points.size(), 1e300);
    for (const auto& [edge, points] : given_) limitBesideGiven(edge, points, atPoint);
    for (int round = 0; round < kRounds; ++round) {
      for (EdgePart& part : parts_) {
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
      const Point3& p = result_.points[end];
      const double segment = std::min(distance(p, points.front()), distance(p, points.back()));
      atPoint[end] = std::min(atPoint[end], bounded(sizes_, segment));
    }
  }

  /// Points along a part, ends included.
  struct DividedPart {
    std::vector<double> parameters;
    std::vector<std::uint32_t> points;
  };

  DividedPart between(const Ends& ends, std::vector<double> parameters,
                      const std::vector<std::uint32_t>& inner) const {
    DividedPart part{std::move(parameters), {ends.first}};
    part.points.insert(part.points.end(), inner.begin(), inner.end());
    part.points.push_back(ends.last);
    return part;
  }

  /// Takes the points that are given for an edge, in its own direction.
  DividedPart takeGiven(const EdgePart& part, std::size_t least,
                        const std::vector<Point3>& points) {
    const int id = static_cast<int>(part.edge) + 1;
    const BRepAdaptor_Curve curve(model_.edge(id));
    requireSegments(id, points.size(), least);
    PlacedPoints given =
        placeOnEdge(model_, id, points,
                    {curve.FirstParameter(), curve.LastParameter(), part.samples.length, 0});
    std::vector<std::uint32_t> inner;
    for (const Point3& point : given.points) inner.push_back(addPoint(point));
    return between(part.ends, std::move(given.parameters), inner);
  }

  /// The vertices between the ends of a part that runs along an earlier one are those of that one.
  std::optional<DividedPart> takeFromTwin(const EdgePart& part, const DividedPart& twin) const {
    std::vector<std::uint32_t> inner(twin.points.begin() + 1, twin.points.end() - 1);
    std::vector<Point3> positions;
    for (const std::uint32_t p : inner) positions.push_back(result_.points[p]);
    EdgeRange range = part.range();
    range.tolerance = kMaxBetweenTouching * part.samples.wanted;
    try {
      PlacedPoints placed = placeOnEdge(model_, static_cast<int>(part.edge) + 1, positions, range);
      if (!(placed.points == positions)) std::ranges::reverse(inner);
      return between(part.ends, std::move(placed.parameters), inner);
    } catch (const InputError&) {
      return std::nullopt;  // they part somewhere
    }
  }

  /// A part before its vertices have numbers.
  struct DividedCurve {
    std::vector<double> parameters;  // ends included
    std::vector<Point3> inner;       // between the ends
  };

  DividedCurve divideCurve(std::size_t i, std::size_t least) const {
    const EdgePart& part = parts_[i];
    DividedCurve curve{divideBetweenLayers(model_, part, layerEnds_, cusps_, tips_,
                                           {least, changeAt(changes_, i)}, sizes_),
                       {}};
    const PointAt pointAt = curveOf(model_, part, merged_);
    leaveOutBesidePoints(part.ends, least, pointAt, curve.parameters);
    for (std::size_t k = 1; k + 1 < curve.parameters.size(); ++k)
      curve.inner.push_back(pointAt(curve.parameters[k]));
    return curve;
  }

  /// By part, without those that follow other points.
  std::vector<DividedCurve> divideAlone(const std::vector<std::size_t>& least) const {
    constexpr std::size_t kAtOnce = 8;
    std::vector<DividedCurve> curves(parts_.size());
    forEachInRanges(parts_.size(), kAtOnce, threads_, [&](std::size_t i) {
      if (!twins_[i] && !givenFor(parts_[i].edge)) curves[i] = divideCurve(i, least[i]);
    });
    return curves;
  }

  DividedPart withVertices(const EdgePart& part, const DividedCurve& curve) {
    std::vector<std::uint32_t> inner;
    for (const Point3& point : curve.inner) inner.push_back(addPoint(point));
    return between(part.ends, curve.parameters, inner);
  }

  /// Beside what was taken for a point although it can be seen, segments are longer than that is
  /// large: a shorter one would look into it.
  void leaveOutBesidePoints(const Ends& ends, std::size_t least, const PointAt& pointAt,
                            std::vector<double>& parameters) const {
    for (const std::uint32_t end : {ends.first, ends.last}) {
      const auto found = blind_.find(end);
      if (found == blind_.end()) continue;
      const Point3& place = result_.points[end];
      for (std::size_t k = parameters.size() - 2; k > 0 && parameters.size() > least + 1; --k)
        if (distance(pointAt(parameters[k]), place) < kTimesBlind * found->second)
          parameters.erase(parameters.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

  void dividePart(std::size_t i, std::size_t least, const DividedCurve& alone) {
    const EdgePart& part = parts_[i];
    const auto* points = givenFor(part.edge);
    std::optional<DividedPart> divided;
    if (points)
      divided = takeGiven(part, least, *points);
    else if (twins_[i])
      divided = takeFromTwin(part, dividedParts_[*twins_[i]]);
    counts_.push_back(divided && !points ? counts_[*twins_[i]] : i);
    if (!divided) divided = withVertices(part, twins_[i] ? divideCurve(i, least) : alone);
    dividedParts_.push_back(std::move(*divided));
    const EdgeSamples& samples = part.samples;
    result_.counts.push_back({wantedSegments(samples), dividedParts_.back().points.size() - 1,
                              std::max(least, fewestSegmentsOf(samples, sizes_)),
                              points != nullptr});
  }

  void joinParts() {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      DividedEdge& edge = result_.edges[parts_[i].edge];
      const DividedPart& part = dividedParts_[i];
      const std::ptrdiff_t skipped = parts_[i].isFirst ? 0 : 1;
      edge.counts.push_back(counts_[i]);
      if (twins_[i]) edge.twin = static_cast<int>(parts_[*twins_[i]].edge) + 1;
      if (skipped > 0) edge.stops.push_back(edge.points.size() - 1);
      edge.parameters.insert(edge.parameters.end(), part.parameters.begin() + skipped,
                             part.parameters.end());
      edge.points.insert(edge.points.end(), part.points.begin() + skipped, part.points.end());
    }
  }

  const ModelShape& model_;
  const CadSizes& sizes_;
  const EdgePoints& given_;
  const CollapsedEdges& asPoints_;
  const SegmentChanges& changes_;
  const MergedEdges& merged_;
  const LayerEnds& layerEnds_;
  int threads_;
  std::vector<EdgeSamples> samples_;
  std::vector<bool> isMerged_;       // by edge: it is crossed, or in a chain
  std::vector<EdgeSamples> chains_;  // in the order of merged_
  std::vector<Ends> ends_;
  std::vector<EdgePart> parts_;  // in the order of their edges
  std::vector<DividedPart> dividedParts_;
  std::vector<std::optional<std::size_t>> twins_;  // by part
  std::vector<std::size_t> counts_;                // by part: the one whose vertices it has
  std::map<std::uint32_t, double> tips_;           // by point: how long segments are at a sharp tip
  CuspLengths cusps_;
  CreaseReach creases_;  // by point
  /// How far from a point there are no vertices, as a multiple of how large it is.
  static constexpr double kTimesBlind = 2;
  std::map<std::uint32_t, double> blind_;  // how large the edges are that a point stands for
  DividedEdges result_;
};

}  // namespace

DividedEdges divideEdges(const ModelShape& model, const SampledEdges& sampled,
                         const CadSizes& sizes, int threads, const std::stop_token& stop,
                         const EdgePoints& given, const CollapsedEdges& asPoints,
                         const SegmentChanges& changes, const MergedEdges& merged,
                         const LayerEnds& ends, KnownStrips* strips) {
  return Division(model, sampled, sizes, threads, stop, given, asPoints, changes, merged, ends,
                  strips)
      .result();
}

}  // namespace af2::geometry
