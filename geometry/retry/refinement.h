// Where a mesh turned out to need shorter edges than the sizes asked for, and a new try with them.
// Not installed.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/sizes/graded_size.h"
#include "geometry/sizes/position_size.h"

namespace af2::geometry {

/// Sizes by position that are asked for, limited further around some places; and edges that are
/// collapsed to points.
class Refinement {
 public:
  /// largest  that is asked for anywhere
  Refinement(PositionSize asked, double growth, double largest)
      : asked_(std::move(asked)), growth_(growth), largest_(largest) {}

  /// For the sake of one of the faces. Sizes below a ten-thousandth of what was asked for are
  /// raised to that.
  void add(std::size_t face, const std::vector<SizeSource>& places);
  /// Takes back what was added last for a face.
  void dropLast(std::size_t face);
  /// Takes back all that was added for a face.
  void dropPlaces(std::size_t face) { places_.erase(face); }
  /// The same, and none of its edges is collapsed for its sake.
  void dropAll(std::size_t face);
  /// Whether shorter edges are asked for.
  bool has(std::size_t face) const { return places_.contains(face); }
  /// Whether anything is asked for.
  bool hasAny(std::size_t face) const { return has(face) || collapsed_.contains(face); }
  /// Asks for sizes some times as large as were added for a face.
  void soften(std::size_t face, double factor);
  /// Collapses edges to points for the sake of a face.
  void collapse(std::size_t face, const CollapsedEdges& edges) { collapsed_[face] = edges; }

  PositionSize sizes() const;
  CollapsedEdges collapsedEdges() const;

 private:
  PositionSize asked_;
  double growth_, largest_;
  std::map<std::size_t, std::vector<std::vector<SizeSource>>> places_;  ///< by face, in rounds
  std::map<std::size_t, CollapsedEdges> collapsed_;                     ///< by face
};

}  // namespace af2::geometry
