// The chords of circles that stay within a distance.
#include "geometry/sizes/chord.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/error.h"
#include "geometry/sizes/sizes.h"

namespace af2::geometry {
namespace {

TEST(LongestChord, HasItsMiddleAtTheHeight) {
  const double chord = longestChord(5, 0.1);
  EXPECT_NEAR(5 - std::sqrt(25 - chord * chord / 4), 0.1, 1e-12);
}

TEST(LongestChord, IsNotLimitedByHeightsAboveTheRadius) {
  EXPECT_TRUE(std::isinf(longestChord(0.1, 0.1)));
  EXPECT_TRUE(std::isinf(longestChord(1e300 * 1e10, 0.1)));
}

TEST(ChordOnFace, TakesTheBoundOfTheFaceFirst) {
  Sizes sizes;
  sizes.size = 2;
  EXPECT_TRUE(std::isinf(chordOnFace(sizes, 1)));
  sizes.chords.everywhere = {0.05, true};
  sizes.chords.faces[2] = {0.3, false};
  EXPECT_DOUBLE_EQ(chordOnFace(sizes, 1), 0.1);
  EXPECT_DOUBLE_EQ(chordOnFace(sizes, 2), 0.3);
}

TEST(CheckChords, RefusesWhatIsNotPositive) {
  ChordBounds chords;
  chords.faces[3] = {-1, false};
  EXPECT_THROW(checkChords(chords), InputError);
}

}  // namespace
}  // namespace af2::geometry
