#include "mcu/decoder.hpp"

#include <capstone/capstone.h>

#include <array>
#include <bit>
#include <stdexcept>

#include "mcu/instruction_kinds.hpp"

namespace spanline::host {
namespace {

constexpr unsigned kSp = 13, kLr = 14, kPc = 15;

// The number of a core register, or 16 for any other.
unsigned number_of(int reg) {
  if (reg >= ARM_REG_R0 && reg <= ARM_REG_R12) return static_cast<unsigned>(reg - ARM_REG_R0);
  return reg == ARM_REG_SP ? kSp : reg == ARM_REG_LR ? kLr : reg == ARM_REG_PC ? kPc : 16;
}

std::uint16_t bit_of(int reg) {
  const unsigned number = number_of(reg);
  return number < 16 ? static_cast<std::uint16_t>(1u << number) : std::uint16_t{0};
}

// ARMv6-M: the 16-bit set without CBZ and IT, and BL, MSR, MRS, the barriers and UDF of the 32-bit one.
bool in_v6m(std::uint16_t first, std::uint16_t second) {
  if (thumb_size(first) == 2) {
    const bool compare_branch = (first & 0xF500) == 0xB100;
    const bool if_then = (first & 0xFF00) == 0xBF00 && (first & 0x000F) != 0;
    return !compare_branch && !if_then;
  }
  if ((first & 0xF800) != 0xF000) return false;
  if ((second & 0xD000) == 0xD000) return true;                                                       // BL
  if ((second & 0xD000) != 0x8000) return (first & 0xFFF0) == 0xF7F0 && (second & 0xF000) == 0xA000;  // UDF
  return (first & 0xFFE0) == 0xF380 || first == 0xF3BF || (first & 0xFFF0) == 0xF3E0;
}

bool supported(Core core, const cs_detail& detail, std::uint16_t first, std::uint16_t second) {
  if (core == Core::m0 || core == Core::m0plus) return in_v6m(first, second);
  if (core != Core::m3) return true;
  for (unsigned i = 0; i < detail.groups_count; ++i) {
    const unsigned group = detail.groups[i];
    if (group == ARM_GRP_VFP2 || group == ARM_GRP_VFP3 || group == ARM_GRP_VFP4 || group == ARM_GRP_THUMB2DSP)
      return false;
  }
  return true;
}

// The words of VLDR, VLDM and their kin: eight bits of the encoding count them.
std::uint8_t float_words(unsigned id, std::uint16_t second) {
  if (id == ARM_INS_VLDR || id == ARM_INS_VSTR) return (second & 0x0100) != 0 ? 2 : 1;
  return static_cast<std::uint8_t>(second & 0xFF);
}

bool is_float_transfer(unsigned id) {
  constexpr std::array<unsigned, 8> kIds = {ARM_INS_VLDR,   ARM_INS_VSTR,   ARM_INS_VLDMIA, ARM_INS_VLDMDB,
                                            ARM_INS_VSTMIA, ARM_INS_VSTMDB, ARM_INS_VPUSH,  ARM_INS_VPOP};
  for (const unsigned known : kIds) {
    if (id == known) return true;
  }
  return false;
}

void fill_registers(Instruction& to, const cs_arm& arm) {
  for (unsigned i = 0; i < arm.op_count; ++i) {
    const cs_arm_op& operand = arm.operands[i];
    if (operand.type == ARM_OP_MEM) {
      to.address_registers = static_cast<std::uint16_t>(bit_of(operand.mem.base) | bit_of(operand.mem.index));
      to.register_offset = operand.mem.index != ARM_REG_INVALID;
    }
  }
}

bool is_stack(unsigned id) {
  return id == ARM_INS_PUSH || id == ARM_INS_POP || id == ARM_INS_VPUSH || id == ARM_INS_VPOP;
}

// A list of registers follows the address in LDM and STM, it stands alone in PUSH and POP.
void fill_list(Instruction& to, const cs_insn& insn, std::uint16_t second) {
  const cs_arm& arm = insn.detail->arm;
  const bool stack = is_stack(insn.id);
  if (to.address_registers == 0) to.address_registers = stack ? std::uint16_t{1u << kSp} : bit_of(arm.operands[0].reg);
  if (is_float_transfer(insn.id)) {
    to.count = float_words(insn.id, second);
  } else {
    to.count = static_cast<std::uint8_t>(arm.op_count - (stack ? 0 : 1));
  }
}

void fill_control(Instruction& to, const cs_insn& insn) {
  const cs_arm& arm = insn.detail->arm;
  const cs_arm_op& last = arm.operands[arm.op_count == 0 ? 0 : arm.op_count - 1];
  to.links = insn.id == ARM_INS_BL || insn.id == ARM_INS_BLX;
  to.conditional =
      to.kind == Kind::compare_branch || (to.kind == Kind::branch && arm.cc != ARM_CC_AL && arm.cc != ARM_CC_INVALID);
  if (last.type == ARM_OP_IMM &&
      (to.kind == Kind::branch || to.kind == Kind::call || to.kind == Kind::compare_branch)) {
    to.direct = true;
    to.target = static_cast<std::uint32_t>(last.imm) & ~1u;
  }
  if (to.kind == Kind::exchange || to.kind == Kind::branch || to.kind == Kind::call) to.writes_pc = true;
  if (to.kind == Kind::compare_branch || to.kind == Kind::table_branch) to.writes_pc = true;
  if (to.kind == Kind::alu && to.writes_pc) to.kind = insn.id == ARM_INS_ADD ? Kind::add_pc : Kind::move_pc;
  if (to.kind == Kind::exchange || to.kind == Kind::move_pc) {
    to.uses_lr = last.type == ARM_OP_REG && last.reg == ARM_REG_LR;
    if (last.type == ARM_OP_REG) to.a = static_cast<std::uint8_t>(number_of(last.reg) & 15);
  }
}

// PUSH, POP and transfers with write-back at SP.
std::int32_t sp_delta_of(const Instruction& insn, const cs_arm& arm, bool stack) {
  const auto sp = std::uint16_t{1u << kSp};
  if (!insn.touches_memory() || insn.address_registers != sp || (!stack && !insn.write_back)) return 0;
  if (insn.kind == Kind::load_multiple) return 4 * insn.count;
  if (insn.kind == Kind::store_multiple) return -4 * insn.count;
  const cs_arm_op& last = arm.operands[arm.op_count - 1];
  return last.type == ARM_OP_IMM   ? (last.subtracted ? -last.imm : last.imm)
         : last.type == ARM_OP_MEM ? last.mem.disp
                                   : 0;
}

Arithmetic::Op add_or_subtract(unsigned id) {
  if (id == ARM_INS_ADD || id == ARM_INS_ADDW) return Arithmetic::Op::add_register;
  return id == ARM_INS_SUB || id == ARM_INS_SUBW ? Arithmetic::Op::subtract_register : Arithmetic::Op::none;
}

Arithmetic arithmetic_of(const cs_insn& insn) {
  using Op = Arithmetic::Op;
  const cs_arm& arm = insn.detail->arm;
  if (arm.op_count < 2 || arm.operands[0].type != ARM_OP_REG || number_of(arm.operands[0].reg) > kPc) return {};
  const auto core = [&](unsigned i) { return static_cast<std::uint8_t>(number_of(arm.operands[i].reg) & 15); };
  const cs_arm_op& last = arm.operands[arm.op_count - 1];
  const bool plain = last.type == ARM_OP_REG && last.shift.type == ARM_SFT_INVALID && number_of(last.reg) <= kPc;
  const bool immediate = last.type == ARM_OP_IMM;
  const auto value = static_cast<std::uint32_t>(immediate ? last.imm : 0);
  const std::uint8_t d = core(0), n = arm.op_count >= 3 ? core(1) : d;
  if (insn.id == ARM_INS_MOV || insn.id == ARM_INS_MOVW) {
    if (immediate) return {Op::constant, d, 0, 0, value};
    if (plain) return {Op::add, d, core(1), 0, 0};
  }
  if (insn.id == ARM_INS_MVN && immediate) return {Op::constant, d, 0, 0, ~value};
  if (insn.id == ARM_INS_MOVT && immediate) return {Op::high_half, d, d, 0, value};
  if (insn.id == ARM_INS_LSL && immediate) return {Op::shift_left, d, core(1), 0, value};
  if (insn.id == ARM_INS_RSB && immediate && value == 0) return {Op::negate, d, core(1), 0, 0};
  const Op sum = add_or_subtract(insn.id);
  if (sum != Op::none && immediate) return {Op::add, d, n, 0, sum == Op::add_register ? value : 0u - value};
  if (sum != Op::none && plain) return {sum, d, n, core(arm.op_count - 1u), 0};
  const bool literal = insn.id == ARM_INS_LDR && last.type == ARM_OP_MEM && last.mem.base == ARM_REG_PC &&
                       last.mem.index == ARM_REG_INVALID;
  if (!literal) return {};
  const std::uint32_t base = (static_cast<std::uint32_t>(insn.address) + 4) & ~3u;
  return {Op::literal, d, 0, 0, base + static_cast<std::uint32_t>(last.mem.disp)};
}

}  // namespace

struct Decoder::Engine {
  csh handle = 0;
  cs_insn* insn = nullptr;
};

Decoder::Decoder(Core core) : core_(core), engine_(std::make_unique<Engine>()) {
  const auto mode = static_cast<cs_mode>(CS_MODE_THUMB | CS_MODE_MCLASS);
  if (cs_open(CS_ARCH_ARM, mode, &engine_->handle) != CS_ERR_OK) throw std::runtime_error("capstone does not know Arm");
  cs_option(engine_->handle, CS_OPT_DETAIL, CS_OPT_ON);
  engine_->insn = cs_malloc(engine_->handle);
}

Decoder::~Decoder() {
  cs_free(engine_->insn, 1);
  cs_close(&engine_->handle);
}

Instruction Decoder::decode(std::uint32_t address, std::uint16_t first, std::uint16_t second) const {
  const std::uint8_t bytes[4] = {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(first >> 8),
                                 static_cast<std::uint8_t>(second), static_cast<std::uint8_t>(second >> 8)};
  Instruction to;
  to.size = thumb_size(first);
  if (to.size == 2 && (first & 0xFF00) == 0xBF00 && (first & 0x000F) != 0) {
    // The lowest set bit of the mask ends the block.
    to.kind = Kind::if_then;
    to.block = static_cast<std::uint8_t>(4 - std::countr_zero(static_cast<unsigned>(first & 0x000F)));
    to.supported = core_ != Core::m0 && core_ != Core::m0plus;
    return to;
  }
  const std::uint8_t* code = bytes;
  std::size_t left = to.size;
  std::uint64_t place = address;
  if (!cs_disasm_iter(engine_->handle, &code, &left, &place, engine_->insn)) {
    to.known = false;
    to.supported = (core_ != Core::m0 && core_ != Core::m0plus) || in_v6m(first, second);
    return to;
  }
  const cs_insn& insn = *engine_->insn;
  const cs_arm& arm = insn.detail->arm;
  to.kind = kind_of(insn.id);
  to.write_back = arm.writeback;
  to.waits = insn.id == ARM_INS_WFI || insn.id == ARM_INS_WFE;
  to.supported = supported(core_, *insn.detail, first, second);
  cs_regs read, written;
  std::uint8_t reads = 0, writes = 0;
  if (cs_regs_access(engine_->handle, &insn, read, &reads, written, &writes) == CS_ERR_OK) {
    for (unsigned i = 0; i < writes; ++i) to.writes |= bit_of(written[i]);
  }
  to.writes_pc = (to.writes & 1u << kPc) != 0;
  fill_registers(to, arm);
  if (to.kind == Kind::load_multiple || to.kind == Kind::store_multiple) fill_list(to, insn, second);
  if (to.kind >= Kind::multiply && to.kind <= Kind::divide_signed && arm.op_count >= 2) {
    to.a = static_cast<std::uint8_t>(number_of(arm.operands[arm.op_count - 2].reg) & 15);
    to.b = static_cast<std::uint8_t>(number_of(arm.operands[arm.op_count - 1].reg) & 15);
  }
  const auto is_core = [&](unsigned i) {
    return arm.operands[i].type == ARM_OP_REG && number_of(arm.operands[i].reg) < 16;
  };
  if (insn.id == ARM_INS_VMOV && arm.op_count >= 3 && (is_core(0) ? is_core(1) : is_core(1) || is_core(2))) {
    to.kind = Kind::float_pair;
  }
  fill_control(to, insn);
  to.sp_delta = sp_delta_of(to, arm, is_stack(insn.id));
  to.arithmetic = arithmetic_of(insn);
  return to;
}

}  // namespace spanline::host
