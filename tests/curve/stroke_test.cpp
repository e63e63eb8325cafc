// Strokes against their definition: a sample is covered where the curve is at most half the width away.
#include "core/curve/stroke.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "curve/curves.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr int kWidth = 96, kHeight = 64;

// The masks of a whole picture, drawn downwards; a strand begins at `top` at the earliest.
std::vector<CoverageMask> drawn(const Cubic& curve, const Pen& pen, int top = 0) {
  std::vector<CoverageMask> line(kWidth + 1), all;
  LineCoverage coverage({line.data(), kWidth}, kWidth);
  const Strands strands(curve);
  std::vector<Stroke> strokes;
  for (unsigned i = 0; i < strands.count(); ++i) strokes.emplace_back(strands[i], pen);
  for (int y = top; y < kHeight; ++y) {
    for (Stroke& stroke : strokes) {
      if (stroke.first_line() <= y) stroke.draw(y, coverage);
    }
    all.insert(all.end(), line.begin(), line.end() - 1);
    coverage.take([&](std::uint32_t x, std::uint32_t part) {
      ASSERT_LT(x, static_cast<std::uint32_t>(kWidth));
      ASSERT_LE(part, 16u);
    });
  }
  return all;
}

std::vector<At> samples_of(const Cubic& curve) {
  std::vector<At> samples;
  for (int i = 0; i <= 1500; ++i) samples.push_back(exact_at(curve, i / 1500.0));
  return samples;
}

double distance(const std::vector<At>& curve, double x, double y) {
  double best = 1e18;
  for (const At& at : curve) best = std::min(best, (at.x - x) * (at.x - x) + (at.y - y) * (at.y - y));
  return std::sqrt(best);
}

// Samples are cut off at 1/16 px, discs stand apart, the oracle's points too: nearer than this to the outline, either
// answer will do.
constexpr double kSlack = 0.2;

void expect_covered(const Cubic& curve, const Pen& pen) {
  const std::vector<CoverageMask> masks = drawn(curve, pen);
  const std::vector<At> exact = samples_of(curve);
  const double radius = pen.radius / 16.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const CoverageMask mask = masks[static_cast<std::size_t>(y * kWidth + x)];
      if (std::abs(distance(exact, x + 0.5, y + 0.5) - radius) > 1 + kSlack) {
        ASSERT_TRUE(mask == 0 || mask == 0xffff);
      }
      for (int s = 0; s < 16; s += pen.smooth ? 3 : 16) {
        const double px = pen.smooth ? x + (s % 4 + 0.5) / 4 : x + 0.5,
                     py = pen.smooth ? y + (s / 4 + 0.5) / 4 : y + 0.5;
        const double d = distance(exact, px, py);
        const bool covered = (mask >> s & 1) != 0;
        const bool either = std::abs(d - radius) <= kSlack;
        ASSERT_TRUE(either || covered == (d < radius)) << "x " << x << " y " << y << " sample " << s << " at " << d;
      }
    }
  }
}

TEST(Stroke, CoversWhatIsWithinHalfItsWidth) {
  Random random(1);
  for (int i = 0; i < oracle::rounds(24); ++i) {
    const Cubic curve = random_cubic(random, kWidth, kHeight);
    const Pen pen{static_cast<std::uint16_t>(random.between(8, 100)), i % 2 == 0};
    expect_covered(curve, pen);
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
  }
}

TEST(Stroke, ALateBeginningChangesNothing) {
  Random random(2);
  for (int i = 0; i < oracle::rounds(200); ++i) {
    const Cubic curve = random_cubic(random, kWidth, kHeight);
    const bool thin = random.percent(30);
    const Pen pen{static_cast<std::uint16_t>(thin ? 0 : random.between(8, 60)), !thin && i % 2 == 0};
    const int top = random.below(kHeight);
    const auto whole = drawn(curve, pen), late = drawn(curve, pen, top);
    ASSERT_TRUE(std::equal(late.begin(), late.end(), whole.begin() + top * kWidth)) << "curve " << i;
  }
}

TEST(Stroke, CoverageIsCountedInSixteenths) {
  // A straight stroke a pixel and a half high, its middle on the lower edge of line 3.
  const Cubic line = {{{160, 64}, {480, 64}, {800, 64}, {1120, 64}}};
  const auto masks = drawn(line, {12, true});
  EXPECT_EQ(masks[3 * kWidth + 40], 0xfff0);
  EXPECT_EQ(masks[4 * kWidth + 40], 0x0fff);
  EXPECT_EQ(masks[2 * kWidth + 40], 0);
  EXPECT_EQ(masks[5 * kWidth + 40], 0);
}

}  // namespace
}  // namespace spanline::test
