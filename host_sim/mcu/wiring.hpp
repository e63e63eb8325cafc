// What of a board hangs on which pins.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hal/concepts.hpp"

namespace spanline::host {

struct PinName {
  char port = 'P';  // 'P' where the pins of a chip have numbers only
  unsigned number = 0;
  bool operator==(const PinName&) const = default;
};

struct PanelWiring {
  const char* panel;  // as host_sim/panel names it
  hal::Rotation rotation;
  PinName clock, data;  // of the serial port
  PinName select, command_data;
  std::optional<PinName> reset;
  std::optional<std::uint8_t> write_command;  // whose data are pixels; none: all data are
};

}  // namespace spanline::host
