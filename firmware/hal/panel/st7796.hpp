#pragma once

#include "hal/panel/dcs.hpp"

namespace spanline::hal {

inline constexpr std::uint8_t kSt7796Init[] = {
    0xF0, 1,  0xC3,                                            // command set 2, part I, unlocked
    0xF0, 1,  0x96,                                            // part II unlocked
    0xB4, 1,  0x01,                                            // one-dot inversion
    0xB6, 3,  0x80, 0x02, 0x3B,                                // display function: no reversal, 480 lines
    0xE8, 8,  0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33,  // output timing
    0xC1, 1,  0x06,                                            // power control 2
    0xC2, 1,  0xA7,                                            // power control 3
    0xC5, 1,  0x18,                                            // VCOM 0.9 V
    0xE0, 14, 0xF0, 0x09, 0x0B, 0x06, 0x04, 0x15, 0x2F, 0x54, 0x42, 0x3C, 0x17, 0x14, 0x18, 0x1B,  // gamma +
    0xE1, 14, 0xE0, 0x09, 0x0B, 0x06, 0x04, 0x03, 0x2B, 0x43, 0x42, 0x3B, 0x16, 0x14, 0x17, 0x1B,  // gamma -
    0xF0, 1,  0x3C,                                                                                // part I locked
    0xF0, 1,  0x69,                                                                                // part II locked
};

// The data sheet promises a write cycle of 15 ns.
inline constexpr DcsTraits kSt7796 = {.init = kSt7796Init,
                                      .ram_width = 320,
                                      .ram_height = 480,
                                      .glass_width = 320,
                                      .glass_height = 480,
                                      .clock_hz = 62'500'000,
                                      .read_hz = 6'600'000,
                                      .upright = kMirrorX,
                                      .bgr = true};

template <Rotation kRotation, typename Wiring>
using St7796 = DcsPanel<kSt7796, kRotation, Wiring>;

}  // namespace spanline::hal
