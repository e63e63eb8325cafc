#include "panel/ssd1306_model.hpp"

namespace spanline::host {
namespace {

constexpr unsigned kWidth = 128, kHeight = 64, kPages = 8;

const std::vector<SsdCommand> kCommands = {
    {0x00, 0x1F, 0}, {0x20, 0x20, 1}, {0x21, 0x22, 2}, {0x26, 0x27, 6}, {0x29, 0x2A, 5}, {0x2E, 0x2F, 0},
    {0x40, 0x7F, 0}, {0x81, 0x81, 1}, {0x8D, 0x8D, 1}, {0xA0, 0xA1, 0}, {0xA3, 0xA3, 2}, {0xA4, 0xA7, 0},
    {0xA8, 0xA8, 1}, {0xAE, 0xAF, 0}, {0xB0, 0xB7, 0}, {0xC0, 0xC8, 0}, {0xD3, 0xD3, 1}, {0xD5, 0xD5, 1},
    {0xD9, 0xD9, 1}, {0xDA, 0xDB, 1}, {0xE3, 0xE3, 0}};

}  // namespace

Ssd1306Model::Ssd1306Model(const SimClock& clock)
    : SsdModel({"ssd1306", 10'000'000, 3, 3, 0}, clock, kCommands), memory_(kWidth * kPages) {}

void Ssd1306Model::clear() {
  addressing_ = 2;
  start_ = offset_ = 0;
  mirror_segments_ = mirror_rows_ = inverted_ = all_on_ = pump_ = false;
}

void Ssd1306Model::carry_out(std::uint8_t code) {
  if ((code & 0xC0) == 0x40) start_ = code & 63u;
  switch (code) {
    case 0x20:
      addressing_ = arguments_[0];
      return;
    case 0x21:
      columns_ = range(kWidth);
      return restart_window();
    case 0x22:
      rows_ = range(kPages);
      return restart_window();
    case 0x8D:
      pump_ = (arguments_[0] & 4) != 0;
      return;
    case 0xA0:
    case 0xA1:
      mirror_segments_ = code == 0xA1;
      return;
    case 0xA4:
    case 0xA5:
      all_on_ = code == 0xA5;
      return;
    case 0xA6:
    case 0xA7:
      inverted_ = code == 0xA7;
      return;
    case 0xAE:
    case 0xAF:
      on_ = code == 0xAF;
      if (on_ && !pump_) complain("display on without its charge pump");
      return;
    case 0xC0:
    case 0xC8:
      mirror_rows_ = code == 0xC8;
      return;
    case 0xD3:
      offset_ = arguments_[0];
      return;
    default:
      return;
  }
}

void Ssd1306Model::take_data(std::uint8_t byte) {
  if (addressing_ != 0) return complain("data while addresses do not run along the window");
  Place place;
  if (next_place(place)) memory_[place.row * kWidth + place.column] = byte;
}

Picture Ssd1306Model::picture() const {
  Picture seen(kWidth, kHeight);
  if (!on_) return seen;
  std::uint8_t* out = seen.rgb.data();
  for (unsigned y = 0; y < kHeight; ++y) {
    const unsigned common = kHeight - 1 - y;
    const unsigned row = ((mirror_rows_ ? kHeight - 1 - common : common) + start_ + offset_) % kHeight;
    for (unsigned x = 0; x < kWidth; ++x, out += 3) {
      const unsigned segment = kWidth - 1 - x, column = mirror_segments_ ? kWidth - 1 - segment : segment;
      const bool stored = (memory_[row / 8 * kWidth + column] >> row % 8 & 1) != 0;
      const std::uint8_t wire = all_on_ || stored != inverted_ ? 0x80 : 0;
      decode_line(PixelFormat::mono1, &wire, 1, out);
    }
  }
  return seen;
}

}  // namespace spanline::host
