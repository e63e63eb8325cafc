#include "mcu/core_state.hpp"

#include <unicorn/unicorn.h>

#include <stdexcept>

#include "mcu/image.hpp"

namespace spanline::host {
namespace {

int id_of(unsigned number) {
  if (number <= 12) return UC_ARM_REG_R0 + static_cast<int>(number);
  return number == CoreState::kSp ? UC_ARM_REG_SP : number == CoreState::kLr ? UC_ARM_REG_LR : UC_ARM_REG_PC;
}

constexpr std::uint32_t kFlags = 0xF800'0000;  // N, Z, C, V, Q
constexpr std::uint32_t kFrameBytes = 32;

}  // namespace

CoreState::CoreState() {
  if (uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_THUMB | UC_MODE_MCLASS), &uc_) != UC_ERR_OK) {
    throw std::runtime_error("unicorn has no Cortex-M");
  }
}

CoreState::~CoreState() { uc_close(uc_); }

std::uint32_t CoreState::special(int id) const {
  std::uint32_t value = 0;
  uc_reg_read(uc_, id, &value);
  return value;
}

std::uint32_t CoreState::reg(unsigned number) const { return special(id_of(number)); }

void CoreState::set_reg(unsigned number, std::uint32_t value) { uc_reg_write(uc_, id_of(number), &value); }

bool CoreState::interrupts_masked() const { return (special(UC_ARM_REG_PRIMASK) & 1) != 0; }

bool CoreState::read(std::uint32_t address, std::uint32_t size, void* out) const {
  return uc_mem_read(uc_, address, out, size) == UC_ERR_OK;
}

bool CoreState::write(std::uint32_t address, std::uint32_t size, const void* from) {
  return uc_mem_write(uc_, address, from, size) == UC_ERR_OK;
}

std::optional<std::uint8_t> CoreState::byte(std::uint32_t address) const {
  std::uint8_t value = 0;
  return read(address, 1, &value) ? std::optional(value) : std::nullopt;
}

std::uint16_t CoreState::halfword(std::uint32_t address) const {
  std::uint16_t value = 0;
  read(address, sizeof value, &value);
  return value;
}

std::string CoreState::registers() const {
  std::string text;
  for (unsigned i = 0; i < kPc; ++i) {
    const std::string name = i == kSp ? "sp" : i == kLr ? "lr" : "r" + std::to_string(i);
    text += name + "=" + hex(reg(i)) + " ";
  }
  return text + "xpsr=" + hex(special(UC_ARM_REG_XPSR));
}

// The frame is aligned to 8 bytes; a bit of the stacked status remembers whether that took a word.
void CoreState::enter_exception(std::uint32_t handler, std::uint32_t next) {
  constexpr std::uint32_t kThumb = 1u << 24, kAligned = 1u << 9, kToThread = 0xFFFF'FFF9;
  const std::uint32_t sp = reg(kSp), aligned = (sp & 4) != 0 ? kAligned : 0;
  const std::uint32_t flags = special(UC_ARM_REG_XPSR) & kFlags;
  const std::uint32_t frame[8] = {reg(0), reg(1), reg(2), reg(3), reg(12), reg(kLr), next, flags | kThumb | aligned};
  const std::uint32_t below = sp - kFrameBytes - (sp & 4);
  write(below, kFrameBytes, frame);
  set_reg(kSp, below);
  set_reg(kLr, kToThread);
  in_exception_ = true;
  go_to(handler);
}

std::uint32_t CoreState::leave_exception() {
  std::uint32_t frame[8] = {};
  const std::uint32_t sp = reg(kSp);
  read(sp, kFrameBytes, frame);
  for (unsigned i = 0; i < 4; ++i) set_reg(i, frame[i]);
  set_reg(12, frame[4]);
  set_reg(kLr, frame[5]);
  set_reg(kSp, sp + kFrameBytes + ((frame[7] & 1u << 9) != 0 ? 4 : 0));
  const std::uint32_t flags = frame[7] & kFlags;
  uc_reg_write(uc_, UC_ARM_REG_APSR_NZCVQ, &flags);
  in_exception_ = false;
  go_to(frame[6]);
  return frame[6];
}

}  // namespace spanline::host
