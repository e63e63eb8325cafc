// The shifter of a serial port behind its FIFO, byte by byte in core cycles. A master: it clocks as long as it has
// something to send.
#pragma once

#include <cstdint>
#include <deque>

#include "mcu/display_wire.hpp"

namespace spanline::host {

class SerialPort {
 public:
  static constexpr std::uint64_t kNever = UINT64_MAX;

  // `depth`: bytes that wait before the shifter, and behind it for whoever reads.
  SerialPort(DisplayWire& wire, std::size_t depth) : wire_(wire), depth_(depth) {}

  // In force from the next byte on.
  void set(std::uint64_t cycles_per_byte, std::uint32_t hz, unsigned mode) {
    cycles_per_byte_ = cycles_per_byte;
    hz_ = hz;
    mode_ = mode;
  }

  // Whatever is set, a byte sent takes no cycle.
  void send_in_no_time() { in_no_time_ = true; }

  bool full() const { return waiting_.size() == depth_; }
  bool empty() const { return waiting_.empty(); }
  bool busy() const { return shifting_ || !waiting_.empty(); }

  // Where it is full the byte is lost.
  void push(std::uint8_t byte, std::uint64_t now) {
    if (full()) return;
    waiting_.push_back(byte);
    if (wire_.takes_pixels()) ++pixels_;
    if (!shifting_) begin(now);
  }

  // Clocks bytes in without a pause, as a master does that only receives, until told otherwise.
  void listen(bool on, std::uint64_t now);

  // When the byte on the wire ends.
  std::uint64_t next_event() const { return shifting_ ? now_.end : kNever; }
  void end_byte();

  // Pixel bytes given so far.
  std::uint64_t pixels() const { return pixels_; }

  bool has_received() const { return !received_.empty(); }
  std::uint8_t take_received();

 private:
  void begin(std::uint64_t at);
  void begin_listening(std::uint64_t at);

  DisplayWire& wire_;
  std::size_t depth_;
  std::uint64_t cycles_per_byte_ = 8;
  std::uint32_t hz_ = 0;
  std::uint64_t pixels_ = 0;
  unsigned mode_ = 0;
  std::deque<std::uint8_t> waiting_, received_;
  bool in_no_time_ = false;
  bool shifting_ = false, listening_ = false, hears_ = false;  // hears_: the byte on the wire is the panel's
  std::uint8_t byte_ = 0, last_received_ = 0;
  DisplayWire::Byte now_{};
};

}  // namespace spanline::host
