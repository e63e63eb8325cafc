#include "core/base/slice.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

TEST(Slice, IsEmptyByDefault) {
  const Slice<int> none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.size(), 0u);
  EXPECT_EQ(none.begin(), none.end());
}

TEST(Slice, ViewsAnArrayInPlace) {
  int items[] = {1, 2, 3};
  const Slice<int> view = items;
  EXPECT_EQ(view.size(), 3u);
  view[1] = 7;
  EXPECT_EQ(items[1], 7);
  int sum = 0;
  for (const int item : view) sum += item;
  EXPECT_EQ(sum, 11);
}

}  // namespace
}  // namespace spanline
