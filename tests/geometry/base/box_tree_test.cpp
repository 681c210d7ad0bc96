#include "geometry/base/box_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace af2::geometry {
namespace {

class Boxes {
 public:
  /// Coordinates are multiples of an eighth, so that ties occur.
  Boxes(unsigned seed, std::size_t count) : random_(seed) {
    for (std::size_t i = 0; i < count; ++i) {
      Box3& box = boxes.emplace_back();
      box.add(point());
      if (random_() % 4 != 0) box.add(box.low + 0.25 * point());
    }
  }

  Point3 point() {
    const auto next = [&] { return static_cast<double>(random_() % 17) / 8; };
    const double x = next(), y = next();
    return {x, y, next()};
  }

  std::vector<Box3> boxes;

 private:
  std::mt19937 random_;
};

/// Calls check(tree, boxes, point) for many boxes and points.
template <class Check>
void forManyPoints(const Check& check) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Boxes made(seed, seed);
    const BoxTree tree(made.boxes);
    for (int i = 0; i < 20; ++i) check(tree, made.boxes, made.point());
  }
}

TEST(BoxTree, FindsTheNearestOfManyAsIfAllWereCompared) {
  constexpr double kFarthest[] = {0, 0.125, 0.5, std::numeric_limits<double>::infinity()};
  forManyPoints([&](const BoxTree& tree, const std::vector<Box3>& boxes, const Point3& p) {
    for (const double farthest : kFarthest) {
      std::uint32_t nearest = BoxTree::kNone;
      double least = farthest;
      for (std::uint32_t b = 0; b < boxes.size(); ++b) {
        const double d = boxes[b].distanceTo(p);
        if (d < least || (d == least && nearest == BoxTree::kNone)) {
          nearest = b;
          least = d;
        }
      }
      EXPECT_EQ(tree.nearest(p, farthest, [&](std::uint32_t b) { return boxes[b].distanceTo(p); }),
                nearest);
    }
  });
}

TEST(BoxTree, FindsTheFirstBoxAtAPointThatIsAccepted) {
  const auto isEven = [](std::uint32_t b) { return b % 2 == 0; };
  int found = 0;
  forManyPoints([&](const BoxTree& tree, const std::vector<Box3>& boxes, const Point3& p) {
    std::uint32_t first = BoxTree::kNone;
    for (std::uint32_t b = 0; b < boxes.size() && first == BoxTree::kNone; ++b)
      if (isEven(b) && boxes[b].distanceTo(p) == 0) first = b;
    EXPECT_EQ(tree.firstAt(p, isEven), first);
    found += first != BoxTree::kNone;
  });
  EXPECT_GT(found, 20);
}

TEST(Box3, IsAsFarAwayAsItsNearestPoint) {
  Box3 box;
  box.add(Point3{0, 0, 0});
  box.add(Point3{1, 2, 3});
  EXPECT_EQ(box.distanceTo({0.5, 1, 3}), 0);
  EXPECT_EQ(box.distanceTo({-3, 1, 7}), 5);
  EXPECT_EQ(box.squaredDistanceTo({2, 4, 5}), 9);
}

}  // namespace
}  // namespace af2::geometry
