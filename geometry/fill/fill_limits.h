// Limits for filling a face: the cost of each way, and what makes a mesh useful or useless.
// Not installed.
#pragma once

#include <cstddef>

namespace af2::geometry {

// --- how long a front goes on -------------------------------------------------------------------

/// Consecutive steps without notable progress, for each edge of the front, after which other charts
/// are tried. With the last charts a front runs to its end; only where other charts or an earlier
/// try have failed, it is given up after so many, or once every rule has had its turn at every
/// edge.
inline constexpr int kStallLimit = 4, kLastStallLimit = 12;

/// Candidates that a front may examine without progress. This is nearly twice the largest number
/// that any front of the public models needed to complete a face (each candidate counted once).
inline constexpr std::size_t kStallCandidates = 4'000'000;

/// The allowed multiple of the expected elements. A front that makes more overlaps itself and would
/// never end. The multiple is four where only the boundary indicates how many elements there should
/// be, and two where all sizes are known.
inline constexpr double kElementMargin = 4, kElementMarginOfKnownSizes = 2;

/// Elements that any face may have, and those next to each segment, where elements grow from the
/// length of the segment to the longest one.
inline constexpr double kElementsAlways = 2000, kElementsBesideSegment = 12;

/// Upper bound of all limits of elements. Without it, they could exceed the range of integers.
inline constexpr double kMaxElements = 1e9;

/// Candidates for each element that the limit allows, to be multiplied by the margin above. Fronts
/// need about three; a front that takes several times as many is so crowded that it will not end.
inline constexpr double kCandidatesPerElement = 7.5;

/// Candidates of a front whose rest is then closed by loops with any normals: a crowded front would
/// leave too much for that.
inline constexpr std::size_t kMaxCandidatesBeforeLoops = 300'000;

// --- what is closed without rules ---------------------------------------------------------------

// The maximum number of edges of a front is in close_front.h, which is installed.

/// Edges of a loop that is closed in the plane perpendicular to its area vector. This is for
/// patches that are curved more than a few elements can follow; larger loops do not fit one plane.
inline constexpr std::size_t kMaxLoopEdges = 24;

// --- which mesh is better -----------------------------------------------------------------------

/// Largest ratio of the area of the elements to that of the face, or its inverse. A curved strip
/// that is narrower than the sag of its segments gets a worse area with vertices inside.
inline constexpr double kNearArea = 1.25;

/// Width of a strip over the length of a segment. Below this, vertices inside only make elements
/// thinner.
inline constexpr double kNarrowStrip = 0.3;

/// The same for curved strips. In wider ones, rules find a way.
inline constexpr double kVeryNarrowStrip = 0.03;

/// Length of an edge across a strip over that of the segments at its ends. A strip with longer
/// edges is wider there than elsewhere, and needs vertices inside.
inline constexpr double kLongAcross = 2.2;

// --- what is wrong with a mesh, and how short edges should be there ------------------------------

/// Length of new edges over those at which a front got stuck or elements are at fault.
inline constexpr double kFinerAtFaults = 0.5;

/// The same where segments cross: the strip between their curves may be far narrower than the
/// segments are long.
inline constexpr double kFinerAtCrossedSegments = 0.3;

/// Maximum number of places, and of crossings of segments, that are recorded. More would not make
/// the next try better, only slower.
inline constexpr std::size_t kMaxPlacesAtFault = 20'000, kMaxCrossedSegments = 2000;

/// Angles below this are opened where that is possible, in degrees.
inline constexpr double kSharpAngle = 5;

/// The tangent of slightly more than kSharpAngle, a quick test: angles above it need not be
/// computed.
inline constexpr double kSharpTangent = 0.09;

/// The factor by which a sharp angle is to be opened, and the bounds of the result in degrees. The
/// cost of the shorter edges grows by the same factor.
inline constexpr double kAngleOpening = 4, kMinOpenedAngle = 1, kMaxOpenedAngle = 10;

/// Least length of edges at an angle that is opened, over that of the element's edge.
inline constexpr double kMinOpeningShare = 0.02;

/// Distance between places along the longest edge of such an element, over the size that they
/// request: between two of them, sizes grow to 1.3 times that.
inline constexpr double kOpeningSpacing = 2;

/// Elements of a face for each poor one. If poor elements are rarer, they do not count: meshing the
/// face again would cost more than it could gain.
inline constexpr std::size_t kElementsForOnePoor = 2000;

/// Range of the height of an element over the width of the wedge that contains it, in which both
/// are equally thin.
inline constexpr double kMinInWedge = 0.3, kMaxInWedge = 1.5;

/// Tangent of the angle of a corner measured two segments away, over that one segment away. Below
/// this, the end of the wedge is blunt.
inline constexpr double kBluntWedge = 0.7;

/// Share of its area that a curved or round face may lose to straight edges, and the share at which
/// shorter edges aim.
inline constexpr double kMaxAreaError = 0.05, kAimedAreaError = 0.04;

/// Least and greatest length of new edges, over that of the edges that cut off too much.
inline constexpr double kMinShareForArea = 0.3, kMaxShareForArea = 0.8;

/// Edges of a stuck front that are reported. More would only make the report longer.
inline constexpr std::size_t kMaxReportedPlaces = 10;

}  // namespace af2::geometry
