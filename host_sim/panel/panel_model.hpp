// What every controller's model shares: its pins, the bytes that cross the wire, and what it has to complain about.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hal/concepts.hpp"
#include "panel/sim_clock.hpp"
#include "sim/picture.hpp"

namespace spanline::host {

// Facts of a controller's data sheet.
struct WireLimits {
  std::string name;
  std::uint32_t max_clock_hz;
  std::uint32_t max_read_hz = 0;      // 0: what the controller says is not wired
  std::uint32_t reset_pulse_us = 10;  // at least that long
  std::uint32_t after_reset_us;       // until the first command
  unsigned spi_mode = 0;
};

class PanelModel {
 public:
  PanelModel(WireLimits limits, const SimClock& clock) : limits_(std::move(limits)), clock_(clock) {}
  PanelModel(const PanelModel&) = delete;
  PanelModel& operator=(const PanelModel&) = delete;
  virtual ~PanelModel() = default;

  // The pins: data (high) or command, select (low is selected), reset (low is in reset).
  void set_data(bool level) { data_ = level; }
  void set_select(bool level) { select_ = level; }
  void set_reset(bool level);

  // One byte at the end of its eight clocks.
  void shift(std::uint8_t byte, std::uint32_t clock_hz, unsigned spi_mode);

  // What the controller says to the eight clocks after a command that asks; all ones where nobody says anything.
  std::uint8_t answer(std::uint32_t clock_hz);

  // What the upright glass shows: rotation 0. A round glass, too, is shown with its corners.
  virtual Picture picture() const = 0;

  // What went against the protocol, each sort once, in order: "st7789: pixel past the window".
  const std::vector<std::string>& complaints() const { return complaints_; }
  void complain(const std::string& what);

 protected:
  virtual void reset_state() = 0;
  virtual void take_command(std::uint8_t byte) = 0;
  virtual void take_data(std::uint8_t byte) = 0;
  virtual std::uint8_t give_answer();

  std::uint64_t now_ns() const { return clock_.now_ns(); }
  bool within_us(std::uint64_t since_ns, std::uint64_t us) const { return clock_.now_ns() < since_ns + us * 1000; }

  // A software reset takes effect now.
  void note_reset() { reset_end_ns_ = clock_.now_ns(); }
  std::uint64_t reset_end_ns() const { return reset_end_ns_; }

 private:
  WireLimits limits_;
  const SimClock& clock_;
  bool data_ = false, select_ = true, reset_ = true;
  std::uint64_t reset_begin_ns_ = 0, reset_end_ns_ = 0;
  std::vector<std::string> complaints_;
};

// What a viewer sees who has turned the glass so that the picture of this rotation is upright.
Picture turned(const Picture& glass, hal::Rotation rotation);

// "2Ah".
std::string hex(std::uint8_t byte);

}  // namespace spanline::host
