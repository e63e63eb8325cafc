// TI EK-LM3S6965 (and QEMU's lm3s6965evb): 50 MHz Cortex-M3, SSD0323 OLED of 128 x 64 greys on SSI0.
//
//   clock PA2, data PA5, chip select PA3, command/data PC7, OLED supply PC6 (high: on), SD card select PD0 (high),
//   light PF0
#pragma once

#include "boards/common/clocked.hpp"
#include "hal/mcu/lm3s6965/lm3s6965.hpp"
#include "hal/panel/ssd0323.hpp"

namespace spanline::boards {

class Board : public Clocked<hal::lm3s6965::kHz>, public AnyBudget {
  template <char kPort, unsigned kNumber>
  using Pin = hal::lm3s6965::Pin<hal::Mmio, kPort, kNumber>;
  using Bus = hal::lm3s6965::Ssi0<hal::Mmio>;
  using Data = Pin<'C', 7>;
  using Select = Pin<'A', 3>;
  using Light = Pin<'F', 0>;
  using Wiring = hal::Wires<Bus, Data, Select, hal::NoPin, Time>;

 public:
  using Panel = hal::Ssd0323<hal::Rotation::r0, Wiring>;

  hal::Fault begin() {
    const hal::Fault fault = hal::lm3s6965::System<hal::Mmio>::begin();
    if (fault != hal::Fault::none) return fault;
    Time::begin();
    Pin<'D', 0>::begin(true);
    Pin<'C', 6>::begin(true);
    Data::begin(true);
    Select::begin(true);
    bus_.begin();
    return fault;
  }
  Panel& panel() { return panel_; }
  static void light(bool on) { Light::begin(on); }

 private:
  Bus bus_;
  Panel panel_{Wiring{bus_, Data{}, Select{}, hal::NoPin{}, time_}};
};

}  // namespace spanline::boards
