// The golden pictures: demos at chosen frames, sizes and formats, and the CRC-32 of all their line bytes. The host's
// test and the images for emulated cores (tests/target) draw them by this one header and expect the same numbers.
#pragma once

#include "core/frame/frame.hpp"
#include "demos/all.hpp"
#include "golden/crc32.hpp"

namespace spanline::golden {

struct Picture {
  // Framed while compiling, so that an image holds the layouts that it shows and no more.
  constexpr Picture(const char* as, const demos::Layouts& layouts, std::uint32_t at, const Screen& on,
                    std::uint32_t expected)
      : name(as), demo(layouts.framed_for(on)), frame(at), screen(on), crc(expected) {}

  const char* name;
  demos::Demo demo;
  std::uint32_t frame;
  Screen screen;
  std::uint32_t crc;
};

inline constexpr Screen kWide{320, 240, PixelFormat::rgb565}, kTall{240, 320, PixelFormat::rgb565},
    kSquare{240, 240, PixelFormat::rgb565}, kGrey{320, 240, PixelFormat::grey8}, kOled{128, 64, PixelFormat::grey4},
    kMono{128, 64, PixelFormat::mono1};

inline constexpr Picture kPictures[] = {
    {"teapot-wide-0", demos::teapot, 0, kWide, 0x0b09fa5d},
    {"teapot-oled-100", demos::teapot, 100, kOled, 0x38836b56},
    {"teapot-mono-20", demos::teapot, 20, kMono, 0x84723bc3},
    {"cubes-square-90", demos::cubes, 90, kSquare, 0x7f1227a8},
    {"cubes-grey-250", demos::cubes, 250, kGrey, 0xeb6608be},
    {"cubes-oled-200", demos::cubes, 200, kOled, 0x342ee53b},
    {"gears-oled-33", demos::gears, 33, kOled, 0xd4387eb6},
    {"gauges-wide-60", demos::gauges, 60, kWide, 0xde2bf2ed},
    {"gauges-tall-3000000", demos::gauges, 3000000, kTall, 0xb9b7e770},
    {"gauges-oled-120", demos::gauges, 120, kOled, 0xc50d227d},
    {"dice-oled-60", demos::dice, 60, kOled, 0x3c1db39e},
    {"house-oled-180", demos::house, 180, kOled, 0xcd37c41f},
    {"panes-wide-30", demos::panes, 30, kWide, 0x3450a3c7},
    {"panes-mono-0", demos::panes, 0, kMono, 0x1b620eb6},
    {"patches-oled-60", demos::patches, 60, kOled, 0x4c1215a1},
    {"patches-mono-150", demos::patches, 150, kMono, 0xaae94232},
};

// Holds every one of them, in 64 KB together with the stack; less than that many vertices are kept.
inline constexpr Budget kBudget{.width = 320,
                                .height = 320,
                                .facets = 576,
                                .vertices = 700,
                                .polygons = 80,
                                .edges = 320,
                                .segments = 80,
                                .active = 24,
                                .patch_facets = 110,
                                .patch_vertices = 244,
                                .layers = 24};
inline constexpr std::uint32_t kMostLineBytes = bytes_per_line(PixelFormat::rgb565, 320);

// Draws what is on the stage by either kind of frame.
template <typename AnyFrame>
Status draw_by(AnyFrame& frame, const Screen& screen, const demos::Stage& stage, Slice<std::uint8_t> line,
               std::uint32_t& crc) {
  Crc32 sum;
  for (Band rest{0, screen.height}; !rest.empty();) {
    const Band band = frame.prepare(stage.view(), stage.camera(), rest);
    if (band.empty()) break;
    while (frame.next_line(line)) sum.add({line.data(), frame.line_bytes()});
    rest.top = band.bottom;
  }
  crc = sum.value();
  return frame.status();
}

// Every demo by the same kind of frame, to fit the flash.
inline Status draw_stage(const FrameStorage& storage, const demos::Stage& stage, Slice<std::uint8_t> line,
                         std::uint32_t& crc) {
  Frame<FrameOptions{.patches = true, .layers = true}> frame(storage);
  return draw_by(frame, storage.screen, stage, line, crc);
}

// Puts what `picture` shows on the stage.
inline Status pose(const Picture& picture, demos::Stage& stage) {
  const Status status = stage.begin(picture.demo, picture.screen);
  if (status.ok()) stage.show(picture.frame);
  return status;
}

// Draws `picture` in the pools of `storage` line by line into `line` (kMostLineBytes, on a word boundary); `crc` is of
// all lines. Fails with the status of the stage or of the frame.
inline Status draw(const Picture& picture, FrameStorage storage, demos::Stage& stage, Slice<std::uint8_t> line,
                   std::uint32_t& crc) {
  if (const Status status = pose(picture, stage); !status.ok()) return status;
  storage.screen = picture.screen;
  return draw_stage(storage, stage, line, crc);
}

}  // namespace spanline::golden
