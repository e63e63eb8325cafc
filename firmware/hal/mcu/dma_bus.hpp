// A transfer that DMA makes and the port finishes: the part that all buses with DMA share.
#pragma once

#include "core/base/slice.hpp"
#include "hal/mcu/mmio.hpp"

namespace spanline::hal {

// Remembers how long the transfer under way may take. `Dma` is a DmaChannel with stop(); `Port` has cycles_per_byte()
// and finish().
class Transfer {
 public:
  template <typename Dma>
  Fault start(Dma& dma, Slice<const std::uint8_t> bytes) {
    if (bytes.empty()) return Fault::none;
    const Fault fault = dma.start(bytes);
    if (fault == Fault::none) bytes_ = bytes.size();
    return fault;
  }

  // None where nothing is under way. A DMA error wins over the timeout that it causes.
  template <typename Dma, typename Port>
  Fault wait(Dma& dma, Port& port) {
    if (bytes_ == 0) return Fault::none;
    const std::uint32_t polls = polls_for(bytes_ * port.cycles_per_byte());
    bytes_ = 0;
    Fault fault = wait_for([&dma] { return !dma.busy() || dma.fault() != Fault::none; }, polls, Fault::dma_timeout);
    if (dma.fault() != Fault::none) fault = dma.fault();
    if (fault != Fault::none) dma.stop();
    const Fault finished = port.finish();
    return fault != Fault::none ? fault : finished;
  }

 private:
  std::uint32_t bytes_ = 0;
};

}  // namespace spanline::hal
