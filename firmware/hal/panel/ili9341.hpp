#pragma once

#include "hal/panel/dcs.hpp"

namespace spanline::hal {

// Power and gamma values as the modules' makers give them; everything else is the controller's reset state.
inline constexpr std::uint8_t kIli9341Init[] = {
    0xCF, 3,  0x00, 0xC1, 0x30,              // power control B
    0xED, 4,  0x64, 0x03, 0x12, 0x81,        // power on sequence
    0xE8, 3,  0x85, 0x00, 0x78,              // driver timing A
    0xCB, 5,  0x39, 0x2C, 0x00, 0x34, 0x02,  // power control A
    0xF7, 1,  0x20,                          // pump ratio
    0xEA, 2,  0x00, 0x00,                    // driver timing B
    0xC0, 1,  0x23,                          // power control 1: 4.60 V
    0xC1, 1,  0x10,                          // power control 2
    0xC5, 2,  0x3E, 0x28,                    // VCOM 1
    0xC7, 1,  0x86,                          // VCOM 2
    0xB1, 2,  0x00, 0x18,                    // frame rate: 79 Hz
    0xB6, 3,  0x08, 0x82, 0x27,              // display function: no source or gate reversal, 320 lines
    0xF2, 1,  0x00,                          // three-gamma off
    0x26, 1,  0x01,                          // gamma curve 1
    0xE0, 15, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00,  // gamma +
    0xE1, 15, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F,  // gamma -
};

// The data sheet promises a write cycle of 100 ns (10 MHz); modules are commonly run at four times that.
inline constexpr DcsTraits kIli9341 = {.init = kIli9341Init,
                                       .ram_width = 240,
                                       .ram_height = 320,
                                       .glass_width = 240,
                                       .glass_height = 320,
                                       .clock_hz = 40'000'000,
                                       .read_hz = 6'600'000,
                                       .upright = kMirrorX,
                                       .bgr = true};

template <Rotation kRotation, typename Wiring>
using Ili9341 = DcsPanel<kIli9341, kRotation, Wiring>;

}  // namespace spanline::hal
