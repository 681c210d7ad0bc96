#include "geometry/occ/edges/part_division.h"

#include <BRepAdaptor_Curve.hxx>
#include <algorithm>
#include <optional>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/edges/curve_division.h"
#include "geometry/occ/edges/edge_chains.h"
#include "geometry/occ/edges/given_points.h"
#include "geometry/occ/edges/layer_parts.h"
#include "geometry/occ/edges/touching_edges.h"
#include "geometry/occ/edges/twin_edges.h"
#include "geometry/occ/sizes/sizing.h"

namespace af2::geometry {

namespace {

class PartDivision {
 public:
  PartDivision(const ModelShape& model, const CadSizes& sizes, const AskedOfParts& asked,
               int threads, EdgeParts parts)
      : model_(model),
        sizes_(sizes),
        asked_(asked),
        threads_(threads),
        made_(std::move(parts)),
        twins_(twinsOf(model, made_.parts)) {}

  DividedEdges result() {
    std::vector<CurveEnds> ends;
    for (const EdgePart& part : made_.parts) ends.push_back({part.ends.first, part.ends.last});
    const std::vector<std::size_t> least = leastSegments(ends);
    const std::vector<DividedCurve> curves = divideAlone(least);
    for (std::size_t i = 0; i < made_.parts.size(); ++i) dividePart(i, least[i], curves[i]);
    joinParts();
    return std::move(made_.edges);
  }

 private:
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
    for (const Point3& point : given.points) inner.push_back(made_.addPoint(point));
    return between(part.ends, std::move(given.parameters), inner);
  }

  /// The vertices between the ends of a part that runs along an earlier one are those of that one.
  std::optional<DividedPart> takeFromTwin(const EdgePart& part, const DividedPart& twin) const {
    std::vector<std::uint32_t> inner(twin.points.begin() + 1, twin.points.end() - 1);
    std::vector<Point3> positions;
    for (const std::uint32_t p : inner) positions.push_back(made_.edges.points[p]);
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
    const EdgePart& part = made_.parts[i];
    DividedCurve curve{divideBetweenLayers(model_, part, asked_.layers, made_.cusps, made_.tips,
                                           {least, changeAt(asked_.changes, i)}, sizes_),
                       {}};
    const PointAt pointAt = curveOf(model_, part, asked_.merged);
    leaveOutBesidePoints(part.ends, least, pointAt, curve.parameters);
    for (std::size_t k = 1; k + 1 < curve.parameters.size(); ++k)
      curve.inner.push_back(pointAt(curve.parameters[k]));
    return curve;
  }

  /// By part, without those that follow other points.
  std::vector<DividedCurve> divideAlone(const std::vector<std::size_t>& least) const {
    constexpr std::size_t kAtOnce = 8;
    std::vector<DividedCurve> curves(made_.parts.size());
    forEachInRanges(made_.parts.size(), kAtOnce, threads_, [&](std::size_t i) {
      if (!twins_[i] && !pointsGivenFor(asked_.given, made_.parts[i].edge))
        curves[i] = divideCurve(i, least[i]);
    });
    return curves;
  }

  DividedPart withVertices(const EdgePart& part, const DividedCurve& curve) {
    std::vector<std::uint32_t> inner;
    for (const Point3& point : curve.inner) inner.push_back(made_.addPoint(point));
    return between(part.ends, curve.parameters, inner);
  }

  /// Beside what was taken for a point although it can be seen, segments are longer than that is
  /// large: a shorter one would look into it.
  void leaveOutBesidePoints(const Ends& ends, std::size_t least, const PointAt& pointAt,
                            std::vector<double>& parameters) const {
    for (const std::uint32_t end : {ends.first, ends.last}) {
      const auto found = made_.blind.find(end);
      if (found == made_.blind.end()) continue;
      const Point3& place = made_.edges.points[end];
      for (std::size_t k = parameters.size() - 2; k > 0 && parameters.size() > least + 1; --k)
        if (distance(pointAt(parameters[k]), place) < kTimesBlind * found->second)
          parameters.erase(parameters.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

  void dividePart(std::size_t i, std::size_t least, const DividedCurve& alone) {
    const EdgePart& part = made_.parts[i];
    const auto* points = pointsGivenFor(asked_.given, part.edge);
    std::optional<DividedPart> divided;
    if (points)
      divided = takeGiven(part, least, *points);
    else if (twins_[i])
      divided = takeFromTwin(part, dividedParts_[*twins_[i]]);
    counts_.push_back(divided && !points ? counts_[*twins_[i]] : i);
    if (!divided) divided = withVertices(part, twins_[i] ? divideCurve(i, least) : alone);
    dividedParts_.push_back(std::move(*divided));
    const EdgeSamples& samples = part.samples;
    made_.edges.counts.push_back({wantedSegments(samples), dividedParts_.back().points.size() - 1,
                                  std::max(least, fewestSegmentsOf(samples, sizes_)),
                                  points != nullptr});
  }

  void joinParts() {
    for (std::size_t i = 0; i < made_.parts.size(); ++i) {
      DividedEdge& edge = made_.edges.edges[made_.parts[i].edge];
      const DividedPart& part = dividedParts_[i];
      const std::ptrdiff_t skipped = made_.parts[i].isFirst ? 0 : 1;
      edge.counts.push_back(counts_[i]);
      if (twins_[i]) edge.twin = static_cast<int>(made_.parts[*twins_[i]].edge) + 1;
      if (skipped > 0) edge.stops.push_back(edge.points.size() - 1);
      edge.parameters.insert(edge.parameters.end(), part.parameters.begin() + skipped,
                             part.parameters.end());
      edge.points.insert(edge.points.end(), part.points.begin() + skipped, part.points.end());
    }
  }

  const ModelShape& model_;
  const CadSizes& sizes_;
  const AskedOfParts& asked_;
  int threads_;
  EdgeParts made_;
  std::vector<std::optional<std::size_t>> twins_;  // by part
  std::vector<DividedPart> dividedParts_;
  std::vector<std::size_t> counts_;  // by part: the one whose vertices it has
};

}  // namespace

DividedEdges divideParts(const ModelShape& model, const CadSizes& sizes, const AskedOfParts& asked,
                         int threads, EdgeParts parts) {
  return PartDivision(model, sizes, asked, threads, std::move(parts)).result();
}

}  // namespace af2::geometry
