// MIPI DCS colour controllers behind a four-wire SPI: ILI9341, ST7789, GC9A01, ILI9488, ST7796. Traits say what
// differs.
#pragma once

#include <cstdint>
#include <type_traits>

#include "hal/panel/panel_base.hpp"
#include "hal/panel/widener.hpp"

namespace spanline::hal {

// Pixels on the wire. Lines are rgb565 in either case.
enum class DcsPixel : std::uint8_t { rgb565, rgb666 };

// MADCTL (36h).
inline constexpr unsigned kMirrorY = 0x80, kMirrorX = 0x40, kSwapXY = 0x20, kBgr = 0x08;

// A controller on its glass. All sizes in pixels of the controller's memory, before any rotation.
struct DcsTraits {
  Slice<const std::uint8_t> init;               // what only this controller needs, after reset
  std::uint16_t ram_width, ram_height;          // the controller's memory
  std::uint16_t glass_width, glass_height;      // the part of it that is seen
  std::uint16_t glass_left = 0, glass_top = 0;  // where that part begins
  std::uint32_t clock_hz;                       // what the driver asks the bus for, at most
  std::uint32_t read_hz = 0;                    // at most, for what it answers; 0: modules do not wire its output
  std::uint8_t spi_mode = 0;                    // 3 for glass without chip select, mostly
  std::uint8_t upright = 0;                     // the mirror bits of rotation 0
  bool bgr = false;                             // the glass's subpixels are blue, green, red
  bool inverted = false;                        // the glass needs INVON for true colours
  bool round = false;                           // only the inscribed circle is seen
  DcsPixel pixel = DcsPixel::rgb565;
};

// MADCTL of a rotation. r90: the picture's x axis points down the upright glass, so memory column = glass column of y
// from the right, memory row = x; the mirror bits act on memory columns and rows, not on the swapped address counters.
constexpr std::uint8_t madctl(const DcsTraits& traits, Rotation rotation) {
  unsigned bits = traits.upright & (kMirrorX | kMirrorY);
  if (rotation == Rotation::r90) bits ^= kSwapXY | kMirrorX;
  if (rotation == Rotation::r180) bits ^= kMirrorX | kMirrorY;
  if (rotation == Rotation::r270) bits ^= kSwapXY | kMirrorY;
  return static_cast<std::uint8_t>(bits | (traits.bgr ? kBgr : 0u));
}

struct Origin {
  std::uint16_t column, row;
  friend constexpr bool operator==(const Origin&, const Origin&) = default;
};

// The address of the top left pixel of the rotated picture: where the glass is smaller than the memory, a mirrored axis
// counts from the other end.
constexpr Origin origin(const DcsTraits& traits, Rotation rotation) {
  const std::uint8_t bits = madctl(traits, rotation);
  const int column =
      bits & kMirrorX ? traits.ram_width - traits.glass_left - traits.glass_width : int{traits.glass_left};
  const int row = bits & kMirrorY ? traits.ram_height - traits.glass_top - traits.glass_height : int{traits.glass_top};
  const bool swapped = (bits & kSwapXY) != 0;
  return {static_cast<std::uint16_t>(swapped ? row : column), static_cast<std::uint16_t>(swapped ? column : row)};
}

constexpr bool fits_memory(const DcsTraits& traits) {
  return traits.glass_width != 0 && traits.glass_height != 0 &&
         traits.glass_left + traits.glass_width <= traits.ram_width &&
         traits.glass_top + traits.glass_height <= traits.ram_height;
}

// The bus can be put into the SPI mode that the panel needs.
template <typename Wiring, std::uint8_t kMode>
concept OffersSpiMode = kMode == 0 || SpiModes<typename Wiring::Bus>;

constexpr PanelShape shape(const DcsTraits& traits, Rotation rotation) {
  const bool swapped = (madctl(traits, rotation) & kSwapXY) != 0;
  return {PixelFormat::rgb565, swapped ? traits.glass_height : traits.glass_width,
          swapped ? traits.glass_width : traits.glass_height, traits.clock_hz, traits.round};
}

template <const DcsTraits& kTraits, Rotation kRotation, typename Wiring>
requires OffersSpiMode<Wiring, kTraits.spi_mode>
class DcsPanel : public PanelBase<Wiring, Arguments::as_data, shape(kTraits, kRotation)> {
  using Base = PanelBase<Wiring, Arguments::as_data, shape(kTraits, kRotation)>;
  using Base::lines_;
  using Base::link_;
  static_assert(well_formed(kTraits.init) && fits_memory(kTraits));

 public:
  constexpr explicit DcsPanel(const Wiring& wires) : Base(wires) {}

  static constexpr std::uint8_t kWindowBytes = 11;  // that open() sends

  // The smallest window around `window` that open() accepts: itself.
  static constexpr Window snap(const Window& window) { return window; }

  // Resets and initialises the controller and switches the display on: about a quarter of a second. What the glass
  // shows until the first lines are sent is whatever its memory holds. panel_absent where the bus can read and the
  // controller does not say that it is awake and on.
  Fault begin() {
    lines_.close();
    link_.begin(kTraits.clock_hz, kTraits.spi_mode, kAfterResetUs);
    Fault fault = Fault::none;
    if constexpr (!Wiring::kHasReset) fault = link_.run(kSoftReset);
    if (fault == Fault::none) fault = link_.run(kTraits.init);
    if (fault == Fault::none) fault = link_.run(kSwitchOn);
    if (fault == Fault::none) fault = find();
    return fault;
  }

  // bad_window where `window` is empty or larger than the panel.
  Fault open(const Window& window) {
    Fault fault = Base::close_for(window);
    if (fault != Fault::none) return fault;
    fault = address(0x2A, window.left + kOrigin.column, window.right + kOrigin.column);
    if (fault == Fault::none) fault = address(0x2B, window.top + kOrigin.row, window.bottom + kOrigin.row);
    if (fault == Fault::none) fault = link_.command(0x2C, {});
    if (fault == Fault::none) Base::expect_lines_of(window);
    return fault;
  }

  // Starts the next line of the window once the line before has ended. bad_window where none is open or the line does
  // not have the window's width. Lines of an 18-bit panel are widened chunk by chunk meanwhile: only the last chunk is
  // in flight then.
  Fault send(Slice<const std::uint8_t> line) {
    if (!lines_.take(line)) return Fault::bad_window;
    if constexpr (kTraits.pixel == DcsPixel::rgb666) {
      Fault fault = Fault::none;
      for (std::uint32_t at = 0; fault == Fault::none && at < line.size(); at += Widener::kLineBytes) {
        fault = Base::start(widener_.widen(line, at));
      }
      return fault;
    }
    return Base::start(line);
  }

 private:
  // SLPOUT is allowed 120 ms after a reset at the earliest.
  static constexpr std::uint32_t kAfterResetUs = 120'000;
  static constexpr std::uint8_t kSoftReset[] = {0x01, 0 | kDelay, 120};

  static constexpr Origin kOrigin = origin(kTraits, kRotation);
  // clang-format off
  static constexpr std::uint8_t kSwitchOn[] = {
      0x3A, 1, kTraits.pixel == DcsPixel::rgb666 ? std::uint8_t{0x66} : std::uint8_t{0x55},  // COLMOD
      0x36, 1, madctl(kTraits, kRotation),                                                   // MADCTL
      kTraits.inverted ? std::uint8_t{0x21} : std::uint8_t{0x20}, 0,                         // INVON, INVOFF
      0x13, 0,                                                                               // NORON
      0x11, 0 | kDelay, 120,  // SLPOUT, and until its supplies are up
      0x29, 0 | kDelay, 20,   // DISPON
  };
  // clang-format on

  struct Nothing {};

  // RDDPM: a line that nobody drives reads as all ones or all zeros, and is neither.
  Fault find() {
    if constexpr (SpiReads<typename Wiring::Bus> && kTraits.read_hz != 0) {
      constexpr unsigned kAwake = 0x10, kOn = 0x04, kAlwaysZero = 0x03;
      std::uint8_t mode = 0;
      const Fault fault = link_.ask(0x0A, kTraits.read_hz, mode);
      if (fault != Fault::none) return fault;
      if ((mode & (kAwake | kOn | kAlwaysZero)) != (kAwake | kOn)) return Fault::panel_absent;
    }
    return Fault::none;
  }

  // CASET, PASET: both ends inclusive, high byte first.
  Fault address(std::uint8_t code, int begin, int end) {
    const int last = end - 1;
    const std::uint8_t ends[] = {static_cast<std::uint8_t>(begin >> 8), static_cast<std::uint8_t>(begin),
                                 static_cast<std::uint8_t>(last >> 8), static_cast<std::uint8_t>(last)};
    return link_.command(code, ends);
  }

  [[no_unique_address]] std::conditional_t<kTraits.pixel == DcsPixel::rgb666, Widener, Nothing> widener_;
};

}  // namespace spanline::hal
