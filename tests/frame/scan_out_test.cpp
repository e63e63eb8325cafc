// Scan-out sends less than everything, and the panel shows the same.
#include "core/frame/scan_out.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "frame/animation.hpp"

namespace spanline {
namespace {

constexpr BackgroundRecord kBlack{};

// A glass that keeps what it is sent, and who sends it.
class Rig {
 public:
  Rig(const Screen& screen, ScanPolicy policy, std::uint8_t window_bytes = 11)
      : screen_(screen),
        lines_(screen.height),
        hashes_(tiles_per_line(screen.width) * screen.height),
        words_((bytes_per_line(screen.format, screen.width) + 3) / 4),
        scan_out_({screen,
                   policy,
                   {lines_.data(), screen.height},
                   {hashes_.data(), static_cast<std::uint32_t>(hashes_.size())},
                   window_bytes}),
        glass_(screen.height, std::vector<std::uint8_t>(bytes_per_line(screen.format, screen.width), 0xEE)) {}

  ScanOut& scan_out() { return scan_out_; }
  const std::vector<std::uint8_t>& glass(int y) const { return glass_[static_cast<std::size_t>(y)]; }
  std::uint32_t bytes_sent() const { return bytes_sent_; }

  // Begins the line and hands out its runs.
  std::vector<PixelRun> runs(int y, const std::vector<std::uint8_t>& bytes) {
    std::memcpy(words_.data(), bytes.data(), bytes.size());
    scan_out_.line(static_cast<std::uint16_t>(y),
                   {reinterpret_cast<const std::uint8_t*>(words_.data()), static_cast<std::uint32_t>(bytes.size())});
    std::vector<PixelRun> all;
    for (PixelRun run; scan_out_.next(run);) all.push_back(run);
    return all;
  }

  // As a panel: an open window goes on with the line below.
  void send(int y, const std::vector<std::uint8_t>& bytes, PixelRun run) {
    if (run.opens) {
      window_ = {run.left, run.right};
      next_line_ = y;
      bytes_sent_ += 11;
    }
    ASSERT_EQ(window_, (Columns{run.left, run.right}));
    ASSERT_EQ(next_line_++, y);
    const std::uint32_t from = bytes_per_line(screen_.format, run.left);
    const std::uint32_t to = bytes_per_line(screen_.format, run.right);
    std::copy(bytes.begin() + from, bytes.begin() + to, glass_[static_cast<std::size_t>(y)].begin() + from);
    bytes_sent_ += to - from;
  }

 private:
  Screen screen_;
  std::vector<Columns> lines_;
  std::vector<std::uint32_t> hashes_, words_;
  ScanOut scan_out_;
  std::vector<std::vector<std::uint8_t>> glass_;
  Columns window_;
  int next_line_ = 0;
  std::uint32_t bytes_sent_ = 0;
};

struct Way {
  Screen screen;
  ScanPolicy policy;
  friend std::ostream& operator<<(std::ostream& out, const Way& way) {
    return out << way.screen.width << " format " << static_cast<int>(way.screen.format) << " policy "
               << static_cast<int>(way.policy);
  }
};

class ScanOutAnimation : public testing::TestWithParam<Way> {
 protected:
  void show_all(Rig& rig, const oracle::Animation& animation) {
    const Screen& screen = GetParam().screen;
    rig.scan_out().begin_frame(oracle::Animation::kBackground);
    for (int y = 0; y < screen.height; ++y) {
      const std::vector<std::uint8_t> line = animation.bytes(y);
      for (const PixelRun run : rig.runs(y, line)) rig.send(y, line, run);
    }
  }
  void expect_shown(const Rig& rig, const oracle::Animation& animation) {
    for (int y = 0; y < GetParam().screen.height; ++y) ASSERT_EQ(rig.glass(y), animation.bytes(y)) << "line " << y;
  }

  // A frame that comes to grief: it ends at some line, or in the middle of one, leaves lines out, or fails.
  void fail(Rig& rig, const oracle::Animation& animation, oracle::Random& random) {
    const Screen& screen = GetParam().screen;
    rig.scan_out().begin_frame(oracle::Animation::kBackground);
    const int end = random.between(0, screen.height - 1);
    for (int y = 0; y < end; ++y) {
      if (random.percent(20)) continue;
      const std::vector<std::uint8_t> line = animation.bytes(y);
      for (const PixelRun run : rig.runs(y, line)) rig.send(y, line, run);
    }
    const std::vector<std::uint8_t> line = animation.bytes(end);
    if (random.percent(50)) {  // runs are handed out and do not arrive
      rig.runs(end, line);
      rig.scan_out().lost();
    } else if (random.percent(50)) {  // nobody asks for the line's runs
      rig.scan_out().line(static_cast<std::uint16_t>(end), word_aligned(line));
    }
  }
  Slice<const std::uint8_t> word_aligned(const std::vector<std::uint8_t>& line) {
    return {line.data(), static_cast<std::uint32_t>(line.size())};  // operator new aligns
  }
};

TEST_P(ScanOutAnimation, ShowsEveryFrame) {
  oracle::Animation animation(GetParam().screen, 7);
  Rig rig(GetParam().screen, GetParam().policy);
  for (int frame = 0; frame < 120; ++frame) {
    show_all(rig, animation);
    expect_shown(rig, animation);
    if (HasFatalFailure()) return;
    animation.step();
  }
}

TEST_P(ScanOutAnimation, ShowsTheFrameAfterAFailedOne) {
  oracle::Animation animation(GetParam().screen, 8);
  oracle::Random random(9);
  Rig rig(GetParam().screen, GetParam().policy);
  for (int frame = 0; frame < 120; ++frame) {
    while (random.percent(50)) {
      fail(rig, animation, random);
      animation.step();
    }
    show_all(rig, animation);
    expect_shown(rig, animation);
    if (HasFatalFailure()) return;
    animation.step();
  }
}

TEST_P(ScanOutAnimation, CostsNoMoreThanTheWholePicture) {
  if (bytes_per_line(GetParam().screen.format, GetParam().screen.width) < 22) return;  // a window costs half of that
  oracle::Animation animation(GetParam().screen, 10);
  Rig rig(GetParam().screen, GetParam().policy);
  show_all(rig, animation);
  const std::uint32_t first = rig.bytes_sent();
  for (int frame = 0; frame < 50; ++frame) {
    animation.step();
    show_all(rig, animation);
  }
  if (GetParam().policy == ScanPolicy::full) {
    EXPECT_EQ(rig.bytes_sent(), 51 * first);
  } else {
    EXPECT_LT(rig.bytes_sent(), 51 * first);
  }
}

std::vector<Way> ways() {
  std::vector<Way> all;
  for (const ScanPolicy policy : {ScanPolicy::full, ScanPolicy::extents, ScanPolicy::tiles}) {
    for (const PixelFormat format : {PixelFormat::rgb565, PixelFormat::grey8, PixelFormat::grey4, PixelFormat::mono1}) {
      all.push_back({{200, 40, format}, policy});
      all.push_back({{37, 30, format}, policy});
    }
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Ways, ScanOutAnimation, testing::ValuesIn(ways()));

// "0-320*" : columns, and whether a window is opened.
std::string text(const std::vector<PixelRun>& runs) {
  std::string all;
  for (const PixelRun run : runs) {
    all +=
        (all.empty() ? "" : " ") + std::to_string(run.left) + "-" + std::to_string(run.right) + (run.opens ? "*" : "");
  }
  return all;
}

// A line of the black background with the pixels of [left, right) lit.
std::vector<std::uint8_t> lit(std::uint32_t left, std::uint32_t right, PixelFormat format = PixelFormat::rgb565) {
  std::vector<std::uint8_t> line(bytes_per_line(format, 320));
  const std::uint32_t bits = bits_per_pixel(format);
  for (std::uint32_t bit = left * bits; bit < right * bits; ++bit) {
    line[bit / 8] = static_cast<std::uint8_t>(line[bit / 8] | 128u >> bit % 8);
  }
  return line;
}

// A screen of ten lines that has been shown once, with columns 100 to 200 covered. The line that a frame refreshes is
// the next one from 1 on.
Rig shown(ScanPolicy policy, PixelFormat format = PixelFormat::rgb565, std::uint8_t window_bytes = 11) {
  Rig rig({320, 10, format}, policy, window_bytes);
  rig.scan_out().begin_frame(kBlack);
  for (int y = 0; y < 10; ++y) rig.runs(y, lit(100, 200, format));
  rig.scan_out().begin_frame(kBlack);
  return rig;
}

TEST(ScanOutRuns, FullOpensOneWindow) {
  Rig rig = shown(ScanPolicy::full);
  EXPECT_EQ(text(rig.runs(0, lit(10, 20))), "0-320*");
  EXPECT_EQ(text(rig.runs(1, lit(10, 20))), "0-320");
  EXPECT_EQ(text(rig.runs(3, lit(10, 20))), "0-320*");  // the line between was not sent
}

TEST(ScanOutRuns, ExtentsHoldWhatIsAndWhatWasCovered) {
  Rig rig = shown(ScanPolicy::extents);
  EXPECT_EQ(text(rig.runs(3, lit(150, 250))), "100-250*");
  EXPECT_EQ(text(rig.runs(4, lit(150, 250))), "100-250");
  EXPECT_EQ(text(rig.runs(5, lit(150, 248))), "100-250");  // two more pixels are cheaper than a window
  EXPECT_EQ(text(rig.runs(6, lit(150, 200))), "100-200*");
  EXPECT_EQ(text(rig.runs(7, lit(0, 0))), "100-200");
  rig.scan_out().begin_frame(kBlack);
  EXPECT_EQ(text(rig.runs(7, lit(0, 0))), "");
  EXPECT_EQ(text(rig.runs(8, lit(0, 0))), "100-200*");
  EXPECT_EQ(text(rig.runs(9, lit(316, 320))), "100-320*");
}

TEST(ScanOutRuns, ExtentsBeginAndEndWithWords) {
  EXPECT_EQ(text(shown(ScanPolicy::extents).runs(3, lit(99, 201))), "98-202*");
  EXPECT_EQ(text(shown(ScanPolicy::extents, PixelFormat::grey4).runs(3, lit(99, 201, PixelFormat::grey4))), "96-208*");
  EXPECT_EQ(text(shown(ScanPolicy::extents, PixelFormat::mono1).runs(3, lit(99, 201, PixelFormat::mono1))), "96-224*");
}

TEST(ScanOutRuns, TilesAreThoseThatChanged) {
  Rig rig = shown(ScanPolicy::tiles);
  EXPECT_EQ(text(rig.runs(3, lit(100, 200))), "");
  std::vector<std::uint8_t> line = lit(100, 200);
  line[2 * 105] = 1;
  EXPECT_EQ(text(rig.runs(4, line)), "100-112*");
  line[2 * 195] = 1;
  EXPECT_EQ(text(rig.runs(5, line)), "100-112* 192-200*");
  EXPECT_EQ(text(rig.runs(6, line)), "100-112* 192-200*");
  rig.scan_out().begin_frame(kBlack);
  EXPECT_EQ(text(rig.runs(6, line)), "");
  EXPECT_EQ(text(rig.runs(5, lit(100, 210))), "100-112* 192-210*");  // no further than the extent
}

// 8 bytes a tile; the gap has five.
TEST(ScanOutRuns, TilesAreJoinedWhereAnotherWindowCostsMore) {
  std::vector<std::uint8_t> line = lit(100, 200, PixelFormat::grey4);
  line[105 / 2] = line[195 / 2] = 1;
  EXPECT_EQ(text(shown(ScanPolicy::tiles, PixelFormat::grey4, 6).runs(3, line)), "96-200*");
  EXPECT_EQ(text(shown(ScanPolicy::tiles, PixelFormat::grey4, 5).runs(3, line)), "96-112* 192-200*");
  // A longer run holds up longer, and may be joined over the same gap.
  line[118 / 2] = 1;
  EXPECT_EQ(text(shown(ScanPolicy::tiles, PixelFormat::grey4, 5).runs(3, line)), "96-200*");
}

TEST(ScanOutRuns, AnotherBackgroundOrALossSendsEverything) {
  for (const ScanPolicy policy : {ScanPolicy::extents, ScanPolicy::tiles}) {
    Rig rig = shown(policy);
    rig.scan_out().begin_frame({{9, 9, 9}, {9, 9, 9}});
    EXPECT_EQ(text(rig.runs(3, lit(100, 200))), "0-320*");
    rig.scan_out().lost();
    EXPECT_EQ(text(rig.runs(4, lit(100, 200))), "0-320*");
  }
}

TEST(ScanOutRuns, EveryLineIsRefreshedInItsTurn) {
  Rig rig({320, 10}, ScanPolicy::tiles);
  std::vector<int> refreshed;
  for (int frame = 0; frame < 11; ++frame) {
    rig.scan_out().begin_frame(kBlack);
    for (int y = 0; y < 10; ++y) {
      if (!rig.runs(y, lit(100, 200)).empty() && frame != 0) refreshed.push_back(y);
    }
  }
  EXPECT_EQ(refreshed, (std::vector<int>{2, 3, 4, 5, 6, 7, 8, 9, 0, 1}));
}

// Whether a change from one content of a tile to another is seen.
bool sees(ScanOut& scan_out, const std::uint32_t (&before)[8], const std::uint32_t (&after)[8]) {
  const auto take = [&](const std::uint32_t(&tile)[8]) {
    scan_out.line(0, {reinterpret_cast<const std::uint8_t*>(tile), 32});
    PixelRun run;
    bool any = false;
    while (scan_out.next(run)) any = true;
    return any;
  };
  take(before);
  return take(after);
}

TEST(ScanOutHash, SeesEveryFlatColourAndEveryPairOfBits) {
  Columns lines[2];
  std::uint32_t hashes[2];
  ScanOut scan_out({{16, 2}, ScanPolicy::tiles, lines, hashes});
  std::uint32_t before[8], after[8];
  const auto fill = [](std::uint32_t(&tile)[8], std::uint32_t pixel) {
    for (std::uint32_t& word : tile) word = pixel << 16 | pixel;
  };
  for (std::uint32_t pixel = 1; pixel < 65536; ++pixel) {
    fill(before, 0);
    fill(after, pixel);
    ASSERT_TRUE(sees(scan_out, before, after)) << pixel;
    fill(before, pixel ^ 0x8410u);
    ASSERT_TRUE(sees(scan_out, before, after)) << pixel;
  }
  oracle::Random random(5);
  for (std::uint32_t a = 0; a < 256; ++a) {
    for (std::uint32_t b = a; b < 256; ++b) {
      for (std::uint32_t i = 0; i < 8; ++i) before[i] = after[i] = static_cast<std::uint32_t>(random.next());
      after[a / 32] ^= 1u << a % 32;
      if (b != a) after[b / 32] ^= 1u << b % 32;
      ASSERT_TRUE(sees(scan_out, before, after)) << a << " " << b;
    }
  }
}

}  // namespace
}  // namespace spanline
