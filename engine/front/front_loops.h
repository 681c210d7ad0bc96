// Which loop of the front each corner belongs to, and colours that tell how loops may be divided.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/ids.h"

namespace af2 {

class Front;

/// The loops of a front whose rules keep loops even.
///
/// A region can be filled with quadrilaterals alone only if each of its loops has an even number of
/// edges. Along an even loop the places have the colours 0 and 1 in turn. An edge that divides the
/// loop leaves two even loops exactly if its ends have unlike colours, so one comparison decides.
/// Colours of odd loops mean nothing. Any edge may join two loops: the colours of the shorter one
/// are exchanged if they do not fit.
class FrontLoops {
 public:
  /// Numbers and colours all loops of a front. The functions below must be called from then on.
  void number(const Front& front);
  /// Of a front that is shown in part: the open chains of these places are parts of one loop, in
  /// which the places have these colours.
  void joinChains(const Front& front, std::span<const std::pair<PlaceId, bool>> colours);
  bool areNumbered() const { return !places_.empty(); }

  /// A place has joined the loop of the place before it.
  void add(PlaceId before, PlaceId added);
  /// Two places of one vertex have exchanged their predecessors, which divided a loop or joined
  /// two. Takes time in proportion to the shorter loop.
  void exchanged(const Front& front, PlaceId p, PlaceId q);
  /// Two edges of a loop have left it.
  void shorten(PlaceId place) { sizes_[at(place).loop] -= 2; }

  /// Whether the edge that leaves `base` may be replaced by a walk: no even loop becomes odd.
  ///
  /// joined  by vertex of the walk: the place that the walk joins; none for a new vertex
  bool allow(const Front& front, PlaceId base, std::span<const PlaceId> joined) const;

  /// Whether sizes are those of the loops, and colours alternate along even ones. Takes time in
  /// proportion to the front; for tests and debug builds.
  bool areSound(const Front& front) const;

  int sizeOfLoop(PlaceId place) const { return static_cast<int>(sizes_[at(place).loop]); }
  bool isInOddLoop(PlaceId place) const { return sizes_[at(place).loop] % 2 != 0; }
  bool areInOneLoop(PlaceId p, PlaceId q) const { return at(p).loop == at(q).loop; }
  bool colour(PlaceId place) const { return at(place).colour; }

 private:
  struct OfPlace {
    std::uint32_t loop = 0;
    bool colour = false;
  };

  const OfPlace& at(PlaceId place) const { return places_[place.value]; }
  OfPlace& at(PlaceId place) { return places_[place.value]; }
  void divide(const Front& front, PlaceId p, PlaceId q);
  void join(const Front& front, PlaceId p, PlaceId q);
  /// Colours a loop anew; the given place keeps its colour.
  void colourAgain(const Front& front, PlaceId place);

  std::vector<OfPlace> places_;
  std::vector<std::uint32_t> sizes_;  // by loop
};

}  // namespace af2
