// A MIPI DCS colour controller and its glass.
#pragma once

#include <cstdint>
#include <vector>

#include "panel/panel_model.hpp"

namespace spanline::host {

// What holds a controller's own registers back until it is undone.
enum class Lock : std::uint8_t { none, st7796, gc9a01 };

struct DcsGlass {
  WireLimits wire;
  std::uint16_t ram_width, ram_height;             // px
  std::uint16_t width, height, left = 0, top = 0;  // the part of the memory that is seen, px
  bool mirrored = false;                           // source 0 is at the glass's right edge
  bool bgr = false;                                // the subpixels' order on the glass
  bool inverted = false;                           // the glass shows the complement of what INVOFF sends it
  bool only_18_bit = false;
  std::uint8_t own_from = 0xB0;  // the lowest command of the controller's own
  Lock lock = Lock::none;
};

class DcsModel final : public PanelModel {
 public:
  DcsModel(const DcsGlass& glass, const SimClock& clock);

  Picture picture() const override;

 private:
  struct Range {
    unsigned first = 0, last = 0;
    bool given = false;  // since the reset
  };

  void reset_state() override;
  void take_command(std::uint8_t code) override;
  void take_data(std::uint8_t byte) override;
  std::uint8_t give_answer() override;

  void end_command();
  void check_state(std::uint8_t code);
  bool own(std::uint8_t code) const { return code >= glass_.own_from; }
  bool locked(std::uint8_t code) const;
  void carry_out();
  void sleep_out();
  void set_depth(std::uint8_t colmod);
  Range range(unsigned size);
  void begin_write();
  void take_pixel_byte(std::uint8_t byte);
  void put_pixel();
  void step();

  DcsGlass glass_;
  Picture memory_;  // as sent: no inversion, no colour order
  std::uint8_t command_ = 0;
  unsigned wanted_ = 0;  // arguments of the command
  std::vector<std::uint8_t> arguments_;
  std::uint8_t madctl_ = 0, function_ = 0;  // 36h, second byte of B6h
  unsigned depth_ = 3;                      // bytes a pixel
  bool asleep_ = true, on_ = false, invert_ = false, writing_ = false, full_ = false;
  unsigned unlocked_ = 0;  // bit 0: part I or FEh, bit 1: part II or EFh
  std::uint64_t awake_ns_ = 0;
  Range columns_, rows_;
  unsigned column_ = 0, row_ = 0;
  std::uint8_t pixel_[3] = {};
  unsigned pixel_bytes_ = 0;
};

}  // namespace spanline::host
