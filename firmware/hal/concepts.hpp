// What a board offers and a panel offers, as concepts. Each has one contract test that every implementation passes on
// the host.
#pragma once

#include <concepts>
#include <cstdint>

#include "core/base/pixel_format.hpp"
#include "core/base/slice.hpp"
#include "hal/fault.hpp"

namespace spanline::hal {

// An output pin; true is the high level.
template <typename T>
concept OutPin = requires(T pin, bool level) {
  { pin.set(level) } -> std::same_as<void>;
};

// Time. delay_us waits at least that long; now_us wraps.
template <typename T>
concept Clock = requires(T clock, std::uint32_t us) {
  { clock.delay_us(us) } -> std::same_as<void>;
  { clock.now_us() } -> std::same_as<std::uint32_t>;
};

// One memory-to-peripheral channel, bytes. start() returns at once; the bytes stay untouched until done() or a fault.
// A channel that is started while busy reports dma_error.
template <typename T>
concept DmaChannel = requires(T dma, Slice<const std::uint8_t> bytes) {
  { dma.start(bytes) } -> std::same_as<Fault>;
  { dma.busy() } -> std::same_as<bool>;
  { dma.fault() } -> std::same_as<Fault>;  // of the transfer started last
};

// A master-only SPI bus, 8 bits, MSB first. set_clock asks for at most `hz` and returns what was reached. write()
// returns when the last bit has left the wire; start() begins an asynchronous transfer (by DMA where the bus has it,
// else it is done when it returns) and wait() ends it, both bounded.
template <typename T>
concept SpiBus = requires(T bus, std::uint32_t hz, Slice<const std::uint8_t> bytes) {
  { bus.set_clock(hz) } -> std::same_as<std::uint32_t>;
  { bus.write(bytes) } -> std::same_as<Fault>;
  { bus.start(bytes) } -> std::same_as<Fault>;
  { bus.wait() } -> std::same_as<Fault>;
};

// A bus whose clock polarity and phase can be chosen: SPI mode 0 to 3. A bus without set_mode is in mode 0.
template <typename T>
concept SpiModes = SpiBus<T> && requires(T bus, std::uint8_t mode) {
  { bus.set_mode(mode) } -> std::same_as<void>;
};

// A bus whose receive line is wired: read() clocks as many bytes out as `answer` holds and keeps what comes in. Only
// with it can a panel be found absent.
template <typename T>
concept SpiReads = SpiBus<T> && requires(T bus, Slice<std::uint8_t> answer) {
  { bus.read(answer) } -> std::same_as<Fault>;
};

enum class Rotation : std::uint8_t { r0, r90, r180, r270 };

// A rectangle of pixels, right and bottom exclusive, in the panel's rotated coordinates.
struct Window {
  std::uint16_t left, top, right, bottom;
  constexpr std::uint16_t width() const { return static_cast<std::uint16_t>(right - left); }
  constexpr std::uint16_t height() const { return static_cast<std::uint16_t>(bottom - top); }
};

// A display controller behind a bus. begin() resets and initialises it. open() sets the window that the lines to come
// fill, top to bottom; send() starts the transfer of one line of the window in the panel's format and returns at once,
// wait() ends it.
template <typename T>
concept Panel = requires(T panel, const Window& window, Slice<const std::uint8_t> line) {
  { T::kFormat } -> std::convertible_to<PixelFormat>;
  { panel.width() } -> std::same_as<std::uint16_t>;
  { panel.height() } -> std::same_as<std::uint16_t>;
  { panel.begin() } -> std::same_as<Fault>;
  { panel.open(window) } -> std::same_as<Fault>;
  { panel.send(line) } -> std::same_as<Fault>;
  { panel.wait() } -> std::same_as<Fault>;
};

}  // namespace spanline::hal
