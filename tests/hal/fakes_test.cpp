// The simulator's bus, pins and clock keep the contracts that a board's do.
#include <type_traits>
#include <vector>

#include "hal/contract/clock.hpp"
#include "hal/contract/out_pin.hpp"
#include "hal/contract/spi_bus.hpp"
#include "panel/bench.hpp"

namespace spanline::host {
namespace {

// A panel that keeps every byte and judges none.
class Recorder final : public PanelModel {
 public:
  explicit Recorder(const SimClock& clock)
      : PanelModel({.name = "recorder", .max_clock_hz = UINT32_MAX, .reset_pulse_us = 0, .after_reset_us = 0}, clock) {
    set_select(false);
  }
  Picture picture() const override { return {}; }

  std::vector<std::uint8_t> bytes;

 private:
  void reset_state() override {}
  void take_command(std::uint8_t byte) override { bytes.push_back(byte); }
  void take_data(std::uint8_t byte) override { bytes.push_back(byte); }
};

class SimRig {
 public:
  static constexpr hal::Fault kJammed = hal::Fault::spi_timeout;

  SimClock& clock() { return clock_; }
  SimBus& bus() { return bus_; }
  SimPin& pin() { return pin_; }
  bool level() const { return bench_.reset_level; }
  const std::vector<std::uint8_t>& wire() const { return model_.bytes; }
  void jam() { bus_.plant(kJammed, 0); }

 private:
  SimClock clock_;
  Recorder model_{clock_};
  Bench bench_{.model = model_, .clock = clock_};
  SimBus bus_{bench_};
  SimPin pin_{bench_, SimPin::reset};
};

}  // namespace
}  // namespace spanline::host

namespace spanline::hal {

INSTANTIATE_TYPED_TEST_SUITE_P(Simulator, SpiBusContract, host::SimRig);
INSTANTIATE_TYPED_TEST_SUITE_P(Simulator, OutPinContract, host::SimRig);
INSTANTIATE_TYPED_TEST_SUITE_P(Simulator, ClockContract, host::SimRig);

TEST(SimBus, AStartWhileOneIsInFlightIsAnError) {
  host::SimRig rig;
  const std::uint8_t byte[] = {1};
  EXPECT_EQ(rig.bus().start(byte), Fault::none);
  EXPECT_EQ(rig.bus().start(byte), Fault::dma_error);
}

}  // namespace spanline::hal
