// Raspberry Pi Pico with an ST7789 of 240 x 320 held sideways: 125 MHz Cortex-M0+, SPI0, DMA channel 0.
//
//   clock GP18, data GP19, chip select GP17, command/data GP20, reset GP21, backlight GP22 (high: on), light GP25
#pragma once

#include "boards/common/clocked.hpp"
#include "hal/mcu/rp2040/spi.hpp"
#include "hal/panel/st7789.hpp"

namespace spanline::boards {

class Board : public Clocked<hal::rp2040::kHz>, public AnyBudget {
  template <unsigned kNumber>
  using Pin = hal::rp2040::Pin<hal::Mmio, kNumber>;
  using Bus = hal::rp2040::Spi0<hal::Mmio, 18, 19>;
  using Data = Pin<20>;
  using Select = Pin<17>;
  using Reset = Pin<21>;
  using Wiring = hal::Wires<Bus, Data, Select, Reset, Time>;

 public:
  using Panel = hal::St7789<hal::Rotation::r90, Wiring>;

  hal::Fault begin() {
    hal::Fault fault = hal::rp2040::Clocks<hal::Mmio>::begin();
    if (fault == hal::Fault::none) fault = bus_.begin();
    if (fault != hal::Fault::none) return fault;
    Time::begin();
    Data::begin(true);
    Select::begin(true);
    Reset::begin(true);
    Pin<22>::begin(true);
    return fault;
  }
  Panel& panel() { return panel_; }
  static void light(bool on) { Pin<25>::begin(on); }

 private:
  Bus bus_;
  Panel panel_{Wiring{bus_, Data{}, Select{}, Reset{}, time_}};
};

}  // namespace spanline::boards
