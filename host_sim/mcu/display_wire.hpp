// The wire from a chip to its panel: pins and bytes in the chip's time, and the record of what crossed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "mcu/core_clock.hpp"
#include "mcu/wiring.hpp"
#include "panel/panel_model.hpp"
#include "sim/picture.hpp"

namespace spanline::host {

class DisplayWire {
 public:
  // One byte on the wire, in core cycles.
  struct Byte {
    std::uint64_t begin, end;
    bool pixel;  // no command and no argument
  };

  DisplayWire(const PanelWiring& wiring, const CoreClock& clock);

  const PanelWiring& wiring() const { return wiring_; }

  // A pin takes a level; nothing happens where the panel does not hang on it. `in_flight`: a byte is on the wire.
  void set_pin(PinName pin, bool level, std::uint64_t now, bool in_flight);

  // A pin of the serial port is, or is no longer, the port's.
  void give_pin(PinName pin, bool to_port);

  // One byte at the end of its eight clocks; returns what came in meanwhile: nothing is wired, so
  // ones.
  std::uint8_t exchange(std::uint8_t byte, std::uint32_t hz, unsigned mode, const Byte& when);

  // One byte that the panel says on the data line while the port does not drive it.
  std::uint8_t listen(std::uint32_t hz, const Byte& when);

  // What the panel shows to a viewer for whom the picture is upright.
  Picture picture() const { return turned(model_->picture(), wiring_.rotation); }

  // What went against the panel's protocol.
  const std::vector<std::string>& complaints() const { return model_->complaints(); }

  // Every byte so far, in order.
  const std::vector<Byte>& bytes() const { return bytes_; }
  std::uint32_t hz() const { return hz_; }  // of the last byte
  // Whether a byte given to the port now is of a pixel.
  bool takes_pixels() const { return data_level_ && writing_; }

 private:
  void turn_to(std::uint64_t now);

  PanelWiring wiring_;
  const CoreClock& clock_;
  SimClock panel_time_;
  std::uint64_t panel_ns_ = 0;
  std::unique_ptr<PanelModel> model_;
  bool data_level_ = false, has_clock_ = false, has_data_ = false;
  bool writing_ = false;  // what comes with D/C high are pixels
  std::vector<Byte> bytes_;
  std::uint32_t hz_ = 0;
};

}  // namespace spanline::host
