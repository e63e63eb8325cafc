#include "panel/panel_model.hpp"

#include <algorithm>
#include <cstdio>

namespace spanline::host {

void PanelModel::complain(const std::string& what) {
  const std::string text = limits_.name + ": " + what;
  if (std::find(complaints_.begin(), complaints_.end(), text) == complaints_.end()) complaints_.push_back(text);
}

void PanelModel::set_reset(bool level) {
  if (level == reset_) return;
  reset_ = level;
  if (!level) {
    reset_begin_ns_ = now_ns();
    return;
  }
  if (within_us(reset_begin_ns_, limits_.reset_pulse_us)) return complain("reset pulse too short");
  reset_state();
  note_reset();
}

void PanelModel::shift(std::uint8_t byte, std::uint32_t clock_hz, unsigned spi_mode) {
  if (clock_hz > limits_.max_clock_hz) {
    complain("clock of " + std::to_string(clock_hz) + " Hz, allowed are " + std::to_string(limits_.max_clock_hz));
  }
  if (spi_mode != limits_.spi_mode) {
    return complain("SPI mode " + std::to_string(spi_mode) + ", wanted is " + std::to_string(limits_.spi_mode));
  }
  if (select_) return complain("byte while not selected");
  if (!reset_) return complain("byte during reset");
  if (within_us(reset_end_ns_, limits_.after_reset_us)) return complain("byte too soon after a reset");
  if (data_) {
    take_data(byte);
  } else {
    take_command(byte);
  }
}

std::uint8_t PanelModel::answer(std::uint32_t clock_hz) {
  if (select_ || !reset_ || limits_.max_read_hz == 0) return 0xFF;
  if (clock_hz > limits_.max_read_hz) complain("read at " + std::to_string(clock_hz) + " Hz");
  return give_answer();
}

std::uint8_t PanelModel::give_answer() {
  complain("read that no command answers");
  return 0xFF;
}

Picture turned(const Picture& glass, hal::Rotation rotation) {
  const unsigned right = glass.width - 1u, bottom = glass.height - 1u;
  const bool quarter = rotation == hal::Rotation::r90 || rotation == hal::Rotation::r270;
  Picture seen = quarter ? Picture(glass.height, glass.width) : Picture(glass.width, glass.height);
  std::uint8_t* out = seen.rgb.data();
  for (unsigned y = 0; y < seen.height; ++y) {
    for (unsigned x = 0; x < seen.width; ++x, out += 3) {
      unsigned column = x, row = y;
      if (rotation == hal::Rotation::r90) column = right - y, row = x;
      if (rotation == hal::Rotation::r180) column = right - x, row = bottom - y;
      if (rotation == hal::Rotation::r270) column = y, row = bottom - x;
      std::copy_n(&glass.rgb[std::size_t{3} * (row * glass.width + column)], 3, out);
    }
  }
  return seen;
}

std::string hex(std::uint8_t byte) {
  char text[4];
  std::snprintf(text, sizeof text, "%02Xh", byte);
  return text;
}

}  // namespace spanline::host
