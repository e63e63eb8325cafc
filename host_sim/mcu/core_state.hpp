// The core of an emulated machine: its registers, its memory, and one level of exceptions. Unicorn executes, this is
// what the rest sees of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

struct uc_struct;

namespace spanline::host {

class CoreState {
 public:
  static constexpr unsigned kSp = 13, kLr = 14, kPc = 15;

  CoreState();
  ~CoreState();
  CoreState(const CoreState&) = delete;
  CoreState& operator=(const CoreState&) = delete;

  uc_struct* engine() const { return uc_; }

  std::uint32_t reg(unsigned number) const;
  void set_reg(unsigned number, std::uint32_t value);
  // Execution goes on at `address`, Thumb code.
  void go_to(std::uint32_t address) { set_reg(kPc, address | 1); }
  bool interrupts_masked() const;

  bool read(std::uint32_t address, std::uint32_t size, void* out) const;
  bool write(std::uint32_t address, std::uint32_t size, const void* from);
  std::optional<std::uint8_t> byte(std::uint32_t address) const;
  std::uint16_t halfword(std::uint32_t address) const;

  // "r0=0x00000000 … lr=0x… xpsr=0x…".
  std::string registers() const;

  // Stacks the registers as the core does and goes to `handler`; `next` is the instruction not yet executed.
  void enter_exception(std::uint32_t handler, std::uint32_t next);
  // Back to what was stacked; returns where that is.
  std::uint32_t leave_exception();
  bool in_exception() const { return in_exception_; }

 private:
  std::uint32_t special(int id) const;

  uc_struct* uc_ = nullptr;
  bool in_exception_ = false;
};

}  // namespace spanline::host
