#include "core/shade/painter.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace spanline {
namespace {

constexpr BackgroundRecord kBlack{{0, 0, 0}, {0, 0, 0}};

VisibleSpan run(std::uint16_t left, std::uint16_t right, std::uint16_t payload) {
  VisibleSpan span;
  span.left = left;
  span.right = right;
  span.face = payload == 0 ? kNoFace : std::uint16_t{1};
  span.payload = payload;
  return span;
}

struct Line {
  alignas(4) std::uint8_t bytes[96];
  Line() {
    for (std::uint8_t& b : bytes) b = 0xa5;
  }
};

// Every way to cut a line of 9 pixels in three: the fills meet without gap or overlap, and nothing is written past the
// line.
TEST(Painter, FillsRgb565WithoutGaps) {
  const Screen screen{9, 1, PixelFormat::rgb565};
  for (std::uint16_t a = 0; a <= 9; ++a) {
    for (std::uint16_t b = a; b <= 9; ++b) {
      Line line;
      Painter painter(screen);
      painter.begin_lines(kBlack);
      painter.begin_line(0, line.bytes);
      if (a > 0) painter.span(run(0, a, 0x1111));
      if (b > a) painter.span(run(a, b, 0x2222));
      if (9 > b) painter.span(run(b, 9, 0x3333));
      for (unsigned x = 0; x < 9; ++x) {
        const std::uint8_t expected = x < a ? 0x11 : x < b ? 0x22 : 0x33;
        EXPECT_EQ(line.bytes[2 * x], expected);
        EXPECT_EQ(line.bytes[2 * x + 1], expected);
      }
      EXPECT_EQ(line.bytes[18], 0xa5);
    }
  }
}

// Pixels that share a byte with others end up as if each had been painted alone.
TEST(Painter, PacksGreyPixelsOfAllCuts) {
  for (const PixelFormat format : {PixelFormat::grey8, PixelFormat::grey4, PixelFormat::mono1}) {
    const Screen screen{21, 1, format};
    for (std::uint16_t cut = 1; cut < 21; ++cut) {
      Line line;
      Painter painter(screen);
      painter.begin_lines(kBlack);
      painter.begin_line(0, line.bytes);
      painter.span(run(0, cut, 90));
      painter.span(run(cut, 21, 200));
      for (unsigned x = 0; x < 21; ++x) {
        const unsigned grey = x < cut ? 90 : 200;
        if (format == PixelFormat::grey8) {
          EXPECT_EQ(line.bytes[x], grey);
        } else if (format == PixelFormat::grey4) {
          EXPECT_EQ((unsigned{line.bytes[x / 2]} >> (x % 2 == 0 ? 4 : 0)) & 15u, dither_grey4(grey, x, 0));
        } else {
          EXPECT_EQ((unsigned{line.bytes[x / 8]} >> (7 - x % 8)) & 1u, dither_mono(grey, x, 0));
        }
      }
      EXPECT_EQ(line.bytes[bytes_per_line(format, 21)], 0xa5);
    }
  }
}

TEST(Painter, BackgroundRunsFromTopToBottom) {
  const Screen screen{1, 5, PixelFormat::grey8};
  const BackgroundRecord gradient{{0, 0, 0}, {200, 200, 200}};
  const unsigned expected[] = {0, 50, 100, 150, 200};
  for (std::uint16_t y = 0; y < 5; ++y) {
    Line line;
    Painter painter(screen);
    painter.begin_lines(gradient);
    painter.begin_line(y, line.bytes);
    painter.span(run(0, 1, 0));
    EXPECT_EQ(line.bytes[0], expected[y]);
  }
}

}  // namespace
}  // namespace spanline
