// The requests of remedies for shorter edges than the sizes of the user.
// Not installed.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/sizes/graded_size.h"
#include "geometry/sizes/position_size.h"

namespace af2::geometry {

/// Sizes by position, and less near some places.
PositionSize refinedSizes(PositionSize asked, std::vector<SizeSource> places, double growth,
                          double largest);

/// The sizes of the user and of the places of a refinement.
struct RequestedSizes {
  /// Those that request clearly smaller sizes than the others do there; the smallest first.
  std::vector<SizeSource> places;
  PositionSize sizes;
};

/// The sizes by position of the user, with smaller limits around some places; and edges that are
/// collapsed to points.
class Refinement {
 public:
  /// largest  that is asked for anywhere
  Refinement(PositionSize asked, double growth, double largest)
      : asked_(std::move(asked)), growth_(growth), largest_(largest) {}

  /// Adds places for one of the faces. Sizes below a ten-thousandth of the largest requested size
  /// are raised to that.
  void add(std::size_t face, const std::vector<SizeSource>& places);
  /// Removes the last addition for a face.
  void dropLast(std::size_t face);
  /// Removes all places that were added for a face.
  void dropPlaces(std::size_t face) { places_.erase(face); }
  /// The same, and also removes its collapsed edges.
  void dropAll(std::size_t face);
  /// Whether shorter edges are requested.
  bool has(std::size_t face) const { return places_.contains(face); }
  /// Whether the same is requested for a face as in another one.
  bool asksAlike(const Refinement& other, std::size_t face) const;
  /// Whether anything is requested.
  bool hasAny(std::size_t face) const { return has(face) || collapsed_.contains(face); }
  /// Multiplies the sizes that were added for a face by a factor.
  void soften(std::size_t face, double factor);
  /// Collapses edges to points for a face.
  void collapse(std::size_t face, const CollapsedEdges& edges) { collapsed_[face] = edges; }

  RequestedSizes requested() const;
  PositionSize sizes() const { return requested().sizes; }
  CollapsedEdges collapsedEdges() const;

 private:
  PositionSize asked_;
  double growth_, largest_;
  std::map<std::size_t, std::vector<std::vector<SizeSource>>> places_;  ///< by face, in rounds
  std::map<std::size_t, CollapsedEdges> collapsed_;                     ///< by face
};

}  // namespace af2::geometry
