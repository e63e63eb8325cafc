// Solomon Systech OLED controllers: commands and their arguments both come with D/C low.
#pragma once

#include <cstdint>
#include <vector>

#include "panel/panel_model.hpp"

namespace spanline::host {

// A command and the number of its arguments.
struct SsdCommand {
  std::uint8_t first, last;  // of a range of codes
  std::uint8_t arguments;
};

// Gathers the arguments and refuses what the controller does not know.
class SsdModel : public PanelModel {
 public:
  SsdModel(const WireLimits& wire, const SimClock& clock, std::vector<SsdCommand> commands)
      : PanelModel(wire, clock), known_(std::move(commands)) {}

 protected:
  struct Range {
    unsigned first = 0, last = 0;
    bool given = false;  // since the reset
  };

  // Both ends inclusive, of `size` addresses.
  Range range(unsigned size);

  // The place of the next data byte in the window: across, then down. False, with a complaint, where none is open or it
  // is full.
  struct Place {
    unsigned column, row;
  };
  bool next_place(Place& place);
  void restart_window();

  virtual void clear() = 0;
  virtual void carry_out(std::uint8_t code) = 0;

  std::vector<std::uint8_t> arguments_;
  Range columns_, rows_;
  bool on_ = false;

 private:
  void reset_state() final;
  void take_command(std::uint8_t byte) final;

  std::vector<SsdCommand> known_;
  std::uint8_t command_ = 0;
  unsigned wanted_ = 0;
  Place next_{};
  bool full_ = false;
};

}  // namespace spanline::host
