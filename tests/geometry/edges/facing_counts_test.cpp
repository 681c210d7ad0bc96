#include "geometry/edges/facing_counts.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

SegmentCount count(std::size_t segments, bool isFixed = false) {
  return {static_cast<double>(segments), segments, 1, isFixed};
}

/// Straight edges, each with a count of its own.
class Edges {
 public:
  Edges& add(const Point3& from, const Point3& to, std::size_t segments) {
    DividedEdge& edge = divided_.edges.emplace_back();
    for (std::size_t i = 0; i <= segments; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(segments);
      edge.parameters.push_back(t);
      edge.points.push_back(static_cast<std::uint32_t>(divided_.points.size()));
      divided_.points.push_back(from + t * (to - from));
    }
    edge.counts = {divided_.counts.size()};
    divided_.counts.push_back(count(segments));
    return *this;
  }
  std::vector<FacingPair> pairs() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < divided_.counts.size(); ++i) all.push_back(i);
    return FacingEdges(divided_).around(all);
  }
  DividedEdges divided_;
};

using Pairs = std::vector<FacingPair>;

TEST(FacingEdges, AreTheSidesOfAStrip) {
  Edges strip;
  strip.add({0, 0, 0}, {10, 0, 0}, 10).add({10, 1, 0}, {0, 1, 0}, 8);
  strip.add({0, 0, 0}, {0, 1, 0}, 1).add({10, 0, 0}, {10, 1, 0}, 1);
  EXPECT_EQ(strip.pairs(), (Pairs{{0, 1}}));
}

TEST(FacingEdges, MayBeMitred) {
  Edges strip;
  strip.add({0, 0, 0}, {10, 0, 0}, 10).add({0.8, 1, 0}, {9.2, 1, 0}, 8);
  EXPECT_EQ(strip.pairs(), (Pairs{{0, 1}}));
}

TEST(FacingEdges, AreNotFarApart) {
  Edges wide;
  wide.add({0, 0, 0}, {10, 0, 0}, 10).add({0, 1.6, 0}, {10, 1.6, 0}, 10);
  EXPECT_EQ(wide.pairs(), Pairs());
}

TEST(FacingEdges, FaceEachOtherAlongTheirWholeLengths) {
  Edges partly;
  partly.add({0, 0, 0}, {10, 0, 0}, 10).add({0, 1, 0}, {7, 1, 0}, 7);
  EXPECT_EQ(partly.pairs(), Pairs());
}

TEST(FacingEdges, AreNotThoseThatGoOnFromEachOther) {
  Edges corner;
  corner.add({0, 0, 0}, {4, 0, 0}, 4).add({4, 0, 0}, {8, 0, 0}, 4).add({0, 0, 0}, {0, 4, 0}, 4);
  EXPECT_EQ(corner.pairs(), Pairs());
}

TEST(FacingEdges, AreSeenInPartsOfEdgesAndWithoutPoints) {
  Edges strip;
  strip.add({0, 0, 0}, {10, 0, 0}, 10).add({0, 1, 0}, {20, 1, 0}, 20);
  DividedEdge& edge = strip.divided_.edges[1];
  edge.stops = {10};
  edge.counts = {1, 2};
  strip.divided_.counts = {count(10), count(10), count(10), count(5)};  // the last has no edge
  EXPECT_EQ(strip.pairs(), (Pairs{{0, 1}}));
}

std::vector<std::size_t> matched(std::vector<SegmentCount> counts, const Pairs& pairs,
                                 const std::vector<FacingCounts>& facing) {
  EXPECT_EQ(matchFacing(pairs, counts), facing);
  std::vector<std::size_t> segments;
  for (const SegmentCount& c : counts) segments.push_back(c.segments);
  return segments;
}

using Segments = std::vector<std::size_t>;

TEST(MatchFacing, TakesTheLargerNumber) {
  EXPECT_EQ(matched({count(10), count(8), count(3)}, {{0, 1}}, {{0, 1}}), (Segments{10, 10, 3}));
}

TEST(MatchFacing, GoesOnFromStripToStrip) {
  EXPECT_EQ(matched({count(8), count(10), count(9), count(10)}, {{0, 2}, {1, 2}}, {{0, 1, 2}}),
            (Segments{10, 10, 10, 10}));
}

TEST(MatchFacing, LeavesWhatDiffersMuch) {
  EXPECT_EQ(matched({count(10), count(7)}, {{0, 1}}, {}), (Segments{10, 7}));
}

TEST(MatchFacing, KeepsGivenDivisions) {
  EXPECT_EQ(matched({count(10), count(9, true)}, {{0, 1}}, {}), (Segments{10, 9}));
  EXPECT_EQ(matched({count(9), count(10, true)}, {{0, 1}}, {{0, 1}}), (Segments{10, 10}));
}

TEST(MatchFacing, MakesNumbersWanted) {
  std::vector<SegmentCount> counts{count(10), {7.6, 8, 2, false}};
  matchFacing({{0, 1}}, counts);
  EXPECT_EQ(counts[1].wanted, 10);
  EXPECT_EQ(counts[1].least, 2u);
}

}  // namespace
}  // namespace af2::geometry
