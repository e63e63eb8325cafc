#include "mcu/chip.hpp"

#include <algorithm>

namespace spanline::host {

Chip::Chip(const BoardDescription& board, std::uint32_t reset_kilohertz, std::size_t fifo, ReadByte read)
    : clock_(reset_kilohertz), wire_(*board.panel, clock_), port_(wire_, fifo), read_(std::move(read)) {}

Peripheral* Chip::peripheral_at(std::uint32_t address) const {
  for (const std::unique_ptr<Peripheral>& peripheral : peripherals_) {
    if (address - peripheral->base() < peripheral->bytes()) return peripheral.get();
  }
  return nullptr;
}

void Chip::complain(const std::string& what) {
  if (std::find(complaints_.begin(), complaints_.end(), what) == complaints_.end()) complaints_.push_back(what);
}

void Chip::feed(std::uint64_t at) {
  while (dma_wanted_ && dma_.active && dma_.left != 0 && !port_.full()) {
    const std::optional<std::uint8_t> byte = read_(dma_.from);
    if (!byte) {
      dma_.failed = true;
      dma_.active = false;
      return;
    }
    port_.push(*byte, at);
    ++dma_bytes_;
    dma_.from += dma_.step ? 1 : 0;
    if (--dma_.left == 0) dma_.active = false;
  }
}

void Chip::advance(std::uint64_t now) {
  while (port_.next_event() <= now) {
    now_ = port_.next_event();
    port_.end_byte();
    feed(now_);
  }
  now_ = now;
}

std::unique_ptr<Chip> make_chip(const BoardDescription& board, ReadByte read) {
  switch (board.family) {
    case BoardDescription::Family::lm3s6965:
      return make_lm3s6965(board, std::move(read));
    case BoardDescription::Family::stm32f4:
      return make_stm32f4(board, std::move(read));
    case BoardDescription::Family::rp2040:
      return make_rp2040(board, std::move(read));
    default:
      return nullptr;
  }
}

}  // namespace spanline::host
