#pragma once

#include "hal/panel/ssd_grey.hpp"

namespace spanline::hal {

// The two controllers take the same commands. Only commands that the emulated EK-LM3S6965 knows, too: it has no B0h and
// B4h.
inline constexpr std::uint8_t kSsd0323Init[] = {
    0xB3, 1, 0x91,                                            // clock
    0xAD, 1, 0x02,                                            // no DC-DC converter
    0x86, 0,                                                  // full current
    0xB8, 8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76,  // grey levels, linear
    0x81, 1, 0x70,                                            // contrast
    0xB2, 1, 0x51,                                            // row period
    0xB1, 1, 0x55,                                            // phases
    0xBC, 1, 0x10,                                            // pre-charge
    0xBE, 1, 0x1C,                                            // VCOMH
    0xBF, 1, 0x0F,                                            // segment low
};

// OSRAM Pictiva 128x64, as on the EK-LM3S6965. A clock cycle is to last 250 ns.
inline constexpr SsdTraits kSsd0323 = {.init = kSsd0323Init,
                                       .ram_height = 80,
                                       .glass_width = 128,
                                       .glass_height = 64,
                                       .clock_hz = 4'000'000,
                                       .upright = kRemapSplit | kRemapRows | kRemapNibbles,
                                       .closing_nop = true};

// Newhaven NHD-2.7-12864: the glass hangs on the middle rows.
inline constexpr SsdTraits kSsd1325 = [] {
  SsdTraits traits = kSsd0323;
  traits.first_row = 12;
  return traits;
}();

template <Rotation kRotation, typename Wiring>
using Ssd0323 = SsdGreyPanel<kSsd0323, kRotation, Wiring>;

template <Rotation kRotation, typename Wiring>
using Ssd1325 = SsdGreyPanel<kSsd1325, kRotation, Wiring>;

}  // namespace spanline::hal
