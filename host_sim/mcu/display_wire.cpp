#include "mcu/display_wire.hpp"

#include "panel/models.hpp"

namespace spanline::host {

DisplayWire::DisplayWire(const PanelWiring& wiring, const CoreClock& clock)
    : wiring_(wiring), clock_(clock), model_(make_model(wiring.panel, panel_time_)) {}

void DisplayWire::turn_to(std::uint64_t now) {
  const std::uint64_t ns = clock_.ns_at(now);
  if (ns <= panel_ns_) return;
  panel_time_.advance_ns(ns - panel_ns_);
  panel_ns_ = ns;
}

void DisplayWire::set_pin(PinName pin, bool level, std::uint64_t now, bool in_flight) {
  const bool is_select = pin == wiring_.select, is_data = pin == wiring_.command_data;
  const bool is_reset = wiring_.reset && pin == *wiring_.reset;
  if (!is_select && !is_data && !is_reset) return;
  turn_to(now);
  if (in_flight && (!is_data || level != data_level_)) model_->complain("pin moved with a transfer in flight");
  if (is_select) model_->set_select(level);
  if (is_reset) model_->set_reset(level);
  if (!is_data) return;
  data_level_ = level;
  model_->set_data(level);
}

void DisplayWire::give_pin(PinName pin, bool to_port) {
  if (pin == wiring_.clock) has_clock_ = to_port;
  if (pin == wiring_.data) has_data_ = to_port;
}

std::uint8_t DisplayWire::exchange(std::uint8_t byte, std::uint32_t hz, unsigned mode, const Byte& when) {
  turn_to(when.end);
  if (!has_clock_ || !has_data_) model_->complain("byte while its pins are not the serial port's");
  hz_ = hz;
  bytes_.push_back({when.begin, when.end, takes_pixels()});
  if (!data_level_) writing_ = !wiring_.write_command || byte == *wiring_.write_command;
  model_->shift(byte, hz, mode);
  return 0xFF;
}

std::uint8_t DisplayWire::listen(std::uint32_t hz, const Byte& when) {
  turn_to(when.end);
  return model_->answer(hz);
}

}  // namespace spanline::host
