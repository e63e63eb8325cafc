#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "panel/bench.hpp"
#include "panel/models.hpp"

namespace spanline::host {

// A panel driven by hand.
class Hand {
 public:
  explicit Hand(const std::string& panel)
      : model_(make_model(panel, clock_)),
        bench_{.model = *model_, .clock = clock_},
        bus_(bench_),
        dc_(bench_, SimPin::data),
        cs_(bench_, SimPin::select),
        reset_(bench_, SimPin::reset),
        ssd_(panel.substr(0, 3) == "ssd") {
    bus_.set_clock(1'000'000);
    cs_.set(false);
  }

  void command(std::uint8_t code, std::initializer_list<std::uint8_t> arguments = {}) {
    dc_.set(false);
    send({code});
    if (!ssd_) dc_.set(true);
    send(arguments);
  }
  void data(std::initializer_list<std::uint8_t> bytes) {
    dc_.set(true);
    send(bytes);
  }
  std::uint8_t read() {
    std::uint8_t byte = 0;
    bus_.read({&byte, 1});
    return byte;
  }
  void wait_ms(unsigned ms) { clock_.delay_us(ms * 1000); }
  // Awake, on, 16 bits, ready for a window.
  void wake() {
    command(0x11);
    wait_ms(120);
    command(0x3A, {0x55});
    command(0x29);
  }
  void window(std::uint8_t last_column, std::uint8_t last_row) {
    command(0x2A, {0, 0, 0, last_column});
    command(0x2B, {0, 0, 0, last_row});
  }

  SimBus& bus() { return bus_; }
  SimPin& select() { return cs_; }
  SimPin& reset() { return reset_; }
  PanelModel& model() { return *model_; }

  // The only complaint, after the panel's name.
  void expect(const std::string& complaint) {
    const std::vector<std::string>& all = model_->complaints();
    ASSERT_EQ(all.size(), 1u) << complaint << (all.size() > 1 ? "; second: " + all[1] : "");
    EXPECT_NE(all[0].find(": " + complaint), std::string::npos) << all[0];
  }

 private:
  void send(std::initializer_list<std::uint8_t> bytes) {
    if (bytes.size() != 0) bus_.write({bytes.begin(), static_cast<std::uint32_t>(bytes.size())});
  }

  SimClock clock_;
  std::unique_ptr<PanelModel> model_;
  Bench bench_;
  SimBus bus_;
  SimPin dc_, cs_, reset_;
  bool ssd_;
};

}  // namespace spanline::host
