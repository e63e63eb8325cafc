#pragma once

#include <cstdint>
#include <vector>

#include "panel/ssd_model.hpp"

namespace spanline::host {

struct SsdGreyGlass {
  WireLimits wire;
  std::uint16_t ram_height;     // rows of 128 pixels
  std::uint16_t height;         // px; the glass is 128 wide
  std::uint16_t first_row = 0;  // its lowest row driver (COM), at the bottom of the glass
  bool mirrored = false;        // column driver (SEG) 0 is at the glass's right edge
  std::vector<SsdCommand> commands;
};

// SSD0323, SSD1325, SSD1327: 16 grey levels, two pixels a byte.
class SsdGreyModel final : public SsdModel {
 public:
  SsdGreyModel(const SsdGreyGlass& glass, const SimClock& clock);

  Picture picture() const override;

 private:
  void clear() override;
  void carry_out(std::uint8_t code) override;
  void take_data(std::uint8_t byte) override;
  unsigned level(unsigned segment, unsigned common) const;

  SsdGreyGlass glass_;
  std::vector<std::uint8_t> memory_;  // 64 bytes a row
  std::uint8_t remap_ = 0, start_ = 0, offset_ = 0, multiplex_ = 0, mode_ = 0xA4;
  bool locked_ = false;
};

}  // namespace spanline::host
