#pragma once

#include "hal/panel/dcs.hpp"

namespace spanline::hal {

inline constexpr std::uint8_t kIli9488Init[] = {
    0xE0, 15, 0x00, 0x03, 0x09, 0x08, 0x16, 0x0A, 0x3F, 0x78, 0x4C, 0x09, 0x0A, 0x08, 0x16, 0x1A, 0x0F,  // gamma +
    0xE1, 15, 0x00, 0x16, 0x19, 0x03, 0x0F, 0x05, 0x32, 0x45, 0x46, 0x04, 0x0E, 0x0D, 0x35, 0x37, 0x0F,  // gamma -
    0xC0, 2,  0x17, 0x15,              // power control 1
    0xC1, 1,  0x41,                    // power control 2
    0xC5, 3,  0x00, 0x12, 0x80,        // VCOM
    0xB0, 1,  0x00,                    // interface: SDO in use
    0xB1, 1,  0xA0,                    // frame rate: 60 Hz
    0xB4, 1,  0x02,                    // two-dot inversion
    0xB6, 3,  0x02, 0x02, 0x3B,        // display function: no source or gate reversal, 480 lines
    0xB7, 1,  0xC6,                    // entry mode
    0xF7, 4,  0xA9, 0x51, 0x2C, 0x82,  // adjust control 3
};

// Over SPI the controller takes 18-bit colour only. Promised are 50 ns a write cycle (20 MHz), common are 40 MHz.
inline constexpr DcsTraits kIli9488 = {.init = kIli9488Init,
                                       .ram_width = 320,
                                       .ram_height = 480,
                                       .glass_width = 320,
                                       .glass_height = 480,
                                       .clock_hz = 40'000'000,
                                       .read_hz = 6'600'000,
                                       .upright = kMirrorX,
                                       .bgr = true,
                                       .pixel = DcsPixel::rgb666};

template <Rotation kRotation, typename Wiring>
using Ili9488 = DcsPanel<kIli9488, kRotation, Wiring>;

}  // namespace spanline::hal
