// What remedies may cost, and when they are given up. Costs are counted in candidates of the front,
// never in seconds, so that every run takes the same decisions. Six million candidates take about
// ten seconds.
// Not installed.
#pragma once

#include <cstddef>

namespace af2::geometry {

// --- budget of all remedies together ------------------------------------------------------------

/// Times what the mesh itself has cost; but no more than about ten seconds; and enough for small
/// models.
inline constexpr double kBudgetShare = 3, kMaxBudget = 6'000'000, kMinBudget = 2'000'000;

/// Candidates that it is worth to mesh a face again, besides those of its front.
inline constexpr double kCostOfFace = 1000;

/// Times what a face that failed took before: shorter edges are dearer.
inline constexpr double kBudgetOfFailed = 2;

/// Candidates that a face which failed may take in any case, or its part of those for all of them
/// where more than twenty fail: hundreds of hopeless faces take hardly longer than five.
inline constexpr double kMinBudgetOfFailed = 100'000, kMinBudgetOfAllFailed = 2'000'000;

/// The same for a face that is tried ignoring normals.
inline constexpr double kMinBudgetIgnoringNormals = 300'000;

// --- when a face is given up --------------------------------------------------------------------

/// Times that shorter edges are tried on a face that fails, so that it is given up soon.
inline constexpr int kMaxFailures = 3;

/// Failures before short edges of the model are collapsed to points, which leaves details out.
inline constexpr int kFailuresBeforeCollapse = 2;

/// Share of the poorness, or of the elements that cross, that must be left for a try to count as
/// progress.
inline constexpr double kProgress = 0.9;

/// Tries that left as many elements across each other. Where faces almost touch along a curve,
/// crossings move along it for a while before they end.
inline constexpr int kMaxTriesAtCrossings = 10;

/// Times that what one face asked for is softened for the sake of its neighbors, and by how much:
/// up to 32 times in all.
inline constexpr int kMaxSoftenings = 5;
inline constexpr double kSoftening = 2;

// --- what is asked for --------------------------------------------------------------------------

/// Length of new edges over that of elements that cross; after some tries in vain, so that the
/// finer part reaches farther.
inline constexpr double kFinerAtCrossings = 0.5, kMuchFinerAtCrossings = 0.25;
inline constexpr int kTriesBeforeMuchFiner = 3;

/// Crossings of one face that are looked at: more would not make the next try better, only slower.
inline constexpr std::size_t kMaxPlacesAtCrossings = 1000;

/// Least size that is asked for, over the largest one of the model. A hole of a thousandth of the
/// wanted size can be divided by this; more would help nobody.
inline constexpr double kMinSizeShare = 1e-4;

/// Size around a place over that which others ask for there. Above, the place asks for nothing new.
inline constexpr double kClearlySmaller = 1.1;

/// Places that are compared one by one before they join the tree of all others.
inline constexpr std::size_t kMaxUnsortedPlaces = 256;

/// Angle of the two triangles beyond a diagonal that is swapped, in radians: about one degree.
inline constexpr double kMinSwappedAngle = 0.02;

}  // namespace af2::geometry
