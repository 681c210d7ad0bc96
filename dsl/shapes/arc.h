// Circular arcs through three points.
#pragma once

#include "dsl/shapes/crossing.h"
#include "dsl/shapes/path.h"

namespace af2::dsl::shapes {

/// The disc of the arc's circle.
DiscThrough circleOf(const Step& arc);

/// The half plane bounded by the chord that contains the arc.
HalfPlane chordOf(const Step& arc);

/// Centre and radius, rounded.
Disc roundedCircle(const DiscThrough& disc);

/// The signed area between chord and arc, positive to the right of the chord.
double areaBesideChord(const Step& arc);

/// A box that contains the arc; infinite if rounding prevents a finite one.
Box2 boxOf(const Step& arc);

/// Whether two arcs have a point in common other than the corners that they share as steps of a
/// path: s.to if tFollows, s.from if sFollows. Exact.
bool arcsMeet(const Step& s, const Step& t, bool tFollows, bool sFollows);

}  // namespace af2::dsl::shapes
