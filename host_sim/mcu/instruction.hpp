// One decoded Thumb instruction: what the cycle rules and the stack analysis ask about it.
#pragma once

#include <cstdint>

namespace spanline::host {

enum class Kind : std::uint8_t {
  alu,                       // everything of one cycle that is nothing below
  multiply,                  // MUL
  multiply_accumulate,       // MLA, MLS
  long_multiply,             // UMULL, SMULL
  long_multiply_accumulate,  // UMLAL, SMLAL
  divide_unsigned,
  divide_signed,
  load,            // one register; LDR PC, too
  store,           // one register
  load_multiple,   // LDM, POP, VLDM
  store_multiple,  // STM, PUSH, VSTM
  load_pair,       // LDRD
  store_pair,      // STRD
  branch,          // B, Bcc
  call,            // BL
  compare_branch,  // CBZ, CBNZ
  exchange,        // BX, BLX
  move_pc,         // MOV PC
  add_pc,          // ADD PC
  table_branch,    // TBB, TBH
  if_then,
  special,    // MRS, MSR
  exclusive,  // LDREX, STREX and their kin
  barrier,
  float_accumulate,  // VMLA, VFMA and their kin
  float_divide,      // VDIV, VSQRT
  float_pair,        // VMOV between two core registers and the float unit
};

// What an instruction does to a core register, as far as stack frames are made of it.
struct Arithmetic {
  enum class Op : std::uint8_t {
    none,
    constant,
    literal,
    add,
    add_register,
    subtract_register,
    shift_left,
    negate,
    high_half
  };
  Op op = Op::none;
  std::uint8_t d = 0, n = 0, m = 0;  // d = n + immediate, d = n ± m, d = n << immediate, d = -n
  std::uint32_t immediate = 0;       // of `literal`: the address that it is loaded from
};

struct Instruction {
  Kind kind = Kind::alu;
  std::uint8_t size = 2;         // bytes
  std::uint8_t count = 0;        // registers (words) of a multiple transfer
  std::uint8_t block = 0;        // instructions that an IT governs
  std::uint8_t a = 0, b = 0;     // operands of divide and long multiply, numbers of core registers
  bool known = true;             // false: the decoder has no name for it
  bool supported = true;         // false: the core lacks it
  bool register_offset = false;  // of a load or store
  bool write_back = false;       // the address register changes
  bool writes_pc = false;
  bool uses_lr = false;                 // BX LR, MOV PC, LR
  bool links = false;                   // BL, BLX
  bool conditional = false;             // Bcc, CBZ, CBNZ
  bool waits = false;                   // WFI, WFE
  bool direct = false;                  // `target` is where it goes
  std::uint16_t address_registers = 0;  // bit r: core register r forms the address
  std::uint16_t writes = 0;             // bit r: core register r is written
  std::uint32_t target = 0;
  std::int32_t sp_delta = 0;  // of transfers that move SP, bytes
  Arithmetic arithmetic;

  bool writes_sp() const { return (writes & 1u << 13) != 0; }
  bool is_single() const { return kind == Kind::load || kind == Kind::store; }
  bool touches_memory() const { return kind >= Kind::load && kind <= Kind::store_pair; }
};

}  // namespace spanline::host
