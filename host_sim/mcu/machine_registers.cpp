// What the core reads and writes outside its memory, and what happens there in time.
#include <algorithm>

#include "mcu/emulated_machine.hpp"

namespace spanline::host {
namespace {

constexpr std::uint64_t kLongWait = 1000;  // cycles: turns that something ends earlier are not worth telling apart

}  // namespace

// Null after a failure.
Peripheral* Machine::device_at(std::uint32_t address, unsigned size, const char* verb) {
  Peripheral* const device = chip_ ? chip_->peripheral_at(address) : nullptr;
  const auto refuse = [&](const std::string& why) {
    fail(std::string(verb) + " the register " + hex(address) + why);
    return nullptr;
  };
  if (device == nullptr) return refuse(", which is not modelled");
  if (!device->alive()) return refuse(" of " + device->name() + ", which has no clock or is in reset");
  if (size != 4 || address % 4 != 0) return refuse(" by " + std::to_string(size) + " bytes, words are modelled");
  chip_->advance(now());
  return device;
}

std::uint32_t Machine::read_register(std::uint32_t address, unsigned size) {
  std::optional<std::uint32_t> value;
  if (address - SystemRegisters::kBase < SystemRegisters::kBytes) {
    value = system_.read(address, now());
  } else if (Peripheral* const device = device_at(address, size, "reads")) {
    value = device->read(address - device->base());
  }
  if (!value) fail("reads the register " + hex(address) + ", which is not modelled");
  if (!turns_.replaying()) note_question();
  return value.value_or(0);
}

// The current instruction reads a register.
void Machine::note_question() {
  const std::optional<WaitFinder::Wait> wait = waits_.asked(current_address_, now());
  if (wait) {
    ledger_.charge_waiting(wait->begin);
    if (frames_) frames_->waited(wait->begin, wait->end);
    const bool replays = model_ && !options_.as_emulator && !options_.step_by_step;
    if (replays && turns_.idle() && next_event_ - now() > kLongWait) turns_.arm(current_address_);
  }
  ledger_.asked();
  turns_.record_question();
}

void Machine::write_register(std::uint32_t address, unsigned size, std::uint32_t value) {
  bool known = false;
  if (address - SystemRegisters::kBase < SystemRegisters::kBytes) {
    known = system_.write(address, value, now());
  } else if (Peripheral* const device = device_at(address, size, "writes")) {
    known = device->write(address - device->base(), value);
    if (frames_) frames_->gave(chip_->pixels_given(), ledger_);
  }
  if (!known) fail("writes the register " + hex(address) + ", which is not modelled");
  plan_events();
}

void Machine::plan_events() {
  next_event_ = system_.next_tick();
  if (chip_) next_event_ = std::min(next_event_, chip_->next_event());
}

// True where an interrupt is taken before the instruction at `address`.
bool Machine::serve_events(std::uint32_t address) {
  if (chip_) {
    chip_->advance(now());
    if (frames_) frames_->gave(chip_->pixels_given(), ledger_);
  }
  const bool between_blocks = address >= block_end_ || address < current_address_;
  const bool tick =
      system_.next_tick() <= now() && between_blocks && !core_.in_exception() && !core_.interrupts_masked();
  if (tick) {
    constexpr std::uint32_t kTickVector = 15 * 4;
    std::uint32_t handler = 0;
    core_.read((system_.vectors() != 0 ? system_.vectors() : vectors_) + kTickVector, sizeof handler, &handler);
    system_.take_tick(now());
    core_.enter_exception(handler & ~1u, address);
    ledger_.calls().interrupt();
    if (model_) ledger_.charge(decoded(handler & ~1u), {0, model_->enter_exception(), 0, 0});
    sp_changed_ = true;
  }
  plan_events();
  return tick;
}

}  // namespace spanline::host
