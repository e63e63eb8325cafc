#include "frames/minimax.hpp"

#include <gtest/gtest.h>

#include <random>

namespace spanline::bench {
namespace {

TEST(Minimax, FindsPricesThatFit) {
  const Fit fit = minimax_fit({{{1, 0, 4}, 14}, {{2, 1, 0}, 9}, {{0, 3, 1}, 18}, {{1, 1, 1}, 10}});
  ASSERT_EQ(fit.prices.size(), 3u);
  EXPECT_NEAR(fit.off, 0, 1e-9);
  EXPECT_NEAR(fit.prices[0], 2, 1e-9);
  EXPECT_NEAR(fit.prices[1], 5, 1e-9);
  EXPECT_NEAR(fit.prices[2], 3, 1e-9);
}

TEST(Minimax, MeetsInTheMiddle) {
  // One price for 1 and for 3: 1.5, half off both.
  const Fit fit = minimax_fit({{{1}, 1}, {{1}, 3}});
  EXPECT_NEAR(fit.prices[0], 1.5, 1e-9);
  EXPECT_NEAR(fit.off, 0.5, 1e-9);
}

TEST(Minimax, PricesAreNotNegative) {
  const Fit fit = minimax_fit({{{1, 1}, 1}, {{1, 2}, 0.5}});
  EXPECT_GE(fit.prices[0], 0);
  EXPECT_EQ(fit.prices[1], 0);
  EXPECT_NEAR(fit.prices[0], 2.0 / 3, 1e-9);
}

TEST(Minimax, ATermThatNeverOccursCostsNothing) {
  const Fit fit = minimax_fit({{{2, 0}, 4}, {{3, 0}, 6}});
  EXPECT_NEAR(fit.prices[0], 2, 1e-9);
  EXPECT_NEAR(fit.off, 0, 1e-9);
}

// Nothing near the answer is better, and it is the one minimum there is: the error is convex.
TEST(Minimax, NothingNearbyIsBetter) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 100), step(-0.01, 0.01);
  for (int round = 0; round < 100; ++round) {
    std::vector<Measured> measured(6);
    for (Measured& row : measured) {
      row.sum = 1000 + part(random);
      for (int k = 0; k < 4; ++k) row.terms.push_back(part(random));
    }
    const Fit fit = minimax_fit(measured);
    for (int trial = 0; trial < 100; ++trial) {
      double off = 0;
      std::vector<double> prices = fit.prices;
      for (double& price : prices) price = std::max(0.0, price + step(random));
      for (const Measured& row : measured) {
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k) sum += prices[k] * row.terms[k];
        off = std::max(off, std::abs(sum / row.sum - 1));
      }
      EXPECT_GE(off, fit.off - 1e-9) << round;
    }
  }
}

}  // namespace
}  // namespace spanline::bench
