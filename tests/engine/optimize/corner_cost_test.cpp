// That costs of corners lead to good shapes, and that their derivatives are those of the costs.
#include "engine/optimize/corner_cost.h"

#include <gtest/gtest.h>

#include <array>

namespace af2 {
namespace {

constexpr double kDelta = 1e-5;

/// How the sides of a corner follow a vertex at x.
struct Role {
  const char* name;
  double byAhead, byBehind;
};
constexpr std::array<Role, 3> kRoles{{{"at", -1, -1}, {"ahead", 1, 0}, {"behind", 0, 1}}};

CornerShape moved(const CornerShape& corner, const Role& role, Point2 x) {
  return {corner.ahead + role.byAhead * x, corner.behind + role.byBehind * x, corner.scale};
}

CornerSum sumAt(const CornerShape& corner, const Role& role, Point2 x) {
  CornerSum sum;
  moved(corner, role, x).addTo(sum, role.byAhead, role.byBehind);
  return sum;
}

TEST(CornerShape, CostsLeastWhereItIsIdeal) {
  const double ideal = CornerShape{{1, 0}, {0, 1}, 1}.cost();
  EXPECT_NEAR(ideal, 1 + CornerShape::kSides, 1e-12);
  EXPECT_GT((CornerShape{{1, 0}, {0.2, 1}, 1}.cost()), ideal);
  EXPECT_GT((CornerShape{{1, 0}, {0, 2}, 1}.cost()), ideal);
  EXPECT_NEAR((CornerShape{{1, 0}, {0.5, std::sqrt(0.75)}, 2 / std::sqrt(3.0)}.cost()), ideal,
              1e-12);
}

TEST(CornerShape, CostsMoreTheFurtherItIsInverted) {
  double before = 0;
  for (const double height : {0.5, 0.1, 0.04, 0.0, -0.1, -0.5}) {
    const double cost = CornerShape{{1, 0}, {0.5, height}, 1}.cost();
    EXPECT_GT(cost, before);
    before = cost;
  }
}

TEST(CornerShape, HasTheDerivativesOfItsCost) {
  const CornerShape corner{{1.1, 0.2}, {-0.3, 0.7}, 1};
  for (const Role& role : kRoles) {
    const auto cost = [&](double x, double y) { return moved(corner, role, {x, y}).cost(); };
    const CornerSum sum = sumAt(corner, role, {});
    EXPECT_NEAR(sum.value, corner.cost(), 1e-12) << role.name;
    EXPECT_NEAR(sum.slope.x, (cost(kDelta, 0) - cost(-kDelta, 0)) / (2 * kDelta), 1e-7);
    EXPECT_NEAR(sum.slope.y, (cost(0, kDelta) - cost(0, -kDelta)) / (2 * kDelta), 1e-7);
    const CornerSum right = sumAt(corner, role, {kDelta, 0}), up = sumAt(corner, role, {0, kDelta});
    EXPECT_NEAR(sum.xx, (right.slope.x - sum.slope.x) / kDelta, 1e-3) << role.name;
    EXPECT_NEAR(sum.xy, (up.slope.x - sum.slope.x) / kDelta, 1e-3) << role.name;
    EXPECT_NEAR(sum.yy, (up.slope.y - sum.slope.y) / kDelta, 1e-3) << role.name;
  }
}

}  // namespace
}  // namespace af2
