// Limits of remedies: their cost, and when they stop. Costs are counted in candidates of the front,
// never in seconds, so that every run takes the same decisions. Six million candidates take about
// ten seconds.
// Not installed.
#pragma once

#include <cstddef>

namespace af2::geometry {

// --- budget of all remedies together ------------------------------------------------------------

/// The budget as a multiple of the cost of the mesh, with an upper bound of about ten seconds, and
/// a lower bound for small models.
inline constexpr double kBudgetShare = 3, kMaxBudget = 6'000'000, kMinBudget = 2'000'000;

/// Fixed cost, in candidates, of meshing a face again, besides that of its front.
inline constexpr double kCostOfFace = 1000;

/// The limit of a failed face as a multiple of its former cost, because shorter edges cost more.
inline constexpr double kBudgetOfFailed = 2;

/// Candidates that a failed face may use in any case; and the sum over all failed faces, which
/// reduces the former where more than twenty fail: hundreds of hopeless faces then take hardly
/// longer than five.
inline constexpr double kMinBudgetOfFailed = 100'000, kMinBudgetOfAllFailed = 2'000'000;

/// The same for the last tries at a face, within its edges.
inline constexpr double kMinBudgetForLastTry = 300'000;

// --- when a face is given up --------------------------------------------------------------------

/// How often shorter edges are tried on a face that keeps failing, before it is given up; only once
/// if it is at fault at more places then.
inline constexpr int kMaxFailures = 3;

/// Failures with shorter edges before short edges of the model are collapsed to points: collapsing
/// loses details.
inline constexpr int kFailuresBeforeCollapse = 1;

/// A try counts as progress if the poorness, or the number of crossing elements, falls below this
/// share of the former value.
inline constexpr double kProgress = 0.9;

/// Tries that leave as many crossing elements as before. Where faces almost touch along a curve,
/// crossings move along it for several tries before they vanish.
inline constexpr int kMaxTriesAtCrossings = 10;

/// How often the requests of a face are softened to protect its neighbours, and by which factor: up
/// to 32 in total.
inline constexpr int kMaxSoftenings = 5;
inline constexpr double kSoftening = 2;

// --- what is asked for --------------------------------------------------------------------------

/// Length of new edges over that of elements that cross; and the same after some unsuccessful
/// tries, so that the finer region extends farther.
inline constexpr double kFinerAtCrossings = 0.5, kMuchFinerAtCrossings = 0.25;
inline constexpr int kTriesBeforeMuchFiner = 3;

/// Crossings of one face that are used: more would not make the next try better, only slower.
inline constexpr std::size_t kMaxPlacesAtCrossings = 1000;

/// Least size that is requested, over the largest size of the model. It is small enough to divide a
/// hole of a thousandth of the wanted size; smaller sizes would not help.
inline constexpr double kMinSizeShare = 1e-4;

/// Size that other places request at a place, over that of the place. Below this ratio, the place
/// adds nothing new.
inline constexpr double kClearlySmaller = 1.1;

/// Places that are compared one by one before they are added to the tree of all others.
inline constexpr std::size_t kMaxUnsortedPlaces = 256;

/// Least angle of the two triangles that result from swapping a diagonal, in radians: about one
/// degree.
inline constexpr double kMinSwappedAngle = 0.02;

}  // namespace af2::geometry
