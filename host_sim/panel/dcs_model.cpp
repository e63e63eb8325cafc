#include "panel/dcs_model.hpp"

#include <algorithm>
#include <iterator>

namespace spanline::host {
namespace {

constexpr std::uint8_t kMirrorY = 0x80, kMirrorX = 0x40, kSwap = 0x20, kBgrBit = 0x08;
constexpr std::uint8_t kReverseSources = 0x20, kReverseGates = 0x40;  // B6h
constexpr int kAny = -1, kUnknown = -2;

// The commands of the standard that the models know, by their number of arguments.
constexpr std::uint8_t kWithNone[] = {0x00, 0x01, 0x0A, 0x10, 0x11, 0x12, 0x13, 0x20,
                                      0x21, 0x28, 0x29, 0x2C, 0x34, 0x38, 0x39};
constexpr std::uint8_t kWithOne[] = {0x26, 0x35, 0x36, 0x3A};
constexpr std::uint8_t kWithFour[] = {0x2A, 0x2B};

int standard_arguments(std::uint8_t code) {
  const auto listed = [code](const auto& codes) {
    return std::find(std::begin(codes), std::end(codes), code) != std::end(codes);
  };
  if (listed(kWithNone)) return 0;
  if (listed(kWithOne)) return 1;
  return listed(kWithFour) ? 4 : kUnknown;
}

// Six bits to eight. Only six exist on the glass; where they are five that a driver widened by bit replication, the two
// below them are filled as those five would be, so that the picture can be compared with the one before.
std::uint8_t expand6(unsigned six) {
  const bool widened = (six & 1) == six >> 5;
  const unsigned five = six >> 1;
  return static_cast<std::uint8_t>(widened ? five << 3 | five >> 2 : six << 2 | six >> 4);
}

}  // namespace

DcsModel::DcsModel(const DcsGlass& glass, const SimClock& clock)
    : PanelModel(glass.wire, clock), glass_(glass), memory_(glass.ram_width, glass.ram_height) {
  reset_state();
}

// The memory keeps what it held.
void DcsModel::reset_state() {
  command_ = 0;
  wanted_ = 0;
  arguments_.clear();
  madctl_ = function_ = 0;
  depth_ = 3;
  asleep_ = true;
  on_ = invert_ = writing_ = full_ = false;
  unlocked_ = 0;
  columns_ = rows_ = {};
  pixel_bytes_ = 0;
}

void DcsModel::end_command() {
  if (arguments_.size() < wanted_) {
    complain(hex(command_) + " with " + std::to_string(arguments_.size()) + " of " + std::to_string(wanted_) +
             " arguments");
  }
  if (writing_ && pixel_bytes_ != 0) complain("half a pixel");
  writing_ = false;
  arguments_.clear();
}

bool DcsModel::locked(std::uint8_t code) const {
  if (glass_.lock == Lock::st7796) return code != 0xF0 && unlocked_ != 3;
  if (glass_.lock == Lock::gc9a01) return code != 0xFE && code != 0xEF && unlocked_ != 3;
  return false;
}

void DcsModel::check_state(std::uint8_t code) {
  constexpr std::uint64_t kBeforeAnyUs = 5'000, kBeforeSleepChangeUs = 120'000;
  if (own(code) && locked(code)) complain(hex(code) + " while its command set is locked");
  if (!asleep_ && within_us(awake_ns_, kBeforeAnyUs)) complain("command too soon after SLPOUT");
  const bool early = !asleep_ && within_us(awake_ns_, kBeforeSleepChangeUs);
  if (early && (code == 0x29 || code == 0x2C || code == 0x10)) complain(hex(code) + " less than 120 ms after SLPOUT");
  if (code == 0x11 && within_us(reset_end_ns(), kBeforeSleepChangeUs)) {
    complain("SLPOUT less than 120 ms after a reset");
  }
  if (asleep_ && code == 0x29) complain("DISPON while asleep");
  if (!asleep_ && code == 0x11) complain("SLPOUT while awake");
}

void DcsModel::take_command(std::uint8_t code) {
  end_command();
  const int count = own(code) ? kAny : standard_arguments(code);
  if (count == kUnknown) {
    complain("unknown command " + hex(code));
  }
  check_state(code);
  command_ = code;
  wanted_ = count > 0 ? static_cast<unsigned>(count) : 0;
  if (wanted_ == 0) carry_out();
}

void DcsModel::take_data(std::uint8_t byte) {
  if (writing_) return take_pixel_byte(byte);
  if (!own(command_) && arguments_.size() >= wanted_) return complain("data that no command takes");
  arguments_.push_back(byte);
  if (own(command_) || arguments_.size() == wanted_) carry_out();
}

// RDDPM: booster, sleep out, normal mode, display on.
std::uint8_t DcsModel::give_answer() {
  if (command_ != 0x0A) return PanelModel::give_answer();
  return static_cast<std::uint8_t>((asleep_ ? 0 : 0x90) | 0x08 | (on_ ? 0x04 : 0));
}

void DcsModel::sleep_out() {
  asleep_ = false;
  awake_ns_ = now_ns();
}

void DcsModel::set_depth(std::uint8_t colmod) {
  const unsigned code = colmod & 7u;
  if (code != 5 && code != 6) return complain("COLMOD " + hex(colmod) + " is neither 16 nor 18 bits");
  if (code == 5 && glass_.only_18_bit) return complain("16-bit colour, which this interface does not take");
  depth_ = code == 5 ? 2 : 3;
}

DcsModel::Range DcsModel::range(unsigned size) {
  Range r;
  r.first = static_cast<unsigned>(arguments_[0]) << 8 | arguments_[1];
  r.last = static_cast<unsigned>(arguments_[2]) << 8 | arguments_[3];
  r.given = true;
  if (r.first > r.last || r.last >= size) {
    complain("window " + std::to_string(r.first) + "-" + std::to_string(r.last) + " of " + std::to_string(size));
    r.last = std::min(r.last, size - 1);
    r.first = std::min(r.first, r.last);
  }
  return r;
}

void DcsModel::begin_write() {
  if (asleep_) complain("RAMWR while asleep");
  if (!columns_.given || !rows_.given) return complain("RAMWR without a window");
  writing_ = true;
  full_ = false;
  pixel_bytes_ = 0;
  column_ = columns_.first;
  row_ = rows_.first;
}

void DcsModel::carry_out() {
  const bool swapped = (madctl_ & kSwap) != 0;
  switch (command_) {
    case 0x01:
      reset_state();
      return note_reset();
    case 0x10:
      asleep_ = true;
      return;
    case 0x11:
      return sleep_out();
    case 0x20:
    case 0x21:
      invert_ = command_ == 0x21;
      return;
    case 0x28:
    case 0x29:
      on_ = command_ == 0x29;
      return;
    case 0x2A:
      columns_ = range(swapped ? glass_.ram_height : glass_.ram_width);
      return;
    case 0x2B:
      rows_ = range(swapped ? glass_.ram_width : glass_.ram_height);
      return;
    case 0x2C:
      return begin_write();
    case 0x36:
      madctl_ = arguments_[0];
      columns_.given = rows_.given = false;  // they counted along other axes
      return;
    case 0x3A:
      return set_depth(arguments_[0]);
    default:
      break;
  }
  if (command_ == 0xB6 && arguments_.size() == 2) function_ = arguments_[1];
  if (glass_.lock == Lock::gc9a01 && command_ == 0xFE) unlocked_ |= 1;
  if (glass_.lock == Lock::gc9a01 && command_ == 0xEF) unlocked_ |= 2;
  if (glass_.lock == Lock::st7796 && command_ == 0xF0 && arguments_.size() == 1) {
    if (arguments_[0] == 0xC3) unlocked_ |= 1;
    if (arguments_[0] == 0x96) unlocked_ |= 2;
    if (arguments_[0] == 0x3C || arguments_[0] == 0x69) unlocked_ &= arguments_[0] == 0x3C ? 2u : 1u;
  }
}

void DcsModel::take_pixel_byte(std::uint8_t byte) {
  if (full_) return complain("pixel past the window");
  pixel_[pixel_bytes_++] = byte;
  if (pixel_bytes_ < depth_) return;
  pixel_bytes_ = 0;
  put_pixel();
  step();
}

void DcsModel::put_pixel() {
  unsigned x = madctl_ & kSwap ? row_ : column_, y = madctl_ & kSwap ? column_ : row_;
  if (madctl_ & kMirrorX) x = glass_.ram_width - 1u - x;
  if (madctl_ & kMirrorY) y = glass_.ram_height - 1u - y;
  std::uint8_t* rgb = &memory_.rgb[std::size_t{3} * (y * glass_.ram_width + x)];
  if (depth_ == 2) return decode_line(PixelFormat::rgb565, pixel_, 1, rgb);
  rgb[0] = expand6(pixel_[0] >> 2);
  rgb[1] = static_cast<std::uint8_t>((pixel_[1] & 0xFC) | pixel_[1] >> 6);
  rgb[2] = expand6(pixel_[2] >> 2);
}

void DcsModel::step() {
  if (column_++ < columns_.last) return;
  column_ = columns_.first;
  if (row_++ < rows_.last) return;
  row_ = rows_.first;
  full_ = true;
}

Picture DcsModel::picture() const {
  Picture seen(glass_.width, glass_.height);
  if (asleep_ || !on_) return seen;
  const bool swapped = glass_.bgr != ((madctl_ & kBgrBit) != 0);
  const bool complement = glass_.inverted != invert_;
  std::uint8_t* out = seen.rgb.data();
  for (unsigned y = 0; y < seen.height; ++y) {
    for (unsigned x = 0; x < seen.width; ++x, out += 3) {
      const unsigned source = glass_.left + (glass_.mirrored ? seen.width - 1u - x : x), gate = glass_.top + y;
      const unsigned column = function_ & kReverseSources ? glass_.ram_width - 1u - source : source;
      const unsigned row = function_ & kReverseGates ? glass_.ram_height - 1u - gate : gate;
      std::copy_n(&memory_.rgb[std::size_t{3} * (row * glass_.ram_width + column)], 3, out);
      if (swapped) std::swap(out[0], out[2]);
      if (complement) std::transform(out, out + 3, out, [](std::uint8_t v) { return static_cast<std::uint8_t>(~v); });
    }
  }
  return seen;
}

}  // namespace spanline::host
