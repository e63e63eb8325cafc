#pragma once

#include "hal/panel/dcs.hpp"

namespace spanline::hal {

inline constexpr std::uint8_t kSt7789Init[] = {
    0xB2, 5,  0x0C, 0x0C, 0x00, 0x33, 0x33,  // porches
    0xB7, 1,  0x35,                          // gate voltages 13.26 V, -10.43 V
    0xBB, 1,  0x19,                          // VCOM 0.725 V
    0xC0, 1,  0x2C,                          // LCM control
    0xC2, 1,  0x01,                          // VDV and VRH from here
    0xC3, 1,  0x12,                          // VRH 4.45 V
    0xC4, 1,  0x20,                          // VDV 0 V
    0xC6, 1,  0x0F,                          // frame rate: 60 Hz
    0xD0, 2,  0xA4, 0xA1,                    // power control 1
    0xE0, 14, 0xD0, 0x04, 0x0D, 0x11, 0x13, 0x2B, 0x3F, 0x54, 0x4C, 0x18, 0x0D, 0x0B, 0x1F, 0x23,  // gamma +
    0xE1, 14, 0xD0, 0x04, 0x0C, 0x11, 0x13, 0x2C, 0x3F, 0x44, 0x51, 0x2F, 0x1F, 0x1F, 0x20, 0x23,  // gamma -
};

// IPS glass: inverted. The data sheet promises a write cycle of 16 ns. Glass whose chip select is tied low on the
// module needs SPI mode 3: copy the traits and set spi_mode.
inline constexpr DcsTraits kSt7789 = {.init = kSt7789Init,
                                      .ram_width = 240,
                                      .ram_height = 320,
                                      .glass_width = 240,
                                      .glass_height = 320,
                                      .clock_hz = 62'500'000,
                                      .inverted = true};

inline constexpr DcsTraits kSt7789Square = [] {
  DcsTraits traits = kSt7789;
  traits.glass_height = 240;
  return traits;
}();

inline constexpr DcsTraits kSt7789Narrow = [] {
  DcsTraits traits = kSt7789;
  traits.glass_width = 135;
  traits.glass_height = 240;
  traits.glass_left = 52;
  traits.glass_top = 40;
  return traits;
}();

template <Rotation kRotation, typename Wiring>
using St7789 = DcsPanel<kSt7789, kRotation, Wiring>;

template <Rotation kRotation, typename Wiring>
using St7789Square = DcsPanel<kSt7789Square, kRotation, Wiring>;

template <Rotation kRotation, typename Wiring>
using St7789Narrow = DcsPanel<kSt7789Narrow, kRotation, Wiring>;

}  // namespace spanline::hal
