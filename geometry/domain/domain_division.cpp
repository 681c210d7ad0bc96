#include "geometry/domain/domain_division.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/base/error.h"
#include "geometry/domain/points_on_curve.h"
#include "geometry/edges/curve_division.h"

namespace af2::geometry {

namespace {

/// A curve with the sizes that are wanted at some of its parameters.
struct Samples {
  std::vector<double> parameters;
  SampledCurve curve;
};

constexpr double kMaxSamples = 1e7;  // of an edge

class Division {
 public:
  Division(const DomainModel& model, const DomainSizes& sizes, const EdgePoints& given,
           const SegmentChanges& changes, const LayerEnds& ends)
      : model_(model),
        sizes_(sizes),
        given_(given),
        changes_(changes),
        layerEnds_(ends),
        faces_(model.curves.size()) {
    for (std::size_t f = 0; f < model.faces.size(); ++f)
      for (const auto& loop : model.faces[f].loops)
        for (const CurveUse& use : loop) faces_[use.curve].push_back(f);
  }

  DividedEdges divide(double growth) {
    std::vector<SampledCurve> curves;
    std::vector<CurveEnds> ends;
    std::vector<std::vector<double>> parameters;
    for (std::size_t c = 0; c < model_.curves.size(); ++c) {
      Samples samples = isFixed(c) ? unlimited() : sample(c);
      ends.push_back({model_.curves[c].first, model_.curves[c].last});
      samples.curve.ends = ends.back();
      parameters.push_back(std::move(samples.parameters));
      curves.push_back(std::move(samples.curve));
    }
    gradeTogether(curves, model_.corners.size(), growth);
    const std::vector<std::size_t> least = leastSegments(ends);
    result_.points = model_.corners;
    for (std::size_t c = 0; c < curves.size(); ++c)
      result_.edges.push_back(isFixed(c) ? fixed(c, least[c])
                                         : divided(c, curves[c], parameters[c], least[c]));
    return std::move(result_);
  }

 private:
  const EdgePoints::mapped_type* givenFor(std::size_t c) const {
    const auto found = given_.find(model_.curves[c].id);
    return found == given_.end() ? nullptr : &found->second;
  }
  bool isFixed(std::size_t c) const { return model_.curves[c].isKept || givenFor(c); }

  /// k       the place is between this knot and the next one, or at it
  /// within  its share of the way to the next one
  double wantedAt(std::size_t c, const Point3& p, std::size_t k, double within) const {
    const auto own = sizes_.onEdge.find(model_.curves[c].id);
    double wanted = own == sizes_.onEdge.end() ? onFacesBeside(c) : own->second;
    wanted = std::min(wanted, model_.curves[c].largest);
    wanted = std::min(wanted, limitAt(c, p, k, within));
    wanted = sizes_.byPosition.at(p, wanted);
    return sizes_.nearLoosePoints ? std::min(wanted, sizes_.nearLoosePoints->at(p)) : wanted;
  }

  double limitAt(std::size_t c, const Point3& p, std::size_t k, double within) const {
    const auto& [ofFaces, atKnots] = sizes_.byCurvature;
    if (c < atKnots.size() && !atKnots[c].empty()) {
      const std::vector<double>& at = atKnots[c];
      return within > 0 ? at[k] + within * (at[k + 1] - at[k]) : at[k];
    }
    double limit = std::numeric_limits<double>::infinity();
    for (const std::size_t f : faces_[c])
      if (ofFaces[f]) limit = std::min(limit, ofFaces[f]->sizeAt({p, {}, 0, 0}));
    return limit;
  }

  double onFacesBeside(std::size_t c) const {
    double wanted = std::numeric_limits<double>::infinity();
    for (const std::size_t f : faces_[c]) wanted = std::min(wanted, sizes_.onFace[f]);
    return wanted;
  }

  /// Of a curve whose division is fixed, so that it has no say in that of others.
  static Samples unlimited() {
    constexpr double kNone = DomainCurve::kNoLimit, kFar = 1e300;
    return {{}, {{}, {0, kFar}, {kNone, kNone}}};
  }

  /// At the knots, and between them where these are far apart.
  Samples sample(std::size_t c) const {
    constexpr std::size_t kDenser = 8;
    constexpr int kMaxRounds = 4;
    const bool isVaried = sizes_.byPosition.isVaried() || sizes_.nearLoosePoints || !model_.isFlat;
    double perSize = isVaried ? kDenser : 1;
    Samples samples = sampled(c, perSize);
    for (int round = 0; isVaried && !isFine(samples.curve) && round < kMaxRounds; ++round) {
      if (static_cast<double>(kDenser * samples.parameters.size()) > kMaxSamples) break;
      perSize *= static_cast<double>(kDenser);
      samples = sampled(c, perSize);
    }
    return samples;
  }

  /// Whether no cell is long against the size at its end.
  static bool isFine(const SampledCurve& curve) {
    constexpr double kMaxOfSize = 0.25;
    for (std::size_t i = 1; i < curve.sizes.size(); ++i)
      if (curve.arcLength[i] - curve.arcLength[i - 1] > kMaxOfSize * curve.sizes[i]) return false;
    return true;
  }

  Samples sampled(std::size_t c, double perSize) const {
    const DomainCurve& curve = model_.curves[c];
    const Knots knots = knotsOf(curve);
    Samples samples;
    double fromSize = wantedAt(c, knots.points[0], 0, 0);
    add(curve.knots[0], 0, fromSize, samples);
    for (std::size_t k = 1; k < curve.knots.size(); ++k) {
      const double start = knots.arcLength[k - 1], length = knots.arcLength[k] - start;
      const double toSize = limitedByTurn(knots, k, wantedAt(c, knots.points[k], k, 0));
      const std::size_t cells = cellsFor(perSize * length / std::min(fromSize, toSize), samples);
      for (std::size_t i = 1; i <= cells; ++i) {
        const double within = static_cast<double>(i) / static_cast<double>(cells);
        const double t = curve.knots[k - 1] + within * (curve.knots[k] - curve.knots[k - 1]);
        add(i == cells ? curve.knots[k] : t, start + within * length,
            i == cells ? toSize : wantedAt(c, curve.pointAt(t), k - 1, within), samples);
      }
      fromSize = toSize;
    }
    return samples;
  }

  static void add(double parameter, double arcLength, double size, Samples& samples) {
    samples.parameters.push_back(parameter);
    samples.curve.arcLength.push_back(arcLength);
    samples.curve.sizes.push_back(size);
  }

  std::size_t cellsFor(double wanted, const Samples& samples) const {
    if (!(wanted + static_cast<double>(samples.parameters.size()) < kMaxSamples))
      throw InputError(model_.name +
                       ": an edge would need more than a million segments; ask for a larger size");
    return static_cast<std::size_t>(std::max(1.0, std::ceil(wanted)));
  }

  struct Knots {
    std::vector<Point3> points;
    std::vector<double> arcLength;
  };
  static Knots knotsOf(const DomainCurve& curve) {
    Knots knots{{curve.pointAt(curve.knots[0])}, {0}};
    for (std::size_t k = 1; k < curve.knots.size(); ++k) {
      knots.points.push_back(curve.pointAt(curve.knots[k]));
      knots.arcLength.push_back(knots.arcLength.back() +
                                distance(knots.points[k - 1], knots.points[k]));
    }
    return knots;
  }

  /// At a knot the curve may turn. What turns back within the least size at turns is noise.
  double limitedByTurn(const Knots& knots, std::size_t k, double size) const {
    const auto& [points, along] = knots;
    if (k + 1 >= points.size()) return size;
    const double reach = sizes_.byPosition.leastAtTurns(model_.leastAtTurns);
    const auto at = along.begin() + static_cast<std::ptrdiff_t>(k);
    const auto after = std::lower_bound(at + 1, along.end() - 1, *at + reach);
    const auto before = std::upper_bound(along.begin() + 1, at, *at - reach) - 1;
    const Point3 &p = points[static_cast<std::size_t>(before - along.begin())], &q = points[k],
                 &r = points[static_cast<std::size_t>(after - along.begin())];
    const double turn = distance(unit(q - p), unit(r - q));
    if (turn == 0) return size;
    const double radius = (distance(p, q) + distance(q, r)) / 2 / turn;
    return sizes_.byPosition.bounded(
        std::min(size, sizes_.byPosition.turnLimit(radius, model_.leastAtTurns)));
  }

  /// The number that the turn of a curve alone needs.
  double segmentsByTurn(std::size_t c) const {
    std::vector<Point3> points;
    for (const double knot : model_.curves[c].knots)
      points.push_back(model_.curves[c].pointAt(knot));
    return turnAlong(points) / sizes_.byPosition.limitOfTurn();
  }

  DividedEdge divided(std::size_t c, const SampledCurve& sizes,
                      const std::vector<double>& parameters, std::size_t least) {
    const DomainCurve& curve = model_.curves[c];
    const std::vector<double> count = segmentsAlong(sizes.arcLength, sizes.sizes);
    const LayersAtEnds at = layersAtEnds(c, sizes.arcLength);
    const std::size_t fixed = at.first.size() + at.last.size();
    const double from = at.first.empty() ? 0 : at.first.back().between(count);
    const double to = at.last.empty() ? count.back() : at.last.front().between(count);
    least = least > fixed ? least - fixed : 1;
    const double rest = to - from;
    DividedEdge edge = begun(c);
    double byTurn = rest / count.back() * segmentsByTurn(c);
    const bool hasChord = sizes_.byPosition.hasChord();
    if (hasChord && byTurn > 0.01) byTurn = rest;  // no segment is too long
    const bool isAsked = sizes_.byPosition.turnOfSegment() > 0 || hasChord;
    std::size_t segments = std::max(least, wholeSegments(rest, isAsked ? byTurn : 0));
    const std::size_t fewest = std::min(segments, std::max(least, fewestSegments(rest, byTurn)));
    const int change = changeAt(changes_, c);
    if (change > 0) segments += static_cast<std::size_t>(change);
    if (change < 0 && segments > fewest) --segments;
    const auto fixedCount = static_cast<double>(fixed);
    result_.counts.push_back({rest + fixedCount, segments + fixed, fewest + fixed, false});
    std::vector<CurvePlace> places = at.first;
    const std::vector<CurvePlace> between = equalShares(count, from, to, segments);
    places.insert(places.end(), between.begin(), between.end());
    places.insert(places.end(), at.last.begin(), at.last.end());
    for (const CurvePlace& place : places) {
      const double t = place.between(parameters);
      add(t, curve.pointAt(t), edge);
    }
    return ended(c, std::move(edge));
  }

  /// The vertices of layers that end on a curve, from its start and up to its end.
  struct LayersAtEnds {
    std::vector<CurvePlace> first, last;
  };
  LayersAtEnds layersAtEnds(std::size_t c, const std::vector<double>& arcLength) const {
    LayersAtEnds at;
    const int edge = static_cast<int>(c) + 1;
    if (const auto start = layerEnds_.find({edge, true}); start != layerEnds_.end())
      for (const double length : start->second) at.first.push_back(placeAt(arcLength, length));
    if (const auto end = layerEnds_.find({edge, false}); end != layerEnds_.end())
      for (const double length : end->second)
        at.last.insert(at.last.begin(), placeAt(arcLength, arcLength.back() - length));
    return at;
  }

  DividedEdge fixed(std::size_t c, std::size_t least) {
    const DomainCurve& curve = model_.curves[c];
    DividedEdge edge = begun(c);
    if (const auto* points = givenFor(c)) {
      const PlacedPoints placed = placeOnCurve(curve, *points, least);
      for (std::size_t i = 0; i < placed.points.size(); ++i)
        add(placed.parameters[i + 1], placed.points[i], edge);
    } else {
      for (std::size_t i = 1; i < least; ++i) {
        const double t = curve.knots.front() + static_cast<double>(i) / static_cast<double>(least) *
                                                   (curve.knots.back() - curve.knots.front());
        add(t, curve.pointAt(t), edge);
      }
    }
    const std::size_t segments = edge.points.size();
    result_.counts.push_back({static_cast<double>(segments), segments, segments, true});
    return ended(c, std::move(edge));
  }

  DividedEdge begun(std::size_t c) const {
    const DomainCurve& curve = model_.curves[c];
    DividedEdge edge;
    edge.parameters.push_back(curve.knots.front());
    edge.points.push_back(static_cast<std::uint32_t>(curve.first));
    edge.counts.push_back(c);
    return edge;
  }
  void add(double parameter, const Point3& point, DividedEdge& edge) {
    edge.parameters.push_back(parameter);
    edge.points.push_back(static_cast<std::uint32_t>(result_.points.size()));
    result_.points.push_back(point);
  }
  DividedEdge ended(std::size_t c, DividedEdge edge) const {
    const DomainCurve& curve = model_.curves[c];
    edge.parameters.push_back(curve.knots.back());
    edge.points.push_back(static_cast<std::uint32_t>(curve.last));
    return edge;
  }

  const DomainModel& model_;
  const DomainSizes& sizes_;
  const EdgePoints& given_;
  const SegmentChanges& changes_;
  const LayerEnds& layerEnds_;
  std::vector<std::vector<std::size_t>> faces_;  ///< by curve: those beside it
  DividedEdges result_;
};

}  // namespace

DividedEdges divideCurves(const DomainModel& model, const DomainSizes& sizes, double growth,
                          const EdgePoints& given, const SegmentChanges& changes,
                          const LayerEnds& ends) {
  return Division(model, sizes, given, changes, ends).divide(growth);
}

}  // namespace af2::geometry
