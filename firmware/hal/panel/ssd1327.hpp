#pragma once

#include "hal/panel/ssd_grey.hpp"

namespace spanline::hal {

inline constexpr std::uint8_t kSsd1327Init[] = {
    0xFD, 1, 0x12,  // commands unlocked
    0xAB, 1, 0x01,  // internal regulator
    0x81, 1, 0x80,  // contrast
    0xB1, 1, 0x51,  // phases
    0xB3, 1, 0x01,  // clock
    0xB9, 0,        // grey levels, linear
    0xBC, 1, 0x08,  // pre-charge
    0xBE, 1, 0x07,  // VCOMH
    0xB6, 1, 0x01,  // second pre-charge
    0xD5, 1, 0x62,  // second pre-charge on
};

// 128x128 glass with column driver 127 at its left. A clock cycle is to last 100 ns.
inline constexpr SsdTraits kSsd1327 = {.init = kSsd1327Init,
                                       .ram_height = 128,
                                       .glass_width = 128,
                                       .glass_height = 128,
                                       .clock_hz = 10'000'000,
                                       .upright = kRemapSplit | kRemapRows | kRemapColumns};

template <Rotation kRotation, typename Wiring>
using Ssd1327 = SsdGreyPanel<kSsd1327, kRotation, Wiring>;

}  // namespace spanline::hal
