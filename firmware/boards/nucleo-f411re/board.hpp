// ST NUCLEO-F411RE with an ST7789 shield of 240 x 240 on the Arduino header: 100 MHz Cortex-M4F, SPI1, DMA2 stream 3.
//
//   clock D13 PA5, data D11 PA7, chip select D10 PB6, command/data D9 PC7, reset D8 PA9, backlight D6 PB10 (high: on)
//
// The board's light hangs on PA5 as well: it shows the bus clock, and after a fault, when the bus is dead, the cause.
#pragma once

#include "boards/common/clocked.hpp"
#include "hal/mcu/stm32f4/spi.hpp"
#include "hal/panel/st7789.hpp"

namespace spanline::boards {

inline constexpr hal::stm32f4::ClockPlan kClockPlan = hal::stm32f4::kF411At100MHz;
inline constexpr hal::stm32f4::SpiWiring kSpi1{.base = 0x40013000,
                                               .gate = hal::stm32f4::Rcc<hal::Mmio>::kSpi1,
                                               .stream = 3,
                                               .request = 3,
                                               .clock_port = 'A',
                                               .clock_pin = 5,
                                               .data_port = 'A',
                                               .data_pin = 7};

class Board : public Clocked<kClockPlan.hz()>, public AnyBudget {
  template <char kPort, unsigned kNumber>
  using Pin = hal::stm32f4::Pin<hal::Mmio, kPort, kNumber>;
  using Bus = hal::stm32f4::Spi<hal::Mmio, kSpi1, kClockPlan>;
  using Data = Pin<'C', 7>;
  using Select = Pin<'B', 6>;
  using Reset = Pin<'A', 9>;
  using Wiring = hal::Wires<Bus, Data, Select, Reset, Time>;

 public:
  using Panel = hal::St7789Square<hal::Rotation::r0, Wiring>;

  hal::Fault begin() {
    const hal::Fault fault = hal::stm32f4::Rcc<hal::Mmio>::begin(kClockPlan);
    if (fault != hal::Fault::none) return fault;
    Time::begin();
    Data::begin(true);
    Select::begin(true);
    Reset::begin(true);
    Pin<'B', 10>::begin(true);
    bus_.begin();
    return fault;
  }
  Panel& panel() { return panel_; }
  static void light(bool on) { Pin<'A', 5>::begin(on); }

 private:
  Bus bus_;
  Panel panel_{Wiring{bus_, Data{}, Select{}, Reset{}, time_}};
};

}  // namespace spanline::boards
