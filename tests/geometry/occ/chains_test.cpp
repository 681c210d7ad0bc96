#include "geometry/occ/chains.h"

#include <gtest/gtest.h>

#include "engine/error.h"

namespace af2::geometry {
namespace {

BoundaryCorner corner(std::size_t id, double x, double y) {
  return {VertexId(id), {{x, y, 0}, {0, 0, 1}, x, y}};
}
Chain chain(int edge, std::vector<BoundaryCorner> corners) {
  return {edge, false, 0, std::move(corners)};
}

std::vector<std::size_t> ids(const std::vector<BoundaryCorner>& loop) {
  std::vector<std::size_t> result;
  for (const BoundaryCorner& c : loop) result.push_back(c.vertex.value);
  return result;
}

TEST(Chains, AreJoinedToALoopWhateverTheirOrder) {
  const auto a = corner(0, 0, 0), b = corner(1, 1, 0), c = corner(2, 0, 1), m = corner(3, 0.5, 0);
  const LinkedLoops linked = linkChains({chain(1, {c, a}), chain(2, {b, c}), chain(3, {a, m, b})});
  ASSERT_EQ(linked.loops.size(), 1u);
  EXPECT_EQ(ids(linked.loops[0]), (std::vector<std::size_t>{2, 0, 3, 1}));
  EXPECT_TRUE(linked.closedInParameters());
}

TEST(Chains, ThatMeetAtOneVertexBoundTheSameSector) {
  // Two triangles with a common tip: one is the outline, the other a hole inside it.
  const auto tip = corner(0, 0, 0), b = corner(1, 4, -4), c = corner(2, 4, 4);
  const auto d = corner(3, 2, 1), e = corner(4, 2, -1);
  const LinkedLoops linked = linkChains({chain(1, {tip, b}), chain(2, {b, c}), chain(3, {c, tip}),
                                         chain(4, {tip, d}), chain(5, {d, e}), chain(6, {e, tip})});
  // The region is pinched at the tip: one walk around it.
  ASSERT_EQ(linked.loops.size(), 1u);
  EXPECT_EQ(ids(linked.loops[0]), (std::vector<std::size_t>{0, 1, 2, 0, 3, 4}));
}

TEST(Chains, ThatMeetAtOneVertexFromOutsideBoundLoopsOfTheirOwn) {
  const auto tip = corner(0, 0, 0), b = corner(1, 4, -1), c = corner(2, 4, 1);
  const auto d = corner(3, -4, 1), e = corner(4, -4, -1);
  const LinkedLoops linked = linkChains({chain(1, {tip, b}), chain(2, {b, c}), chain(3, {c, tip}),
                                         chain(4, {tip, d}), chain(5, {d, e}), chain(6, {e, tip})});
  EXPECT_EQ(linked.loops.size(), 2u);
}

TEST(Chains, AreRefusedIfTheyDoNotClose) {
  const auto a = corner(0, 0, 0), b = corner(1, 1, 0), c = corner(2, 0, 1);
  EXPECT_THROW(linkChains({chain(1, {a, b}), chain(2, {b, c})}), GeometryError);
}

TEST(Chains, TellWhenTheyAreOpenInTheParameters) {
  const auto a = corner(0, 0, 0), b = corner(1, 1, 0), c = corner(2, 0, 1);
  auto pole = a;
  pole.point.u = 0.5;
  EXPECT_FALSE(
      linkChains({chain(1, {a, b}), chain(2, {b, c}), chain(3, {c, pole})}).closedInParameters());
}

TEST(Chains, OfOneSegmentCancelTheirOpposites) {
  const auto a = corner(0, 0, 0), b = corner(1, 1, 0), c = corner(2, 0, 1);
  std::vector<Chain> chains{chain(1, {a, b}), chain(2, {b, a}), chain(3, {b, c})};
  cancelOppositeChains(chains);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains[0].edge, 3);
}

std::size_t leftOf(std::vector<Chain> chains, const std::vector<std::size_t>& wire) {
  cancelTouching(chains, wire, areOpposite, [](const SurfacePoint& p) { return Point2{p.u, p.v}; });
  return chains.size();
}

/// A square with a slit from its left side to its middle, or with a needle out of that side.
TEST(Chains, ThatTouchCancelEachOtherUnlessTheyAreASlit) {
  const auto a = corner(0, 0, 0), b = corner(1, 4, 0), c = corner(2, 4, 4), d = corner(3, 0, 4);
  const auto foot = corner(4, 0, 2), in = corner(5, 2, 2), out = corner(6, -2, 2);
  const auto square = [&](const BoundaryCorner& tip, int back) {
    return std::vector<Chain>{chain(1, {a, b}),    chain(2, {b, c}),      chain(3, {c, d}),
                              chain(4, {d, foot}), chain(5, {foot, tip}), chain(back, {tip, foot}),
                              chain(7, {foot, a})};
  };
  EXPECT_EQ(leftOf(square(in, 6), {0, 0, 0, 0, 0, 0, 0}), 7u);
  EXPECT_EQ(leftOf(square(out, 6), {0, 0, 0, 0, 0, 0, 0}), 5u);
  EXPECT_EQ(leftOf(square(in, 6), {0, 0, 0, 0, 0, 1, 0}), 5u) << "of two wires";
  EXPECT_EQ(leftOf(square(out, 5), {0, 0, 0, 0, 0, 0, 0}), 7u) << "the same edge";
}

}  // namespace
}  // namespace af2::geometry
