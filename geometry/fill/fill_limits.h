// What the ways to fill a face may cost, and what tells a useful mesh from a useless one.
// Not installed.
#pragma once

#include <cstddef>

namespace af2::geometry {

// --- how long a front goes on -------------------------------------------------------------------

/// Steps in a row for each edge of the front that bring next to nothing, while there are other
/// charts to try. With the last charts a front goes on to its end.
inline constexpr int kStallLimit = 4;

/// Candidates that a front may examine without bringing anything. Nearly twice what any front of
/// the public models took on its way to a whole face (each candidate counted once).
inline constexpr std::size_t kMaxCandidatesInVain = 4'000'000;

/// Times the elements that are expected. More mean that a front folds over and goes on for ever:
/// four times where only the boundary tells how many there should be, twice where all sizes do.
inline constexpr double kElementMargin = 4, kElementMarginOfKnownSizes = 2;

/// The same where a size function may want much smaller elements anywhere inside.
inline constexpr double kElementMarginOfFunctions = 1e5;

/// Elements that any face may have, and those beside each segment, in the room in which elements
/// grow from the length of the segment to the longest one.
inline constexpr double kElementsAlways = 2000, kElementsBesideSegment = 12;

/// Elements that no face may have: the limits are no numbers beyond.
inline constexpr double kMaxElements = 1e9;

/// Candidates for each element that the limit allows, times the margin above. Fronts need about
/// three; one that takes several times as many is so crammed that no end is in sight.
inline constexpr double kCandidatesPerElement = 7.5;

/// Candidates of a front whose rest is to be closed across its loops, whatever these lean against:
/// a crammed front would leave too much for that.
inline constexpr std::size_t kMaxCandidatesBeforeLoops = 300'000;

// --- what is closed without rules ---------------------------------------------------------------

// How many edges a front may have at all stands in close_front.h, which is installed.

/// Edges of a loop that is closed in the plane of its area vector. This is for patches that are
/// bent more than a few elements can follow; larger loops reach too far for one plane.
inline constexpr std::size_t kMaxLoopEdges = 24;

// --- which mesh is better -----------------------------------------------------------------------

/// Times the area of the face, or its inverse. A curved strip that is narrower than its segments
/// sag comes out with a worse area if there are vertices inside.
inline constexpr double kNearArea = 1.25;

/// Width of a strip over the length of a segment. Below, vertices inside make elements only
/// thinner.
inline constexpr double kNarrowStrip = 0.3;

/// Length of an edge across a strip over that of the segments at its ends. A strip with longer ones
/// is wider there than elsewhere, and wants vertices inside.
inline constexpr double kLongAcross = 2.2;

// --- what is wrong with a mesh, and how short edges should be there ------------------------------

/// Length of new edges over those at which a front got stuck or elements are at fault.
inline constexpr double kFinerAtFaults = 0.5;

/// The same where segments cross: what is between their curves may be far narrower than they are
/// long.
inline constexpr double kFinerAtCrossedSegments = 0.3;

/// Places, and crossings of segments, that are told. More at once would not make the next try
/// better, only slower.
inline constexpr std::size_t kMaxPlacesAtFault = 20'000, kMaxCrossedSegments = 2000;

/// Angles below this are opened where that is possible, in degrees.
inline constexpr double kSharpAngle = 5;

/// The tangent of a little more than kSharpAngle: most angles need not be found to be told apart.
inline constexpr double kSharpTangent = 0.09;

/// How many times an angle is to become what it is, within bounds in degrees. What shorter edges
/// cost grows as fast.
inline constexpr double kAngleOpening = 4, kMinOpenedAngle = 1, kMaxOpenedAngle = 10;

/// Least length of edges at an angle that is opened, over that of the element.
inline constexpr double kMinOpeningShare = 0.02;

/// Distance of places along the longest edge of such an element, over the size that they ask for:
/// sizes between two of them grow to 1.3 times that.
inline constexpr double kOpeningSpacing = 2;

/// Elements of a face for each that is poor. A few poor ones among more do not count: to mesh the
/// face again would cost more than it could bring.
inline constexpr std::size_t kElementsForOnePoor = 2000;

/// Height of an element over the width of a wedge that it lies in, for both to be as thin.
inline constexpr double kMinInWedge = 0.3, kMaxInWedge = 1.5;

/// Tangent of a corner two segments on over that one segment on. Below, its end is blunt.
inline constexpr double kBluntWedge = 0.7;

/// Share of its area that a curved or round face may lose to straight edges, and that at which
/// shorter ones aim.
inline constexpr double kMaxAreaError = 0.05, kAimedAreaError = 0.04;

/// Length of new edges over those that cut off too much, at least and at most.
inline constexpr double kMinShareForArea = 0.3, kMaxShareForArea = 0.8;

/// Edges of a stuck front that are reported. More would not tell more, only make the report long.
inline constexpr std::size_t kMaxReportedPlaces = 10;

}  // namespace af2::geometry
