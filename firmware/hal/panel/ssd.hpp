// What the drivers of the Solomon Systech OLED controllers share.
#pragma once

#include <cstdint>

#include "hal/panel/panel_base.hpp"

namespace spanline::hal {

// These controllers can mirror both axes, which is half a turn; they cannot swap rows and columns.
template <Rotation kRotation>
concept HalfTurn = kRotation == Rotation::r0 || kRotation == Rotation::r180;

// A controller on its glass.
struct SsdTraits {
  Slice<const std::uint8_t> init;           // what only this glass needs, display off
  std::uint16_t ram_height;                 // rows of the controller's memory
  std::uint16_t glass_width, glass_height;  // px
  std::uint16_t first_row = 0;              // the row driver (COM) of the glass's last line, or first, see upright
  std::uint32_t clock_hz;                   // the data sheet's limit
  std::uint8_t upright;                     // the remap bits of rotation 0
  bool inverted = false;
  bool closing_nop = false;  // latches a byte only with the next one: a NOP ends every window
};

template <const SsdTraits& kTraits, PixelFormat kLines, typename Wiring>
class SsdBase : public PanelBase<Wiring, Arguments::as_commands,
                                 PanelShape{kLines, kTraits.glass_width, kTraits.glass_height, kTraits.clock_hz}> {
  using Base = PanelBase<Wiring, Arguments::as_commands,
                         PanelShape{kLines, kTraits.glass_width, kTraits.glass_height, kTraits.clock_hz}>;
  static_assert(well_formed(kTraits.init));

 public:
  static constexpr std::uint8_t kWindowBytes = 6;  // that open() sends

 protected:
  constexpr explicit SsdBase(const Wiring& wires) : Base(wires) {}

  // Resets the controller, runs its table and the driver's, and switches the display on.
  Fault begin_with(Slice<const std::uint8_t> geometry) {
    Base::lines_.close();
    Base::link_.begin(kTraits.clock_hz, 0, kAfterResetUs);
    Fault fault = Base::link_.run(kOff);
    if (fault == Fault::none) fault = Base::link_.run(kTraits.init);
    if (fault == Fault::none) fault = Base::link_.run(geometry);
    if (fault == Fault::none) fault = Base::link_.run(kOn);
    return fault;
  }

  // Both ends inclusive.
  Fault address(std::uint8_t code, int first, int last) {
    const std::uint8_t ends[] = {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(last)};
    return Base::link_.command(code, ends);
  }

 private:
  static constexpr std::uint32_t kAfterResetUs = 1000;
  static constexpr std::uint8_t kOff[] = {0xAE, 0};
  static constexpr std::uint8_t kOn[] = {0xAF, 0 | kDelay, 100};  // until the columns' supply is up
};

}  // namespace spanline::hal
