// Core cycles of Cortex-M0, M0+, M3 and M4 at zero wait states. What flash and bus add is not in them.
#pragma once

#include <cstdint>

#include "mcu/board.hpp"
#include "mcu/instruction.hpp"

namespace spanline::host {

// How an instruction went.
struct Execution {
  std::uint32_t address = 0;       // of the instruction
  bool taken = false;              // it went elsewhere than to the next one
  std::uint32_t next = 0;          // where it went
  std::uint8_t next_size = 2;      // bytes of the instruction there
  std::uint32_t data_address = 0;  // first datum's, of loads and stores
  std::uint8_t data_size = 0;      // bytes of that datum, 0: none was touched
  std::uint32_t a = 0, b = 0;      // operands of divide and long multiply
};

class CycleModel {
 public:
  // `core` must have a model (has_cycle_model).
  explicit CycleModel(Core core);

  // Cycles of the next instruction executed. Order matters: neighbours overlap.
  unsigned step(const Instruction& now, const Execution& how) {
    if (now.kind != Kind::alu || fetches_slowly(how.address)) return step_of_any(now, how);
    previous_ = {now.kind, now.size, now.write_back, now.writes_pc, now.writes, 0, 1};
    return 1;
  }

  // Whether the time of such an instruction depends on what it multiplies or divides: Execution::a and b.
  static bool asks_for_operands(Core core, Kind kind) {
    const bool divides = kind == Kind::divide_unsigned || kind == Kind::divide_signed;
    return divides || (core == Core::m3 && (kind == Kind::long_multiply || kind == Kind::long_multiply_accumulate));
  }

  // Cycles from an interrupt to its handler's first instruction.
  unsigned enter_exception() const;

  // Cycles of an instruction that its IT block skips.
  unsigned skip();

 private:
  struct Rules;
  static const Rules& rules_of(Core core);
  static bool fetches_slowly(std::uint32_t address) { return address >> 29 == 1; }  // from SRAM, over the system bus
  unsigned step_of_any(const Instruction& now, const Execution& how);
  unsigned own_cycles(const Instruction& now, const Execution& how) const;
  unsigned load_cycles(const Instruction& now, const Execution& how) const;
  unsigned store_cycles(const Instruction& now) const;
  unsigned jump_cycles(const Instruction& now, const Execution& how) const;
  unsigned fetch_stall(const Instruction& now, const Execution& how, unsigned cycles);

  // Of the instruction before, what its neighbour's time depends on.
  struct Previous {
    Kind kind = Kind::alu;
    std::uint8_t size = 2;
    bool write_back = false, writes_pc = false;
    std::uint16_t writes = 0;
    std::uint32_t data_address = 0;
    unsigned cycles = 1;
  };

  const Rules& rules_;
  bool is_m3_;
  Previous previous_;
  unsigned fetched_ = 0;  // halfwords in the prefetch buffer, of code in SRAM
};

}  // namespace spanline::host
