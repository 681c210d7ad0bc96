#include "geometry/occ/edges/cusps.h"

#include <BRepAdaptor_Curve.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/occ/base/foot_on_curve.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/tip_fans.h"

namespace af2::geometry {

namespace {

/// Tangents of the angle that elements there are to have, if edges are long enough for that, and of
/// that below which they are of no use.
constexpr double kOpen = 0.018, kMinOpen = 0.0093;
constexpr double kMaxOfSize = 2, kMaxOfEdge = 0.4;

/// An edge on the way from one of its ends.
class Way {
 public:
  Way(const ModelShape& model, EdgeEnd end, const EdgeSamples& samples)
      : curve_(model.edge(static_cast<int>(end.edge) + 1)), end_(end), samples_(samples) {}

  Point3 at(double length) const { return toPoint(curve_.Value(parameter(length))); }

  /// From a place to that of the way which is about as far from the end.
  double distanceTo(const Point3& place, double length) const {
    constexpr int kSteps = 4;
    const double foot =
        footOnCurve(curve_, place, parameter(length), samples_.pieces.front().parameters.front(),
                    samples_.pieces.back().parameters.back(), kSteps);
    return distance(place, toPoint(curve_.Value(foot)));
  }

 private:
  double parameter(double length) const {
    return parameterAt(samples_, end_.isStart ? length : samples_.length - length);
  }

  BRepAdaptor_Curve curve_;
  EdgeEnd end_;
  const EdgeSamples& samples_;
};

class CuspFinder {
 public:
  CuspFinder(const ModelShape& model, const std::vector<Ends>& ends,
             const std::vector<EdgeSamples>& samples)
      : model_(model), ends_(ends), samples_(samples) {}

  CuspLengths find() {
    for (int face = 1; face <= model_.faces.Extent(); ++face) lookAt(face);
    return std::move(lengths_);
  }

 private:
  void lookAt(int face) {
    const auto& edges = model_.edgesOfFaces[static_cast<std::size_t>(face) - 1];
    for (const auto& [point, found] : endsByPoint(edges, ends_, samples_))
      for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t k = i + 1; k < found.size(); ++k)
          if (found[i] != found[k] && areAlike(found[i], found[k])) compare(found[i], found[k]);
  }

  bool areAlike(EdgeEnd one, EdgeEnd other) const {
    constexpr double kMinCosine = 0.9;  // samples are fine
    return dot(directionFrom(one, samples_), directionFrom(other, samples_)) > kMinCosine;
  }

  void compare(EdgeEnd one, EdgeEnd other) {
    constexpr double kNear = 1e-3;
    constexpr int kSteps = 20;
    const EdgeSamples &first = samples_[one.edge], &second = samples_[other.edge];
    const double most = std::min(kMaxOfSize * std::min(first.wanted, second.wanted),
                                 kMaxOfEdge * std::min(first.length, second.length));
    const Way a(model_, one, first), b(model_, other, second);
    const auto tangentAt = [&](double length) {
      return b.distanceTo(a.at(length), length) / length;
    };
    double near = kNear * most, far = most;
    const double open = std::min(kOpen, tangentAt(most));
    const auto isOpen = [&](double length) { return tangentAt(length) >= open; };
    if (open < kMinOpen || isOpen(near)) return;
    for (int step = 0; step < kSteps; ++step) {
      const double middle = std::sqrt(near * far);
      (isOpen(middle) ? far : near) = middle;
    }
    for (const EdgeEnd end : {one, other})
      lengths_[end] = std::max(lengths_[end], far);  // 0 if it is new
  }

  const ModelShape& model_;
  const std::vector<Ends>& ends_;
  const std::vector<EdgeSamples>& samples_;
  CuspLengths lengths_;
};

}  // namespace

CuspLengths cuspsOf(const ModelShape& model, const std::vector<Ends>& ends,
                    const std::vector<EdgeSamples>& samples) {
  return CuspFinder(model, ends, samples).find();
}

std::vector<double> divideFromCusps(const ModelShape& model, const EdgePart& part,
                                    const CuspLengths& cusps,
                                    const std::map<std::uint32_t, double>& tips,
                                    AskedSegments asked, const CadSizes& sizes) {
  std::vector<double> parameters = divideFromTips(part, tips, asked, sizes);
  const auto start = part.isFirst ? cusps.find({part.edge, true}) : cusps.end();
  const auto end = part.isLast ? cusps.find({part.edge, false}) : cusps.end();
  if (start == cusps.end() && end == cusps.end()) return parameters;
  const BRepAdaptor_Curve curve(model.edge(static_cast<int>(part.edge) + 1));
  const auto lengthOf = [&](std::size_t segment) {
    return curve.Value(parameters[segment]).Distance(curve.Value(parameters[segment + 1]));
  };
  std::map<std::uint32_t, double> longer = tips;
  if (start != cusps.end() && lengthOf(0) < start->second) longer[part.ends.first] = start->second;
  if (end != cusps.end() && lengthOf(parameters.size() - 2) < end->second)
    longer[part.ends.last] = end->second;
  return longer == tips ? parameters : divideFromTips(part, longer, asked, sizes);
}

}  // namespace af2::geometry
