// The wire side that all drivers share: commands, one transfer in flight, chip select, and the lines that a window
// expects.
#pragma once

#include <cstdint>

#include "hal/panel/init_table.hpp"
#include "hal/panel/wires.hpp"

namespace spanline::hal {

// How a controller takes the bytes after a command: MIPI DCS as data, the SSD family as more command bytes.
enum class Arguments : std::uint8_t { as_data, as_commands };

template <typename Wiring, Arguments kArguments>
class PanelLink {
 public:
  constexpr explicit PanelLink(const Wiring& wires) : wires_(wires) {}

  // Prepares bus and pins, and gives the reset pulse where there is a reset line.
  void begin(std::uint32_t clock_hz, std::uint8_t spi_mode, std::uint32_t after_reset_us) {
    if constexpr (SpiModes<typename Wiring::Bus>) wires_.bus.set_mode(spi_mode);
    clock_hz_ = wires_.bus.set_clock(clock_hz);
    in_flight_ = false;
    release();
    if constexpr (Wiring::kHasReset) {
      wires_.reset.set(true);
      delay_us(kResetPulseUs);
      wires_.reset.set(false);
      delay_us(kResetPulseUs);
      wires_.reset.set(true);
      delay_us(after_reset_us);
    }
  }

  // Hz that the bus reached; 0 before begin().
  std::uint32_t clock_hz() const { return clock_hz_; }

  // One command with its arguments; the panel stays selected and takes data next. Nothing may be in flight.
  Fault command(std::uint8_t code, Slice<const std::uint8_t> arguments) {
    wires_.cs.set(false);
    wires_.dc.set(false);
    Fault fault = wires_.bus.write({&code, 1});
    if (kArguments == Arguments::as_data) wires_.dc.set(true);
    if (fault == Fault::none && !arguments.empty()) fault = wires_.bus.write(arguments);
    if (kArguments == Arguments::as_commands) wires_.dc.set(true);
    if (fault != Fault::none) release();
    return fault;
  }

  // One command and the byte with which the controller answers, read at `read_hz`.
  Fault ask(std::uint8_t code, std::uint32_t read_hz, std::uint8_t& answer) requires SpiReads<typename Wiring::Bus> {
    wires_.bus.set_clock(read_hz);
    Fault fault = command(code, {});
    if (fault == Fault::none) fault = wires_.bus.read({&answer, 1});
    release();
    wires_.bus.set_clock(clock_hz_);
    return fault;
  }

  // One command by itself, and the wait after it.
  Fault step(const InitStep& step) {
    const Fault fault = command(step.command, step.arguments);
    release();
    delay_us(std::uint32_t{step.delay_ms} * 1000);
    return fault;
  }

  // All steps of a table, up to the first fault.
  Fault run(Slice<const std::uint8_t> table) {
    InitReader reader(table);
    Fault fault = Fault::none;
    for (InitStep next; fault == Fault::none && reader.next(next);) fault = step(next);
    return fault;
  }

  // Starts to send data to the selected panel once what is in flight has ended.
  Fault start(Slice<const std::uint8_t> bytes) {
    Fault fault = finish();
    if (fault == Fault::none) fault = wires_.bus.start(bytes);
    if (fault != Fault::none) release();
    in_flight_ = fault == Fault::none;
    return fault;
  }

  // Ends what is in flight.
  Fault finish() {
    if (!in_flight_) return Fault::none;
    in_flight_ = false;
    const Fault fault = wires_.bus.wait();
    if (fault != Fault::none) release();
    return fault;
  }

  void release() { wires_.cs.set(true); }
  void delay_us(std::uint32_t us) {
    if (us != 0) wires_.clock.delay_us(us);
  }

 private:
  static constexpr std::uint32_t kResetPulseUs = 20;  // 10 µs is the longest that a controller of ours asks for

  Wiring wires_;
  std::uint32_t clock_hz_ = 0;
  bool in_flight_ = false;
};

// The lines that an open window still expects.
class ExpectedLines {
 public:
  void expect(std::uint16_t lines, std::uint32_t bytes) {
    left_ = lines;
    bytes_ = bytes;
  }
  void close() { left_ = 0; }
  bool take(Slice<const std::uint8_t> line) {
    if (left_ == 0 || line.size() != bytes_) return false;
    --left_;
    return true;
  }
  std::uint16_t left() const { return left_; }

 private:
  std::uint32_t bytes_ = 0;
  std::uint16_t left_ = 0;
};

// Both edges of [low, high) moved outwards to multiples of `grid`, a power of two.
constexpr std::uint16_t snap_down(std::uint16_t low, unsigned grid) {
  return static_cast<std::uint16_t>(low & ~(grid - 1u));
}
constexpr std::uint16_t snap_up(std::uint16_t high, unsigned grid) {
  return snap_down(static_cast<std::uint16_t>(high + grid - 1u), grid);
}

}  // namespace spanline::hal
