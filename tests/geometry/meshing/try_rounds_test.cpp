#include "geometry/meshing/try_rounds.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

std::vector<std::size_t> facesOf(const std::vector<FaceTry>& tries) {
  std::vector<std::size_t> faces;
  for (const FaceTry& next : tries) faces.push_back(next.face);
  return faces;
}

TEST(TryRounds, MeshesOneOfEachGroup) {
  TryRounds rounds({{{{0, {}}, {2, {}}, {5, {}}}, {}}, {{{1, {}}}, {}}});
  EXPECT_EQ(facesOf(rounds.next()), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(facesOf(rounds.others(0)), (std::vector<std::size_t>{2, 5}));
  EXPECT_TRUE(rounds.others(1).empty());
  rounds.others(0).clear();
  EXPECT_TRUE(rounds.next().empty());
}

TEST(TryRounds, GoesOnWithThoseThatAreLeft) {
  TryRounds rounds({{{{0, {}}, {2, {}}, {5, {}}}, {}}, {{{1, {}}}, {}}});
  rounds.next();
  rounds.others(0).pop_back();
  EXPECT_EQ(facesOf(rounds.next()), std::vector<std::size_t>{2});
  EXPECT_TRUE(rounds.others(0).empty());
  EXPECT_TRUE(rounds.next().empty());
}

TEST(TryRounds, EndsWithAllAtOnce) {
  TryGroup group;
  for (std::size_t i = 0; i < 100; ++i) group.tries.push_back({i, {}});
  TryRounds rounds({group});
  std::size_t count = 0, seen = 0;
  for (auto next = rounds.next(); !next.empty(); next = rounds.next()) {
    ++count;
    for (std::size_t k = 0; k < next.size(); ++k) EXPECT_EQ(next[k].face, seen++);
  }
  EXPECT_EQ(seen, 100u);
  EXPECT_LT(count, 10u);
}

}  // namespace
}  // namespace af2::geometry
