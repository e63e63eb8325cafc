#include "core/fx/root.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

void expect_root(std::uint64_t value) {
  const std::uint64_t root = square_root(value);
  EXPECT_LE(root * root, value) << value;
  EXPECT_TRUE(root == UINT32_MAX || (root + 1) * (root + 1) > value) << value;
  if (value <= UINT32_MAX) {
    EXPECT_EQ(square_root(static_cast<std::uint32_t>(value)), static_cast<std::uint32_t>(root)) << value;
  }
}

TEST(SquareRoot, OfSmallNumbers) {
  for (std::uint64_t value = 0; value < 70000; ++value) expect_root(value);
}

TEST(SquareRoot, AroundSquaresAndPowersOfTwo) {
  for (std::uint64_t root = 1; root < (std::uint64_t{1} << 32); root = root * 5 / 3 + 1) {
    expect_root(root * root);
    expect_root(root * root - 1);
  }
  for (int bit = 0; bit < 64; ++bit) {
    expect_root(std::uint64_t{1} << bit);
    expect_root((std::uint64_t{1} << bit) - 1);
  }
  expect_root(UINT32_MAX);
  expect_root(UINT64_MAX);
}

}  // namespace
}  // namespace spanline
