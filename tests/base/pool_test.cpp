#include "core/base/pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace spanline {
namespace {

struct Block {
  std::uint16_t next;
  int payload;
};

using Free = FreeList<Block, &Block::next>;

TEST(PoolRef, CapacityIsTheLesserOfArrayAndLimit) {
  Pool<Block, 5> pool;
  PoolRef<Block> ref = pool.ref();
  EXPECT_EQ(ref.capacity(), 5);
  ref.limit(100000);
  EXPECT_EQ(ref.capacity(), 5);
  ref.limit(2);
  EXPECT_EQ(ref.capacity(), 2);
  ref.limit(4);
  EXPECT_EQ(ref.capacity(), 2) << "a limit never grows";
}

TEST(PoolRef, ElementZeroIsAWritableSink) {
  Pool<Block, 1> pool;
  PoolRef<Block> ref = pool.ref();
  ref[0].payload = 9;
  ref[1].payload = 8;
  EXPECT_EQ(ref[0].payload, 9);
}

TEST(FreeList, HandsOutEveryBlockOnceThenZero) {
  Pool<Block, 4> pool;
  Free free(pool.ref());
  std::set<std::uint16_t> taken;
  for (int i = 0; i < 4; ++i) taken.insert(free.take());
  EXPECT_EQ(taken, (std::set<std::uint16_t>{1, 2, 3, 4}));
  EXPECT_EQ(free.take(), 0);
  EXPECT_EQ(free.used(), 4) << "a failed take is not counted";
}

TEST(FreeList, ReusesWhatWasGivenBack) {
  Pool<Block, 2> pool;
  Free free(pool.ref());
  const std::uint16_t first = free.take();
  free.take();
  free.give(first);
  EXPECT_EQ(free.used(), 1);
  EXPECT_EQ(free.take(), first);
  EXPECT_EQ(free.take(), 0);
  EXPECT_EQ(free.ever_used(), 2);
}

TEST(FreeList, ClearForgetsAll) {
  Pool<Block, 3> pool;
  Free free(pool.ref());
  free.give((free.take(), free.take()));
  free.clear();
  EXPECT_EQ(free.used(), 0);
  std::vector<std::uint16_t> taken{free.take(), free.take(), free.take()};
  std::sort(taken.begin(), taken.end());
  EXPECT_EQ(taken, (std::vector<std::uint16_t>{1, 2, 3}));
}

TEST(FreeList, AnEmptyPoolHasNothing) {
  Pool<Block, 0> pool;
  Free free(pool.ref());
  EXPECT_EQ(free.take(), 0);
  EXPECT_EQ(free.capacity(), 0);
}

}  // namespace
}  // namespace spanline
