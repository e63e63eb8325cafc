// Solomon Systech controllers of 16 grey levels: SSD0323, SSD1325, SSD1327.
#pragma once

#include <cstdint>

#include "hal/panel/ssd.hpp"

namespace spanline::hal {

// Bits of A0h, which is what SsdTraits::upright holds for these controllers.
inline constexpr unsigned kRemapColumns = 0x01;
inline constexpr unsigned kRemapNibbles = 0x02;  // the high nibble goes to the lower column driver
inline constexpr unsigned kRemapRows = 0x10;
inline constexpr unsigned kRemapSplit = 0x40;  // even and odd rows on either side

// Half a turn mirrors both axes and so, with its columns, the two pixels of a byte.
constexpr std::uint8_t ssd_remap(const SsdTraits& traits, Rotation rotation) {
  const unsigned turn = rotation == Rotation::r180 ? kRemapColumns | kRemapNibbles | kRemapRows : 0u;
  return static_cast<std::uint8_t>(traits.upright ^ turn);
}

// A2h. Row driver k shows memory row k + offset, or with remapped rows ram_height - 1 - k + offset; the glass hangs on
// drivers first_row and up, and its picture is to begin in memory row 0.
constexpr std::uint8_t ssd_offset(const SsdTraits& traits, Rotation rotation) {
  const int offset = ssd_remap(traits, rotation) & kRemapRows ? traits.glass_height + traits.first_row
                                                              : traits.ram_height - traits.first_row;
  return static_cast<std::uint8_t>(offset % traits.ram_height);
}

template <const SsdTraits& kTraits, Rotation kRotation, typename Wiring>
requires HalfTurn<kRotation>
class SsdGreyPanel : public SsdBase<kTraits, PixelFormat::grey4, Wiring> {
  using Base = SsdBase<kTraits, PixelFormat::grey4, Wiring>;
  using Base::lines_;
  using Base::link_;

 public:
  constexpr explicit SsdGreyPanel(const Wiring& wires) : Base(wires) {}

  // The smallest window around `window` that open() accepts: two pixels share a byte.
  static constexpr Window snap(const Window& window) {
    return {snap_down(window.left, 2), window.top, snap_up(window.right, 2), window.bottom};
  }

  // Resets and initialises the controller and switches the display on. What it shows until the first lines are sent is
  // whatever its memory holds.
  Fault begin() { return Base::begin_with(kGeometry); }

  // bad_window where `window` is empty, larger than the panel or not on even columns.
  Fault open(const Window& window) {
    Fault fault = Base::close_for(window);
    if (fault != Fault::none) return fault;
    if (window.left % 2 != 0 || window.right % 2 != 0) return Fault::bad_window;
    fault = Base::address(0x15, window.left / 2, window.right / 2 - 1);
    if (fault == Fault::none) fault = Base::address(0x75, window.top, window.bottom - 1);
    if (fault == Fault::none) Base::expect_lines_of(window);
    return fault;
  }

  // Starts the next line of the window once the line before has ended. bad_window where none is open or the line does
  // not have the window's width.
  Fault send(Slice<const std::uint8_t> line) {
    if (!lines_.take(line)) return Fault::bad_window;
    const Fault fault = Base::start(line);
    unlatched_ = fault == Fault::none;
    return fault;
  }

  // Ends the line in flight; after the window's last one the panel is deselected.
  Fault wait() {
    Fault fault = link_.finish();
    if (fault != Fault::none) lines_.close();
    if (lines_.left() != 0) return fault;
    if (kTraits.closing_nop && unlatched_ && fault == Fault::none) fault = link_.command(kNop, {});
    unlatched_ = false;
    link_.release();
    return fault;
  }

  // Ends the line in flight and the window, however many lines it still expects; the panel is deselected.
  Fault finish() {
    const Fault fault = link_.finish();
    lines_.close();
    const Fault closed = wait();
    return fault != Fault::none ? fault : closed;
  }

 private:
  // clang-format off
  static constexpr std::uint8_t kGeometry[] = {
      0xA0, 1, ssd_remap(kTraits, kRotation),
      0xA1, 1, 0x00,  // start line
      0xA2, 1, ssd_offset(kTraits, kRotation),
      0xA8, 1, static_cast<std::uint8_t>(kTraits.glass_height - 1),  // rows driven
      kTraits.inverted ? std::uint8_t{0xA7} : std::uint8_t{0xA4}, 0,
  };
  // clang-format on

  static constexpr std::uint8_t kNop = 0xE3;

  bool unlatched_ = false;  // the window's last byte so far
};

}  // namespace spanline::hal
