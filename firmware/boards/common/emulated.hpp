// Boards that exist for an emulator only: their panel is a sum of what it was sent.
#pragma once

#include "boards/common/report.hpp"
#include "boards/common/run_request.hpp"
#include "core/frame/budget.hpp"
#include "hal/concepts.hpp"
#include "hal/mcu/semihosting.hpp"

namespace spanline::boards {

// Prints FNV-1a sums: of each line of the frame that was asked for, and of every whole frame.
template <std::uint16_t kPanelWidth, std::uint16_t kPanelHeight, PixelFormat kPanelFormat>
class SumPanel {
 public:
  static constexpr PixelFormat kFormat = kPanelFormat;
  static constexpr std::uint16_t kWidth = kPanelWidth, kHeight = kPanelHeight;

  static constexpr std::uint16_t width() { return kWidth; }
  static constexpr std::uint16_t height() { return kHeight; }
  hal::Fault begin() { return hal::Fault::none; }
  hal::Fault open(const hal::Window& window) {
    line_ = window.top;
    bottom_ = window.bottom;
    frame_sum_ = kBasis;
    return hal::Fault::none;
  }
  hal::Fault send(Slice<const std::uint8_t> bytes) {
    if (line_ >= bottom_ || bytes.size() != bytes_per_line(kFormat, kWidth)) return hal::Fault::bad_window;
    frame_sum_ = sum(frame_sum_, bytes);
    if (frame_ == request().last_frame) print_sum("line=", line_, sum(kBasis, bytes));
    ++line_;
    return hal::Fault::none;
  }
  hal::Fault wait() {
    print_sum("frame=", frame_++, frame_sum_);
    return hal::Fault::none;
  }

 private:
  static constexpr std::uint32_t kBasis = 2166136261u;

  static std::uint32_t sum(std::uint32_t from, Slice<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) from = (from ^ byte) * 16777619u;
    return from;
  }
  static void print_sum(const char* key, std::uint32_t number, std::uint32_t value) {
    print(key);
    print(number);
    print(" checksum=");
    print(value);
    print("\n");
  }

  std::uint32_t frame_ = 0, frame_sum_ = kBasis;
  std::uint16_t line_ = 0, bottom_ = 0;
};

template <std::uint16_t kWidth, std::uint16_t kHeight, PixelFormat kFormat>
class EmulatedBoard {
 public:
  using Panel = SumPanel<kWidth, kHeight, kFormat>;
  static constexpr Budget fit(const Budget& budget) { return budget; }
  hal::Fault begin() { return hal::Fault::none; }
  Panel& panel() { return panel_; }
  static void light(bool) {}
  static void tick() {}
  [[noreturn]] static void rest() { hal::semihosting::leave(0); }

 private:
  Panel panel_;
};

}  // namespace spanline::boards
