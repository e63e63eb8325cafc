// A microcontroller around its core: peripherals, serial port and DMA in one time with the core, the panel at the end
// of the wire.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mcu/board.hpp"
#include "mcu/display_wire.hpp"
#include "mcu/memory_timing.hpp"
#include "mcu/peripheral.hpp"
#include "mcu/serial_port.hpp"

namespace spanline::host {

// What a chip needs of the machine: a byte of memory, nothing where there is none.
using ReadByte = std::function<std::optional<std::uint8_t>(std::uint32_t address)>;

// One DMA channel that feeds the serial port.
struct DmaTransfer {
  bool active = false;
  std::uint32_t from = 0, left = 0;
  bool step = true;  // the address moves on
  bool failed = false;
};

class Chip {
 public:
  // `reset_kilohertz`: of the core before the image changes it.
  Chip(const BoardDescription& board, std::uint32_t reset_kilohertz, std::size_t fifo, ReadByte read);
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;
  virtual ~Chip() = default;

  // Where `address` lies in a peripheral.
  Peripheral* peripheral_at(std::uint32_t address) const;
  const std::vector<std::unique_ptr<Peripheral>>& peripherals() const { return peripherals_; }

  // Serial port and DMA do what they do until `now`.
  void advance(std::uint64_t now);
  std::uint64_t next_event() const { return port_.next_event(); }
  std::uint64_t now() const { return now_; }

  // Bytes cross the wire in no time, as an emulator has it.
  void send_in_no_time() { port_.send_in_no_time(); }

  const CoreClock& clock() const { return clock_; }
  const DisplayWire& wire() const { return wire_; }
  MemoryTiming& memory() { return memory_; }
  std::uint64_t dma_bytes() const { return dma_bytes_; }
  std::uint64_t pixels_given() const { return port_.pixels(); }
  // With those that a DMA transfer under way will give.
  std::uint64_t pixels_promised() const {
    return port_.pixels() + (dma_.active && wire_.takes_pixels() ? dma_.left : 0);
  }

  // What the image did to the clock tree that the part does not allow.
  const std::vector<std::string>& complaints() const { return complaints_; }

 protected:
  template <typename T, typename... Arguments>
  T& add(Arguments&&... arguments) {
    auto made = std::make_unique<T>(std::forward<Arguments>(arguments)...);
    T& added = *made;
    peripherals_.push_back(std::move(made));
    return added;
  }
  void complain(const std::string& what);
  void run_at(std::uint32_t kilohertz) { clock_.set_kilohertz(kilohertz, now_); }
  void set_pin(PinName pin, bool level) { wire_.set_pin(pin, level, now_, port_.busy()); }
  void give_pin(PinName pin, bool to_port) { wire_.give_pin(pin, to_port); }
  // Feeds the port from DMA as far as both are ready.
  void feed(std::uint64_t at);

  DmaTransfer dma_;
  // The port asks for DMA.
  bool dma_wanted_ = false;
  std::uint64_t now_ = 0;
  CoreClock clock_;
  DisplayWire wire_;
  SerialPort port_;
  MemoryTiming memory_;

 private:
  ReadByte read_;
  std::vector<std::unique_ptr<Peripheral>> peripherals_;
  std::uint64_t dma_bytes_ = 0;
  std::vector<std::string> complaints_;
};

// Null for boards whose peripherals are not modelled.
std::unique_ptr<Chip> make_chip(const BoardDescription& board, ReadByte read);

std::unique_ptr<Chip> make_lm3s6965(const BoardDescription& board, ReadByte read);
std::unique_ptr<Chip> make_stm32f4(const BoardDescription& board, ReadByte read);
std::unique_ptr<Chip> make_rp2040(const BoardDescription& board, ReadByte read);

}  // namespace spanline::host
