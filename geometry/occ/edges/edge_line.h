// Finds the nearest place of an edge, starting from its samples.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/base/box_tree.h"
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

/// Finds the nearest place of an edge, first among the chords of its samples. Of one thread.
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
    const auto look = [&](const Chord& chord) {
      const Point3 along = chord.to - chord.from;
      const double square = dot(along, along);
      const double t =
          square > 0 ? std::clamp(dot(place - chord.from, along) / square, 0.0, 1.0) : 0;
      if (distance(place, chord.from + t * along) > reach + kSag * std::sqrt(square)) return;
      const Foot foot = refined(place, chord.low, chord.high, t);
      if (foot.distance <= reach && (!best || foot.distance < best->distance)) best = foot;
    };
    if (++asked_ < kQueriesWithoutTree) {
      forEachChord(look);
      return best;
    }
    if (!tree_) makeTree();
    const Point3 around{reach, reach, reach};
    std::vector<std::uint32_t> near;
    tree_->forEachIn({place - around, place + around}, [&](std::uint32_t i) { near.push_back(i); });
    std::ranges::sort(near);  // as without the tree: of equally near places the first one
    for (const std::uint32_t i : near) look(chords_[i]);
    return best;
  }

 private:
  static constexpr int kQueriesWithoutTree = 16;

  struct Chord {
    Point3 from, to;
    double low, high;  ///< their parameters
  };

  template <class Visit>
  void forEachChord(Visit&& visit) const {
    for (const EdgePiece& piece : samples_.pieces)
      for (std::size_t i = 1; i < piece.positions.size(); ++i)
        visit(Chord{piece.positions[i - 1], piece.positions[i], piece.parameters[i - 1],
                    piece.parameters[i]});
  }

  void makeTree() const {
    std::vector<Box3> boxes;
    forEachChord([&](const Chord& chord) {
      Box3 box;
      box.add(chord.from);
      box.add(chord.to);
      const double sag = kSag * distance(chord.from, chord.to);
      const Point3 around{sag, sag, sag};
      boxes.push_back({box.low - around, box.high + around});
      chords_.push_back(chord);
    });
    tree_.emplace(boxes);
  }

  Foot refined(const Point3& place, double low, double high, double t) const {
    constexpr int kSteps = 6;
    const double parameter = footOnCurve(curve_, place, low + t * (high - low), low, high, kSteps);
    const Point3 position = toPoint(curve_.Value(parameter));
    return {parameter, distance(place, position), position};
  }

  BRepAdaptor_Curve curve_;
  const EdgeSamples& samples_;
  // Made when many places are asked for:
  mutable int asked_ = 0;
  mutable std::vector<Chord> chords_;
  mutable std::optional<BoxTree> tree_;
};

}  // namespace af2::geometry
