#pragma once

#include <cstdint>
#include <vector>

#include "panel/ssd_model.hpp"

namespace spanline::host {

// SSD1306 with 128x64 glass: column driver 0 at its right edge, row driver 0 at its bottom.
class Ssd1306Model final : public SsdModel {
 public:
  explicit Ssd1306Model(const SimClock& clock);

  Picture picture() const override;

 private:
  void clear() override;
  void carry_out(std::uint8_t code) override;
  void take_data(std::uint8_t byte) override;

  std::vector<std::uint8_t> memory_;  // pages of 128 columns, the top row in bit 0
  unsigned addressing_ = 2, start_ = 0, offset_ = 0;
  bool mirror_segments_ = false, mirror_rows_ = false, inverted_ = false, all_on_ = false, pump_ = false;
};

}  // namespace spanline::host
