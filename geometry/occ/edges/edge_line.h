// Finds the nearest place of an edge, starting from its samples.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/occ/base/foot_on_curve.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A place of an edge.
struct Foot {
  double parameter = 0, distance = 0;
  Point3 position;
};

/// Finds the nearest place of an edge, first among the chords of its samples.
class EdgeLine {
 public:
  /// Samples are on the curve; the distance of the chords between them from the curve is at most
  /// this share of the chord's length.
  static constexpr double kSag = 0.25;

  EdgeLine(const ModelShape& model, std::size_t edge, const EdgeSamples& samples)
      : curve_(model.edge(static_cast<int>(edge) + 1)), samples_(samples) {}

  /// Nothing if the edge is not within reach.
  std::optional<Foot> footOf(const Point3& place, double reach) const {
    std::optional<Foot> best;
    for (const EdgePiece& piece : samples_.pieces)
      for (std::size_t i = 1; i < piece.positions.size(); ++i) {
        const Point3 &from = piece.positions[i - 1], along = piece.positions[i] - from;
        const double square = dot(along, along);
        const double t = square > 0 ? std::clamp(dot(place - from, along) / square, 0.0, 1.0) : 0;
        const double chord = std::sqrt(square);
        if (distance(place, from + t * along) > reach + kSag * chord) continue;
        const Foot foot = refined(place, piece.parameters[i - 1], piece.parameters[i], t);
        if (foot.distance <= reach && (!best || foot.distance < best->distance)) best = foot;
      }
    return best;
  }

 private:
  Foot refined(const Point3& place, double low, double high, double t) const {
    constexpr int kSteps = 6;
    const double parameter = footOnCurve(curve_, place, low + t * (high - low), low, high, kSteps);
    const Point3 position = toPoint(curve_.Value(parameter));
    return {parameter, distance(place, position), position};
  }

  BRepAdaptor_Curve curve_;
  const EdgeSamples& samples_;
};

}  // namespace af2::geometry
