#include "sim/arguments.hpp"

#include <gtest/gtest.h>

#include "core/frame/budget.hpp"
#include "sim/host_memory.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

TEST(Arguments, ReadSizes) {
  EXPECT_EQ(parse_size("--size", "320x240"), (std::pair<std::uint16_t, std::uint16_t>{320, 240}));
  EXPECT_EQ(parse_size("--size", "2046x1").first, 2046);
  for (const char* bad :
       {"", "x", "1x", "x1", "0x1", "1x2047", "1 x2", "1x2 ", "1.5x2", "0x10x3", "99999999999999999999x1"}) {
    EXPECT_THROW(parse_size("--size", bad), UsageError) << bad;
  }
}

TEST(Arguments, ReadVectors) {
  EXPECT_EQ(parse_vector("--eye", "1,-2.5,3e2"), (Vec3{1, -2.5, 300}));
  for (const char* bad : {"", "1", "1,2", "1,2,3,4", "1,2,", "1,2,inf", "1,2,1e13", "a,b,c", "1, 2,3"}) {
    EXPECT_THROW(parse_vector("--eye", bad), UsageError) << bad;
  }
}

TEST(Arguments, ReadRanges) {
  EXPECT_EQ(parse_range("--frames", "0:12").second, 12);
  for (const char* bad : {"", ":", "1", "1:", ":1", "2:1", "-1:1", "1:2:3"}) {
    EXPECT_THROW(parse_range("--frames", bad), UsageError) << bad;
  }
}

TEST(Arguments, ReadPoolsByTheirNames) {
  PoolSizes sizes;
  for (const std::string& name : kPoolNames) EXPECT_NE(sizes.find(name), nullptr) << name;
  const std::vector<PoolLimit> limits = parse_pools("--pools", "facets=40,segments=0");
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].name, "facets");
  EXPECT_EQ(limits[0].limit, 40);
}

}  // namespace
}  // namespace spanline::host
