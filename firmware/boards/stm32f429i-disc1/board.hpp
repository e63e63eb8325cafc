// ST STM32F429I-DISC1: 180 MHz Cortex-M4F, ILI9341 of 240 x 320 on SPI5, fed by DMA2 stream 4.
//
//   clock PF7, data PF9, chip select PC2, command/data PD13, read strobe PD12 (high: never), light PG13; the panel
//   answers on its data line, so that begin() finds it absent; its reset is the board's
#pragma once

#include "boards/common/clocked.hpp"
#include "hal/mcu/stm32f4/spi.hpp"
#include "hal/panel/ili9341.hpp"

namespace spanline::boards {

inline constexpr hal::stm32f4::ClockPlan kClockPlan = hal::stm32f4::kF429At180MHz;
inline constexpr hal::stm32f4::SpiWiring kSpi5{.base = 0x40015000,
                                               .gate = hal::stm32f4::Rcc<hal::Mmio>::kSpi5,
                                               .stream = 4,
                                               .request = 2,
                                               .clock_port = 'F',
                                               .clock_pin = 7,
                                               .data_port = 'F',
                                               .data_pin = 9,
                                               .answer = hal::stm32f4::Answer::data_line};

class Board : public Clocked<kClockPlan.hz()>, public AnyBudget {
  template <char kPort, unsigned kNumber>
  using Pin = hal::stm32f4::Pin<hal::Mmio, kPort, kNumber>;
  using Bus = hal::stm32f4::Spi<hal::Mmio, kSpi5, kClockPlan>;
  using Data = Pin<'D', 13>;
  using Select = Pin<'C', 2>;
  using Wiring = hal::Wires<Bus, Data, Select, hal::NoPin, Time>;

 public:
  using Panel = hal::Ili9341<hal::Rotation::r0, Wiring>;

  hal::Fault begin() {
    const hal::Fault fault = hal::stm32f4::Rcc<hal::Mmio>::begin(kClockPlan);
    if (fault != hal::Fault::none) return fault;
    Time::begin();
    Pin<'D', 12>::begin(true);
    Data::begin(true);
    Select::begin(true);
    bus_.begin();
    return fault;
  }
  Panel& panel() { return panel_; }
  static void light(bool on) { Pin<'G', 13>::begin(on); }

 private:
  Bus bus_;
  Panel panel_{Wiring{bus_, Data{}, Select{}, hal::NoPin{}, time_}};
};

}  // namespace spanline::boards
