// SSD1306: one bit a pixel, in pages of eight rows.
#pragma once

#include <cstdint>

#include "hal/panel/ssd.hpp"

namespace spanline::hal {

inline constexpr std::uint8_t kSsd1306Init[] = {
    0xD5, 1, 0x80,  // clock
    0xD3, 1, 0x00,  // display offset
    0x40, 0,        // start line
    0x8D, 1, 0x14,  // charge pump on
    0x20, 1, 0x00,  // addresses run along the page, then down
    0xDA, 1, 0x12,  // row drivers alternate
    0x81, 1, 0xCF,  // contrast
    0xD9, 1, 0xF1,  // pre-charge
    0xDB, 1, 0x40,  // VCOMH
    0x2E, 0,        // no scrolling
    0xA4, 0,        // memory is shown
};

// What SsdTraits::upright holds for this controller.
inline constexpr unsigned kMirrorSegments = 0x01, kMirrorRows = 0x08;

// The usual 128x64 module. A clock cycle is to last 100 ns.
inline constexpr SsdTraits kSsd1306 = {.init = kSsd1306Init,
                                       .ram_height = 64,
                                       .glass_width = 128,
                                       .glass_height = 64,
                                       .clock_hz = 10'000'000,
                                       .upright = kMirrorSegments | kMirrorRows};

template <const SsdTraits& kTraits, Rotation kRotation, typename Wiring>
requires HalfTurn<kRotation>
class SsdPagePanel : public SsdBase<kTraits, PixelFormat::mono1, Wiring> {
  using Base = SsdBase<kTraits, PixelFormat::mono1, Wiring>;
  using Base::lines_;
  static_assert(kTraits.glass_height % 8 == 0);

 public:
  constexpr explicit SsdPagePanel(const Wiring& wires) : Base(wires) {}

  // The smallest window around `window` that open() accepts: whole pages.
  static constexpr Window snap(const Window& window) {
    return {window.left, snap_down(window.top, kPageRows), window.right, snap_up(window.bottom, kPageRows)};
  }

  // Resets and initialises the controller and switches the display on. What it shows until the first lines are sent is
  // whatever its memory holds.
  Fault begin() { return Base::begin_with(kGeometry); }

  // bad_window where `window` is empty, larger than the panel or not of whole pages.
  Fault open(const Window& window) {
    Fault fault = Base::close_for(window);
    if (fault != Fault::none) return fault;
    if (window.top % kPageRows != 0 || window.bottom % kPageRows != 0) return Fault::bad_window;
    fault = Base::address(0x21, window.left, window.right - 1);
    if (fault == Fault::none) fault = Base::address(0x22, window.top / 8, window.bottom / 8 - 1);
    if (fault == Fault::none) Base::expect_lines_of(window);
    columns_ = window.width();
    return fault;
  }

  // Takes the next line of the window; every eighth starts the transfer of its page, which the first line of the next
  // one ends. bad_window where none is open or the line does not have the window's width.
  Fault send(Slice<const std::uint8_t> line) {
    if (!lines_.take(line)) return Fault::bad_window;
    const Fault fault = Base::link_.finish();  // the page in flight is the very one that is gathered into
    if (fault != Fault::none) {
      lines_.close();
      return fault;
    }
    gather(line);
    return lines_.left() % kPageRows == 0 ? Base::start({page_, columns_}) : Fault::none;
  }

 private:
  static constexpr unsigned kPageRows = 8;
  static constexpr unsigned kMirrors =
      kTraits.upright ^ (kRotation == Rotation::r180 ? kMirrorSegments | kMirrorRows : 0u);
  // clang-format off
  static constexpr std::uint8_t kGeometry[] = {
      0xA8, 1, static_cast<std::uint8_t>(kTraits.glass_height - 1),  // rows driven
      0xA0 | (kMirrors & kMirrorSegments), 0,
      0xC0 | (kMirrors & kMirrorRows), 0,
      kTraits.inverted ? std::uint8_t{0xA7} : std::uint8_t{0xA6}, 0,
  };
  // clang-format on

  // A page byte is a column, its top row in bit 0: lines are shifted in from above, so that the first of eight ends
  // there.
  void gather(Slice<const std::uint8_t> line) {
    for (std::uint32_t x = 0; x < columns_; ++x) {
      const unsigned bit = std::uint32_t{line[x / 8]} >> (7 - x % 8) & 1u;
      page_[x] = static_cast<std::uint8_t>(page_[x] >> 1 | bit << 7);
    }
  }

  std::uint32_t columns_ = 0;
  std::uint8_t page_[kTraits.glass_width] = {};
};

template <Rotation kRotation, typename Wiring>
using Ssd1306 = SsdPagePanel<kSsd1306, kRotation, Wiring>;

}  // namespace spanline::hal
