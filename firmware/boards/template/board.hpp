// A board to copy: every value marked "here" is the copy's own to decide. docs/porting.md walks through it.
//
//   clock …, data …, chip select …, command/data …, reset …, light …
#pragma once

#include "boards/common/clocked.hpp"
#include "hal/mcu/rp2040/spi.hpp"  // here: the MCU layer
#include "hal/panel/st7789.hpp"    // here: the panel

namespace spanline::boards {

class Board : public Clocked<hal::rp2040::kHz>, public AnyBudget {  // here: the processor's clock
  template <unsigned kNumber>
  using Pin = hal::rp2040::Pin<hal::Mmio, kNumber>;
  using Bus = hal::rp2040::Spi0<hal::Mmio, 18, 19>;  // here: the bus and its pins
  using Data = Pin<20>;                              // here: the pins of the panel
  using Select = Pin<17>;
  using Reset = Pin<21>;  // here: hal::NoPin where the panel has no reset line of its own
  using Wiring = hal::Wires<Bus, Data, Select, Reset, Time>;

 public:
  using Panel = hal::St7789<hal::Rotation::r90, Wiring>;  // here: the panel and how it is turned

  // Clock first, then whatever the panel needs; the first fault ends it.
  hal::Fault begin() {
    hal::Fault fault = hal::rp2040::Clocks<hal::Mmio>::begin();
    if (fault == hal::Fault::none) fault = bus_.begin();
    if (fault != hal::Fault::none) return fault;
    Time::begin();
    Data::begin(true);
    Select::begin(true);
    Reset::begin(true);
    return fault;
  }
  Panel& panel() { return panel_; }
  static void light(bool on) { Pin<25>::begin(on); }  // here: the light that blinks the cause of a fault

 private:
  Bus bus_;
  Panel panel_{Wiring{bus_, Data{}, Select{}, Reset{}, time_}};
};

}  // namespace spanline::boards
