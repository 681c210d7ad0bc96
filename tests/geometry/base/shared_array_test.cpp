#include "geometry/base/shared_array.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

TEST(SharedArray, IsSharedUntilItIsChanged) {
  SharedArray<int> array;
  EXPECT_EQ(array.size(), 0u);
  array.edit() = {1, 2, 3};
  SharedArray<int> copy = array;
  EXPECT_EQ(&copy[0], &array[0]);
  EXPECT_EQ(copy, array);
  copy.edit().push_back(4);
  EXPECT_EQ(copy.size(), 4u);
  EXPECT_EQ(array.size(), 3u);
  EXPECT_FALSE(copy == array);
  const int* const own = &copy[0];
  copy.edit()[0] = 5;
  EXPECT_EQ(&copy[0], own) << "nobody else has it any more";
  EXPECT_EQ(array[0], 1);
  copy.edit() = array;
  EXPECT_EQ(copy, array) << "equal numbers";
}

}  // namespace
}  // namespace af2::geometry
