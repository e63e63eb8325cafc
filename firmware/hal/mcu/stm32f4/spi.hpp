#pragma once

#include "hal/mcu/dma_bus.hpp"
#include "hal/mcu/stm32f4/dma.hpp"
#include "hal/mcu/stm32f4/pins.hpp"

namespace spanline::hal::stm32f4 {

// The port itself: master, 8 bits. kPerBus: cycles of the processor in one of the port's bus.
template <RegisterIo Io, std::uint32_t kBase, std::uint32_t kPerBus>
class SpiPort {
  using Control1 = Register<Io, kBase + 0x00>;
  using Control2 = Register<Io, kBase + 0x04>;
  using State = Register<Io, kBase + 0x08>;
  static constexpr std::uint32_t kMaster = 1u << 2, kEnable = 1u << 6, kSelectHigh = 3u << 8, kTransmitDma = 1u << 1;
  static constexpr std::uint32_t kReceived = 1, kEmpty = 1u << 1, kBusy = 1u << 7;
  static constexpr std::uint32_t kOneLine = 1u << 15, kDrive = 1u << 14;

 public:
  using Data = Register<Io, kBase + 0x0C>;

  // SPI mode 0 to 3, in force from the next set_clock() on: its bits are CPOL and CPHA as they lie in the register.
  void set_mode(std::uint8_t mode) { mode_ = mode; }

  // bus_hz / 2, 4 … 256: the fastest that is at most `hz`, or the slowest there is. Returns what was reached.
  std::uint32_t set_clock(std::uint32_t bus_hz, std::uint32_t hz) {
    std::uint32_t power = 0;
    while (power < 7 && bus_hz >> (power + 1) > hz) ++power;
    Control1::set(0);
    Control2::set(kTransmitDma);
    control_ = kSelectHigh | power << 3 | kMaster | kEnable | mode_;
    Control1::set(control_);
    cycles_per_byte_ = (8 * kPerBus) << (power + 1);
    return bus_hz >> (power + 1);
  }

  // Of the processor's clock.
  std::uint32_t cycles_per_byte() const { return cycles_per_byte_; }

  Fault write(Slice<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) {
      if (empty() != Fault::none) return Fault::spi_timeout;
      Data::set(byte);
    }
    return finish();
  }

  // By a line of its own: sends ones and keeps what comes in meanwhile.
  Fault read(Slice<std::uint8_t> answer) {
    const Fault fault = finish();
    if (fault != Fault::none) return fault;
    for (std::uint8_t& byte : answer) {
      Data::set(0xFF);
      const Fault came = take(byte);
      if (came != Fault::none) return came;
    }
    return finish();
  }

  // By the data line, which turns round: the clock runs from the moment that the port listens until it is switched off.
  // What comes after the last byte is dropped; the panel is deselected then.
  Fault read_data_line(Slice<std::uint8_t> answer) {
    Fault fault = finish();
    if (fault != Fault::none) return fault;
    Control1::set(control_ & ~kEnable);
    Control1::set(control_ | kOneLine);
    for (std::uint8_t& byte : answer) {
      fault = take(byte);
      if (fault != Fault::none) break;
    }
    Control1::set(control_ | kOneLine | kDrive);  // no more clocks
    const Fault idle = wait_for([] { return !State::any(kBusy); }, polls_for(2 * cycles_per_byte_), Fault::spi_timeout);
    Control1::set(control_ & ~kEnable);
    Control1::set(control_);
    static_cast<void>(Data::get());
    static_cast<void>(State::get());
    return fault != Fault::none ? fault : idle;
  }

  // Ends when the last bit has left. What was received meanwhile nobody wants: reading data, then state, clears its
  // overrun.
  Fault finish() {
    Fault fault = empty();
    if (fault == Fault::none) {
      fault = wait_for([] { return !State::any(kBusy); }, polls_for(2 * cycles_per_byte_), Fault::spi_timeout);
    }
    static_cast<void>(Data::get());
    static_cast<void>(State::get());
    return fault;
  }

 private:
  Fault empty() const {
    return wait_for([] { return State::any(kEmpty); }, polls_for(2 * cycles_per_byte_), Fault::spi_timeout);
  }

  Fault take(std::uint8_t& byte) const {
    const Fault fault =
        wait_for([] { return State::any(kReceived); }, polls_for(2 * cycles_per_byte_), Fault::spi_timeout);
    if (fault == Fault::none) byte = static_cast<std::uint8_t>(Data::get());
    return fault;
  }

  std::uint32_t cycles_per_byte_ = 8 * kPerBus * 256;
  std::uint32_t control_ = kSelectHigh | kMaster | kEnable;
  std::uint8_t mode_ = 0;
};

// How the panel's answers come back: not at all, on a pin of their own, or on the data line, turned round.
enum class Answer : std::uint8_t { none, own_pin, data_line };

// What distinguishes one port from another.
struct SpiWiring {
  std::uint32_t base;
  std::uint32_t gate;  // its bit of Rcc::Apb2
  unsigned stream, request;
  char clock_port;
  unsigned clock_pin;
  char data_port;
  unsigned data_pin;
  Answer answer = Answer::none;
  char answer_port = 'A';  // of own_pin
  unsigned answer_pin = 0;
};

// An SPI on APB2 with its DMA2 stream: an SpiBus, and one that reads where the wiring has a way for answers.
template <RegisterIo Io, SpiWiring kWiring, ClockPlan kPlan>
class Spi {
  using Port = SpiPort<Io, kWiring.base, kPlan.hz() / kPlan.apb2_hz()>;
  static constexpr std::uint32_t kFunction = 5;  // SPI1 to SPI6

 public:
  void begin() {
    using R = Rcc<Io>;
    R::template open<typename R::Ahb1>(R::kDma2);
    R::template open<typename R::Apb2>(kWiring.gate);
    Pin<Io, kWiring.clock_port, kWiring.clock_pin>::begin_function(kFunction);
    Pin<Io, kWiring.data_port, kWiring.data_pin>::begin_function(kFunction);
    if constexpr (kWiring.answer == Answer::own_pin) {
      using Input = Pin<Io, kWiring.answer_port, kWiring.answer_pin>;
      Input::begin_function(kFunction);
      Input::pull_up();
    } else if constexpr (kWiring.answer == Answer::data_line) {
      Pin<Io, kWiring.data_port, kWiring.data_pin>::pull_up();
    }
  }
  void set_mode(std::uint8_t mode) { port_.set_mode(mode); }
  std::uint32_t set_clock(std::uint32_t hz) { return port_.set_clock(kPlan.apb2_hz(), hz); }
  Fault write(Slice<const std::uint8_t> bytes) { return port_.write(bytes); }
  Fault read(Slice<std::uint8_t> answer) requires(kWiring.answer != Answer::none) {
    if constexpr (kWiring.answer == Answer::data_line) return port_.read_data_line(answer);
    return port_.read(answer);
  }
  Fault start(Slice<const std::uint8_t> bytes) { return transfer_.start(dma_, bytes); }
  Fault wait() { return transfer_.wait(dma_, port_); }

 private:
  Port port_;
  Dma2<Io, kWiring.stream, kWiring.request, Port::Data::kAt> dma_;
  Transfer transfer_;
};

}  // namespace spanline::hal::stm32f4
