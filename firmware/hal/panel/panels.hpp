// Every panel driver, and how a board's main uses one:
//
//   #include "hal/panel/panels.hpp"
//
//   using Wiring = hal::Wires<Spi, DcPin, CsPin, ResetPin, Timer>;             // what the board has
//   using Panel = hal::Ili9341<hal::Rotation::r90, Wiring>;                    // controller, glass and rotation:
//   compile time static_assert(Panel::kFormat == PixelFormat::rgb565);                      // what the engine must
//   render
//
//   Panel panel{Wiring{spi, DcPin{}, CsPin{}, ResetPin{}, timer}};             // bus and clock by reference, pins by
//   value if (Fault f = panel.begin(); f != Fault::none) report(name(f));           // resets, initialises, display on
//   // panel.clock_hz(): what the bus reached of Panel::kMaxClockHz
//   if (Fault f = panel.open(panel.all()); f != Fault::none) …                 // or any window; Panel::snap() widens
//   one for each line of the window, top to bottom:                                //   to what the controller can
//   address
//     render into lines.back();                                                // Panel::kLineBytes for a full-width
//     line if (Fault f = panel.send(lines.back()); f != Fault::none) …              // waits for the line before,
//     starts this one lines.swap();                                                            // a line in flight must
//     stay untouched
//   if (Fault f = panel.wait(); f != Fault::none) …                            // the last line is on the glass
//
// A pin that is not there is hal::NoPin (chip select tied low; no reset line: DCS controllers are then reset by
// command). A panel whose traits ask for SPI mode 3 needs a bus with set_mode(std::uint8_t) (concept SpiModes) and
// refuses any other at compile time, as the SSD controllers refuse a quarter turn. After a fault the window is closed:
// open() again, or begin(). SSD1306 and the 4-bit SSD controllers take lines of PixelFormat::mono1 and grey4; their
// windows snap to 8 rows and to even columns. ILI9488 takes rgb565 lines and widens them in chunks, so that its send()
// returns with the last chunk in flight.
//
// Drivers: Ili9341, St7789 (240x320), St7789Square (240x240), St7789Narrow (135x240), Gc9a01 (round 240x240),
// Ili9488 and St7796 (320x480; r90 for 480x320), Ssd0323 and Ssd1325 (128x64), Ssd1327 (128x128), Ssd1306 (128x64).
// A glass of its own: copy the traits, change fields, name the driver: hal::DcsPanel<kMyTraits, hal::Rotation::r0,
// Wiring>.
#pragma once

#include "hal/panel/gc9a01.hpp"
#include "hal/panel/ili9341.hpp"
#include "hal/panel/ili9488.hpp"
#include "hal/panel/ssd0323.hpp"
#include "hal/panel/ssd1306.hpp"
#include "hal/panel/ssd1327.hpp"
#include "hal/panel/st7789.hpp"
#include "hal/panel/st7796.hpp"
