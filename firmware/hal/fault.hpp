#pragma once

#include <cstdint>

namespace spanline::hal {

// How a hardware operation ended. Every wait in firmware/ is bounded and ends in one of these.
enum class Fault : std::uint8_t {
  none,
  clock_timeout,  // an oscillator or PLL did not lock, a peripheral did not leave reset
  spi_timeout,    // the bus never became ready
  dma_timeout,    // a transfer did not finish in the time its bytes need
  dma_error,      // the controller reported a transfer error
  panel_absent,   // the panel did not answer where it can be asked
  bad_window,     // a window or line that does not fit the panel
};

constexpr const char* name(Fault fault) {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::clock_timeout:
      return "clock timeout";
    case Fault::spi_timeout:
      return "spi timeout";
    case Fault::dma_timeout:
      return "dma timeout";
    case Fault::dma_error:
      return "dma error";
    case Fault::panel_absent:
      return "panel absent";
    default:
      return "bad window";
  }
}

}  // namespace spanline::hal
