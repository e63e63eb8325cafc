// Every panel driver, and how a board's main uses one:
//
//   using Wiring = hal::Wires<Spi, DcPin, CsPin, ResetPin, Timer>;  // what the board has
//   using Panel = hal::Ili9341<hal::Rotation::r90, Wiring>;         // controller, glass and rotation: at compile time
//   static_assert(Panel::kFormat == PixelFormat::rgb565);           // what the engine must render
//
//   Panel panel{Wiring{spi, DcPin{}, CsPin{}, ResetPin{}, timer}};  // bus and clock are referred to, pins copied
//   check(panel.begin());                                           // each call returns a Fault
//   report(Panel::kMaxClockHz, panel.clock_hz());                   // what was asked of the bus, what it reached
//   check(panel.open(panel.all()));                                 // or any window that Panel::snap() leaves as it is
//   for each line of the window, from the top:
//     render(lines.back());                                         // Panel::kLineBytes for one of the full width
//     check(panel.send(lines.back()));                              // ends the line before, starts this one
//     lines.swap();                                                 // a line in flight must stay untouched
//   check(panel.wait());                                            // the last line is on the glass
//
// A pin that is not there is a hal::NoPin: chip select tied low; no reset line (DCS controllers are then reset by a
// command). A panel whose traits ask for SPI mode 3 needs a bus with set_mode() (SpiModes) and refuses any other at
// compile time, as the SSD controllers refuse a quarter turn. Where the bus can read (SpiReads), begin() of ILI9341,
// ILI9488 and ST7796 finds that the panel is absent. After a fault the window is closed: open() again, or begin().
//
// SSD1306 takes lines of mono1 and snaps windows to 8 rows, the other SSD controllers take grey4 and snap them to even
// columns, all others take rgb565. ILI9488 widens its lines in chunks: send() returns with the last chunk in flight.
//
// Ili9341 240x320 · St7789 240x320, St7789Square 240x240, St7789Narrow 135x240 · Gc9a01 240x240, round · Ili9488,
// St7796 320x480 · Ssd0323, Ssd1325 128x64 · Ssd1327 128x128 · Ssd1306 128x64. Another glass: copy the traits, change
// fields, name the driver: hal::DcsPanel<kMyTraits, hal::Rotation::r0, Wiring>.
#pragma once

#include "hal/panel/gc9a01.hpp"
#include "hal/panel/ili9341.hpp"
#include "hal/panel/ili9488.hpp"
#include "hal/panel/ssd0323.hpp"
#include "hal/panel/ssd1306.hpp"
#include "hal/panel/ssd1327.hpp"
#include "hal/panel/st7789.hpp"
#include "hal/panel/st7796.hpp"
