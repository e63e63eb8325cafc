#include "panel/ssd_grey_model.hpp"

namespace spanline::host {
namespace {

constexpr unsigned kWidth = 128, kRowBytes = kWidth / 2;
constexpr std::uint8_t kRemapColumns = 0x01, kRemapNibbles = 0x02, kVertical = 0x04, kRemapRows = 0x10;

}  // namespace

SsdGreyModel::SsdGreyModel(const SsdGreyGlass& glass, const SimClock& clock)
    : SsdModel(glass.wire, clock, glass.commands), glass_(glass), memory_(std::size_t{kRowBytes} * glass.ram_height) {
  clear();
}

void SsdGreyModel::clear() {
  remap_ = start_ = offset_ = 0;
  multiplex_ = static_cast<std::uint8_t>(glass_.ram_height - 1);
  mode_ = 0xA4;
  locked_ = false;
}

void SsdGreyModel::carry_out(std::uint8_t code) {
  if (code == 0xFD) {
    locked_ = arguments_[0] == 0x16;
    return;
  }
  if (locked_) return complain(hex(code) + " while commands are locked");
  switch (code) {
    case 0x15:
      columns_ = range(kRowBytes);
      return restart_window();
    case 0x75:
      rows_ = range(glass_.ram_height);
      return restart_window();
    case 0xA0:
      remap_ = arguments_[0];
      if (remap_ & kVertical) complain("vertical increment, which the drivers do not use");
      return;
    case 0xA1:
      start_ = arguments_[0];
      return;
    case 0xA2:
      offset_ = arguments_[0];
      return;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
      mode_ = code;
      return;
    case 0xA8:
      multiplex_ = arguments_[0];
      return;
    case 0xAE:
    case 0xAF:
      on_ = code == 0xAF;
      if (on_ && multiplex_ + 1 != glass_.height) {
        complain("display on with " + std::to_string(multiplex_ + 1) + " of " + std::to_string(glass_.height) +
                 " rows");
      }
      return;
    default:
      return;
  }
}

void SsdGreyModel::take_data(std::uint8_t byte) {
  Place place;
  if (next_place(place)) memory_[place.row * kRowBytes + place.column] = byte;
}

unsigned SsdGreyModel::level(unsigned segment, unsigned common) const {
  if (mode_ == 0xA5) return 15;
  if (mode_ == 0xA6) return 0;
  const unsigned counted = remap_ & kRemapRows ? glass_.ram_height - 1u - common : common;
  const unsigned row = (counted + start_ + offset_) % glass_.ram_height;
  const unsigned pair = segment / 2, column = remap_ & kRemapColumns ? kRowBytes - 1 - pair : pair;
  const bool high = (segment % 2 == 0) == ((remap_ & kRemapNibbles) != 0);
  const unsigned byte = memory_[row * kRowBytes + column], stored = high ? byte >> 4 : byte & 15u;
  return mode_ == 0xA7 ? 15 - stored : stored;
}

Picture SsdGreyModel::picture() const {
  Picture seen(kWidth, glass_.height);
  if (!on_) return seen;
  std::uint8_t* out = seen.rgb.data();
  for (unsigned y = 0; y < glass_.height; ++y) {
    const unsigned common = glass_.first_row + glass_.height - 1u - y;
    for (unsigned x = 0; x < kWidth; ++x, out += 3) {
      const std::uint8_t wire = static_cast<std::uint8_t>(level(glass_.mirrored ? kWidth - 1 - x : x, common) << 4);
      decode_line(PixelFormat::grey4, &wire, 1, out);
    }
  }
  return seen;
}

}  // namespace spanline::host
