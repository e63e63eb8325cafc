// What a panel is connected to.
#pragma once

#include <type_traits>

#include "hal/concepts.hpp"

namespace spanline::hal {

// A line that the board does not have: chip select tied low, no reset line.
struct NoPin {
  constexpr void set(bool) {}
};

// The bus and the clock belong to the board and are referred to; pins are handles and are copied.
template <SpiBus BusType, OutPin Dc, OutPin Cs, OutPin Reset, Clock Time>
struct Wires {
  using Bus = BusType;
  static constexpr bool kHasReset = !std::is_same_v<Reset, NoPin>;

  constexpr Wires(Bus& the_bus, Dc dc_pin, Cs cs_pin, Reset reset_pin, Time& the_clock)
      : bus(the_bus), clock(the_clock), dc(dc_pin), cs(cs_pin), reset(reset_pin) {}

  Bus& bus;
  Time& clock;
  [[no_unique_address]] Dc dc;        // low: command, high: data
  [[no_unique_address]] Cs cs;        // low: selected
  [[no_unique_address]] Reset reset;  // low: in reset
};

}  // namespace spanline::hal
