#include "geometry/edges/even_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "engine/base/stopwatch.h"

namespace af2::geometry {
namespace {

SegmentCount wanting(double wanted, std::size_t least = 1) {
  const auto nearest = static_cast<std::size_t>(std::max(1.0, std::round(wanted)));
  return {wanted, std::max(least, nearest), least, false};
}
SegmentCount given(std::size_t segments) {
  return {static_cast<double>(segments), segments, segments, true};
}

/// After the changes.
bool isOdd(const CountedLoop& loop, const std::vector<SegmentCount>& counts,
           const SegmentChanges& changes) {
  bool isOdd = loop.hasOddRest;
  for (const std::size_t i : loop.counts)
    if ((static_cast<int>(counts[i].segments) + changes[i]) % 2 != 0) isOdd = !isOdd;
  return isOdd;
}

/// The result, after checks of everything that holds for all results.
EvenLoops solved(const std::vector<SegmentCount>& counts, const std::vector<CountedLoop>& loops,
                 const std::vector<FacingCounts>& facing = {}) {
  const EvenLoops result = makeLoopsEven(counts, loops, facing);
  EXPECT_EQ(result.changes.size(), counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_LE(std::abs(result.changes[i]), counts[i].isFixed ? 0 : 1) << i;
    EXPECT_TRUE(result.changes[i] >= 0 || counts[i].segments > counts[i].least) << i;
  }
  std::vector<std::size_t> odd;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (isOdd(loops[i], counts, result.changes)) odd.push_back(i);
  EXPECT_EQ(result.odd, odd);
  return result;
}

/// The loops of a cube: edges 0-3 below, 4-7 above, 8-11 upright.
std::vector<CountedLoop> cube() {
  std::vector<CountedLoop> loops{{{0, 1, 2, 3}}, {{4, 5, 6, 7}}};
  for (std::size_t i = 0; i < 4; ++i) loops.push_back({{i, 4 + i, 8 + i, 8 + (i + 1) % 4}});
  return loops;
}

TEST(EvenLoops, LeavesEvenLoopsAlone) {
  const EvenLoops result = solved(std::vector<SegmentCount>(12, wanting(3)), cube());
  EXPECT_EQ(result.changes, SegmentChanges(12, 0));
}

TEST(EvenLoops, ChangesTheEdgeBetweenTwoOddLoopsOfAShell) {
  std::vector<SegmentCount> counts(12, wanting(4));
  counts[0] = wanting(4.6);
  const EvenLoops result = solved(counts, cube());
  SegmentChanges expected(12, 0);
  expected[0] = -1;
  EXPECT_EQ(result.changes, expected);
}

TEST(EvenLoops, JoinsOddLoopsThatAreFarApart) {
  std::vector<SegmentCount> counts(12, wanting(4));
  counts[0] = given(3);
  counts[4] = given(3);  // so that 0 and 1 are odd, and 2 is even
  const EvenLoops result = solved(counts, cube());
  EXPECT_TRUE(result.odd.empty());
  EXPECT_EQ(std::ranges::count(result.changes, 0), 10) << "by way of one side";
}

TEST(EvenLoops, ChangesALongEdgeRatherThanAShortOne) {
  const EvenLoops result = solved({wanting(3), wanting(30), wanting(4)}, {{{0, 1, 2}}});
  EXPECT_EQ(result.changes, (SegmentChanges{0, 1, 0}));
}

TEST(EvenLoops, RoundsTheOtherWayWhereThatIsNearer) {
  EXPECT_EQ(solved({wanting(3.3)}, {{{0}}}).changes, SegmentChanges{1});
  EXPECT_EQ(solved({wanting(2.6)}, {{{0}}}).changes, SegmentChanges{-1});
  EXPECT_EQ(solved({wanting(2.6, 3)}, {{{0}}}).changes, SegmentChanges{1}) << "three at least";
  EXPECT_EQ(solved({wanting(0.001)}, {{{0}}}).changes, SegmentChanges{1}) << "one at least";
}

TEST(EvenLoops, IgnoresSeams) {
  // A cylinder: the seam 0, the circles 1 and 2.
  const std::vector<CountedLoop> loops{{{1}}, {{2}}, {{1, 0, 2, 0}}};
  const EvenLoops result = solved({wanting(50), wanting(7), wanting(9)}, loops);
  EXPECT_EQ(result.changes[0], 0);
  EXPECT_TRUE(result.odd.empty());
}

TEST(EvenLoops, CountsWhatBelongsToNoEdge) {
  EXPECT_EQ(solved({wanting(4)}, {{{0}, true}}).changes, SegmentChanges{1});
  EXPECT_EQ(solved({wanting(5)}, {{{0}, true}}).changes, SegmentChanges{0});
}

TEST(EvenLoops, KeepsGivenEdges) {
  const EvenLoops result = solved({given(3), wanting(2), given(4)}, {{{0, 1, 2}}});
  EXPECT_EQ(result.changes, (SegmentChanges{0, 1, 0}));
}

TEST(EvenLoops, NamesLoopsThatStayOdd) {
  EXPECT_EQ(solved({given(3), given(4)}, {{{1}}, {{0}}, {{0, 1}}}).odd,
            (std::vector<std::size_t>{1, 2}));
}

TEST(EvenLoops, LeavesOneLoopOddWhereTheirNumberIsOdd) {
  // Three loops in a row, closed at both ends by given edges.
  const std::vector<CountedLoop> loops{{{0, 1}}, {{1, 2}}, {{2, 3}}};
  const std::vector<SegmentCount> counts{given(3), wanting(4), wanting(4), given(4)};
  EXPECT_EQ(solved(counts, loops).odd.size(), 1u);
  EXPECT_TRUE(solved({given(3), wanting(4), wanting(4), given(5)}, loops).odd.empty());
}

TEST(EvenLoops, UsesEdgesOfThreeLoopsWhereItMust) {
  // Three sheets that meet at edge 0; all else is given.
  const std::vector<CountedLoop> loops{{{0, 1}}, {{0, 2}}, {{0, 3}}};
  EXPECT_TRUE(solved({wanting(4), given(3), given(5), given(7)}, loops).odd.empty());
  EXPECT_EQ(solved({wanting(4), given(3), given(4), given(4)}, loops).odd.size(), 1u);
  const EvenLoops free = solved({wanting(40), wanting(3), wanting(5), wanting(7)}, loops);
  EXPECT_TRUE(free.odd.empty());
  EXPECT_EQ(free.changes[0], 0) << "the borders of the sheets are enough";
}

/// Loops that use edges drawn at random, each edge once, twice or three times.
struct RandomCase {
  std::vector<SegmentCount> counts;
  std::vector<CountedLoop> loops;

  RandomCase(std::mt19937& random, std::size_t edges, std::size_t loopCount) : loops(loopCount) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    for (std::size_t i = 0; i < edges; ++i) {
      const double wanted = 1 + 0.01 * static_cast<double>(below(800));
      counts.push_back(below(4) == 0 ? given(1 + below(5)) : wanting(wanted, 1 + below(3)));
      const std::size_t uses = std::min<std::size_t>(2, 1 + below(8)) + (below(6) == 0 ? 1 : 0);
      for (std::size_t k = 0; k < uses; ++k) loops[below(loopCount)].counts.push_back(i);
    }
  }

  /// The least number of loops that stay odd, over all choices of edges.
  std::size_t fewestOdd() const {
    std::size_t fewest = loops.size();
    for (std::size_t chosen = 0; chosen < (std::size_t(1) << counts.size()); ++chosen) {
      SegmentChanges changes;
      bool isAllowed = true;
      for (std::size_t i = 0; i < counts.size(); ++i) {
        changes.push_back((chosen >> i) & 1 ? 1 : 0);
        isAllowed = isAllowed && !(changes.back() == 1 && counts[i].isFixed);
      }
      if (!isAllowed) continue;
      const auto odd = std::ranges::count_if(
          loops, [&](const CountedLoop& loop) { return isOdd(loop, counts, changes); });
      fewest = std::min(fewest, static_cast<std::size_t>(odd));
    }
    return fewest;
  }
};

/// The sides of a strip, between two faces.
TEST(EvenLoops, ChangesBothSidesOfAStripAlike) {
  const std::vector<CountedLoop> loops{{{0}}, {{0, 1}}, {{1}}};
  const std::vector<SegmentCount> counts{wanting(7.3), wanting(6.8)};
  EXPECT_EQ(solved(counts, loops).changes, (SegmentChanges{1, -1}));
  EXPECT_EQ(solved(counts, loops, {{0, 1}}).changes, (SegmentChanges{1, 1}));
}

TEST(EvenLoops, ChangesOtherEdgesRatherThanOneSideOfAStrip) {
  const std::vector<SegmentCount> counts{wanting(30), wanting(30), wanting(9)};
  EXPECT_EQ(solved(counts, {{{0, 1, 2}}}).changes, (SegmentChanges{1, 0, 0}));
  EXPECT_EQ(solved(counts, {{{0, 1, 2}}}, {{0, 1}}).changes, (SegmentChanges{0, 0, 1}));
}

TEST(EvenLoops, ChangesOneSideOfAStripWhereItMust) {
  const std::vector<SegmentCount> counts{wanting(30), wanting(30), given(9)};
  EXPECT_EQ(solved(counts, {{{0, 1, 2}}}, {{0, 1}}).changes, (SegmentChanges{1, 0, 0}));
  EXPECT_EQ(solved({given(30), wanting(31)}, {{{0, 1}}}, {{0, 1}}).changes, (SegmentChanges{0, 1}));
}

/// Edge 0 changes by itself, because three loops use it, then back with edge 1.
TEST(EvenLoops, ChangesWhatIsTakenTwiceNotAtAll) {
  const std::vector<SegmentCount> counts{wanting(30), wanting(11), wanting(4)};
  const std::vector<CountedLoop> loops{{{0, 2}}, {{0, 1}}, {{0, 1}}, {{1}}};
  EXPECT_EQ(solved(counts, loops, {{0, 1}}).changes, (SegmentChanges{0, 1, 0}));
}

TEST(EvenLoops, FindsASolutionWheneverThereIsOne) {
  std::mt19937 random(20240501);
  int solvable = 0;
  for (int i = 0; i < 400; ++i) {
    const RandomCase drawn(random, 3 + i % 8, 2 + static_cast<std::size_t>(i) % 5);
    const std::size_t fewest = drawn.fewestOdd();
    solvable += fewest == 0;
    const EvenLoops result = solved(drawn.counts, drawn.loops);
    EXPECT_EQ(result.odd.empty(), fewest == 0) << "case " << i;
    const EvenLoops withStrip = solved(drawn.counts, drawn.loops, {{0, 1}});
    EXPECT_EQ(withStrip.odd.empty(), fewest == 0) << "case " << i << " with a strip";
  }
  EXPECT_GT(solvable, 50);
  EXPECT_LT(solvable, 350);
}

TEST(EvenLoops, TakesLittleTimeForLargeModels) {
  // A closed grid of 5,000 loops and 10,000 edges.
  constexpr std::size_t kRows = 50, kColumns = 100;
  std::mt19937 random(7);
  std::vector<SegmentCount> counts;
  for (std::size_t i = 0; i < 2 * kRows * kColumns; ++i)
    counts.push_back(wanting(1 + 0.01 * static_cast<double>(random() % 2000)));
  std::vector<CountedLoop> loops;
  for (std::size_t r = 0; r < kRows; ++r)
    for (std::size_t c = 0; c < kColumns; ++c) {
      const auto below = [&](std::size_t row) { return 2 * (row % kRows * kColumns + c); };
      const auto left = [&](std::size_t column) { return 2 * (r * kColumns + column % kColumns); };
      loops.push_back({{below(r), below(r + 1), left(c) + 1, left(c + 1) + 1}});
    }
  const Stopwatch watch;
  EXPECT_TRUE(solved(counts, loops).odd.empty());
  EXPECT_LT(watch.seconds(), 1.0 * AF2_SLOWNESS);
}

}  // namespace
}  // namespace af2::geometry
