#include "geometry/occ/faces/chains.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"

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

TEST(Chains, HaveVerticesInTheOrderInWhichTheyCome) {
  const auto a = corner(70, 0, 0), b = corner(5, 1, 0), c = corner(900, 0, 1);
  std::vector<Chain> chains{chain(1, {a, c}), chain(2, {c, b}), chain(3, {b, a})};
  EXPECT_EQ(numberVertices(chains), (std::vector<std::uint32_t>{70, 900, 5}));
  EXPECT_EQ(ids(chains[0].corners), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(ids(chains[1].corners), (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(ids(chains[2].corners), (std::vector<std::size_t>{2, 0}));
  std::vector<Chain> none;
  EXPECT_TRUE(numberVertices(none).empty());
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

/// As at the end of a wing whose trailing edge is its seam: both sides of the rim and of the seam
/// meet there, and the tangent plane of the one side tells nothing of the other.
TEST(Chains, GoOnOnTheirOwnSideOfASharpSeam) {
  const Point3 upper{0, 0, 1}, lower = unit({0.9, 0, -1});
  const auto at = [](std::size_t id, const Point3& p, const Point3& normal, double u, double v) {
    return BoundaryCorner{VertexId(id), {p, normal, u, v}};
  };
  for (const double askew : {-0.4, 0.4}) {
    const Point3 end{0, 0, 0}, onSeam{0, 2, 0};
    const auto endUp = at(0, end, upper, 0, 0), endDown = at(0, end, lower, 4, 0);
    const auto seamUp = at(1, onSeam, upper, 0, 2), seamDown = at(1, onSeam, lower, 4, 2);
    const auto rimUp = at(2, {-1, askew, 0}, upper, 1, 0);
    const auto rimDown = at(3, {-1, 0, -0.9}, lower, 3, 0);
    const auto farUp = at(4, {-1, 2 + askew, 0}, upper, 1, 2);
    const auto farDown = at(5, {-1, 2, -0.9}, lower, 3, 2);
    const LinkedLoops linked =
        linkChains({chain(1, {endUp, rimUp, rimDown, endDown}), chain(2, {endDown, seamDown}),
                    chain(3, {seamDown, farDown, farUp, seamUp}), chain(2, {seamUp, endUp})});
    EXPECT_EQ(linked.loops.size(), 1u);
    EXPECT_TRUE(linked.closedInParameters());
  }
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
