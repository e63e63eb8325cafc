// What every driver is, whatever its controller.
#pragma once

#include <cstdint>

#include "core/base/pixel_format.hpp"
#include "hal/panel/panel_link.hpp"

namespace spanline::hal {

// A panel as its user sees it, rotated.
struct PanelShape {
  PixelFormat format;
  std::uint16_t width, height;  // px
  std::uint32_t max_clock_hz;
  bool round = false;
};

template <typename Wiring, Arguments kArguments, PanelShape kShape>
class PanelBase {
 public:
  static constexpr PixelFormat kFormat = kShape.format;
  static constexpr std::uint16_t kWidth = kShape.width, kHeight = kShape.height;
  static constexpr std::uint32_t kLineBytes = bytes_per_line(kFormat, kWidth);
  static constexpr std::uint32_t kMaxClockHz = kShape.max_clock_hz;
  static constexpr bool kRound = kShape.round;  // only the inscribed circle is seen

  static constexpr std::uint16_t width() { return kWidth; }
  static constexpr std::uint16_t height() { return kHeight; }
  static constexpr Window all() { return {0, 0, kWidth, kHeight}; }

  // Hz that the bus reached in begin(), at most kMaxClockHz; 0 before.
  std::uint32_t clock_hz() const { return link_.clock_hz(); }

  // Ends the line in flight; after the window's last one the panel is deselected.
  Fault wait() {
    const Fault fault = link_.finish();
    if (fault != Fault::none) lines_.close();
    if (lines_.left() == 0) link_.release();
    return fault;
  }

  // Ends the line in flight and the window, however many lines it still expects; the panel is deselected.
  Fault finish() {
    const Fault fault = wait();
    lines_.close();
    link_.release();
    return fault;
  }

 protected:
  constexpr explicit PanelBase(const Wiring& wires) : link_(wires) {}

  // Ends what is in flight and closes the window; bad_window where the next one does not lie on the panel.
  Fault close_for(const Window& next) {
    lines_.close();
    const Fault fault = link_.finish();
    if (fault != Fault::none) return fault;
    const bool inside =
        next.left < next.right && next.right <= kWidth && next.top < next.bottom && next.bottom <= kHeight;
    return inside ? Fault::none : Fault::bad_window;
  }

  void expect_lines_of(const Window& window) {
    lines_.expect(window.height(), bytes_per_line(kFormat, window.width()));
  }

  // Starts data once what is in flight has ended; a fault closes the window.
  Fault start(Slice<const std::uint8_t> bytes) {
    const Fault fault = link_.start(bytes);
    if (fault != Fault::none) lines_.close();
    return fault;
  }

  PanelLink<Wiring, kArguments> link_;
  ExpectedLines lines_;
};

}  // namespace spanline::hal
