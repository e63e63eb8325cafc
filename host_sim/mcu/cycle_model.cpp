#include "mcu/cycle_model.hpp"

#include <algorithm>
#include <bit>

namespace spanline::host {

// Sources: ARM DDI 0337 (M3), DDI 0439 (M4), DDI 0432 (M0), DDI 0484 (M0+), and counts of an STM32F100's cycle counter
// (M3). A jump's column is what it adds to its one cycle, or to its load's, when taken.
struct CycleModel::Rules {
  bool overlaps;                  // neighbours interact: the pipelined bus of M3 and M4
  std::uint8_t multiply;          // MUL: the fast multiplier where there is a choice (RP2040, nRF51)
  std::uint8_t accumulate;        // MLA, MLS
  bool long_multiply_by_operand;  // else 1
  std::uint8_t branch, call, exchange_lr, exchange, move_pc, add_pc, compare_branch, load_pc, table_branch;
  std::uint8_t special;  // MRS, MSR
  std::uint8_t barrier;
  std::uint8_t exception;  // entry; the return is about as long
  std::uint8_t io_port;    // a load or store at the single-cycle I/O port, 0: there is none
};

const CycleModel::Rules& CycleModel::rules_of(Core core) {
  // clang-format off
  //                          over- mul mla long   b  bl bxlr bx mov add cbz ldr tbb spec bar exc io
  //                          laps           mul               pc  pc      pc
  static constexpr Rules kM0     {false, 1, 1, false, 2, 3, 2, 2, 2, 2, 0, 3, 0, 4, 4, 16, 0};
  static constexpr Rules kM0plus {false, 1, 1, false, 1, 2, 1, 1, 1, 1, 0, 2, 0, 3, 3, 15, 1};
  static constexpr Rules kM3     {true,  1, 2, true,  1, 1, 1, 2, 2, 3, 2, 3, 4, 2, 4, 12, 0};
  static constexpr Rules kM4     {true,  1, 1, false, 1, 1, 1, 2, 2, 3, 2, 3, 4, 2, 4, 12, 0};
  // clang-format on
  switch (core) {
    case Core::m0:
      return kM0;
    case Core::m0plus:
      return kM0plus;
    case Core::m3:
      return kM3;
    default:
      return kM4;
  }
}

namespace {

constexpr std::uint32_t kIoPort = 0xD000'0000;  // to 0xDFFF'FFFF
constexpr unsigned kFetchBuffer = 6;            // halfwords

// Code, SRAM, peripherals, external RAM…: each region of 512 MB is a memory of its own to the bus.
std::uint32_t memory_of(std::uint32_t address) { return address >> 29; }

bool at_odd_halfword(std::uint32_t address) { return (address & 2) != 0; }

// The M3's early exit, found on silicon.
unsigned long_multiply(std::uint32_t a, std::uint32_t b, unsigned one_large, unsigned both_large) {
  constexpr std::uint32_t kHalf = 1u << 16;
  if (a == 0 || b == 0 || (a < kHalf && b < kHalf)) return 3;
  if ((a < kHalf) != (b < kHalf)) return one_large;
  return both_large + ((a & 0xFFFF) != 0 ? 1u : 0u) + ((b & 0xFFFF) != 0 ? 1u : 0u);
}

// Four bits of quotient a cycle.
unsigned divide(std::uint32_t a, std::uint32_t b) {
  if (a == 0 || b == 0) return 2;
  const int more_bits = std::countl_zero(b) - std::countl_zero(a);
  return more_bits < 0 ? 3 : std::min(5u + static_cast<unsigned>(more_bits) / 4, 12u);
}

std::uint32_t magnitude(std::uint32_t value) { return static_cast<std::int32_t>(value) < 0 ? 0u - value : value; }

unsigned unaligned(const Execution& how) {
  if (how.data_size == 2) return how.data_address & 1;
  if (how.data_size == 4) return (how.data_address & 1) != 0 ? 2 : (how.data_address & 2) != 0 ? 1 : 0;
  return 0;
}

bool is_alu(Kind kind) { return kind == Kind::alu || kind == Kind::multiply; }

}  // namespace

CycleModel::CycleModel(Core core) : rules_(rules_of(core)), is_m3_(core == Core::m3) { previous_.kind = Kind::barrier; }

unsigned CycleModel::load_cycles(const Instruction& now, const Execution& how) const {
  if (rules_.io_port != 0 && how.data_address >> 28 == kIoPort >> 28) return rules_.io_port;
  if (!rules_.overlaps) return 2;
  const bool same_memory = memory_of(how.data_address) == memory_of(previous_.data_address);
  if (previous_.kind == Kind::store) return same_memory ? 3 : 2;
  if (previous_.kind != Kind::load || previous_.writes_pc || !same_memory) return 2;
  const bool loaded_its_address = (previous_.writes & now.address_registers) != 0;
  const bool wide_and_odd = now.size == 4 && at_odd_halfword(how.address);
  const bool write_back = is_m3_ && (now.write_back || previous_.write_back);
  return loaded_its_address || wide_and_odd || write_back ? 2 : 1;
}

unsigned CycleModel::store_cycles(const Instruction& now) const {
  if (!rules_.overlaps) return 2;
  return now.register_offset && previous_.kind != Kind::load ? 2 : 1;
}

// What a taken jump adds.
unsigned CycleModel::jump_cycles(const Instruction& now, const Execution& how) const {
  if (!how.taken) return 0;
  unsigned cycles = 0;
  bool fetched_early = false;  // B and BL are seen at decode, while their predecessor still executes
  switch (now.kind) {
    case Kind::branch:
      cycles = rules_.branch;
      fetched_early = previous_.cycles >= 2;
      break;
    case Kind::call:
      cycles = rules_.call;
      fetched_early = previous_.cycles >= 2;
      break;
    case Kind::exchange:
    case Kind::move_pc:
      cycles = now.uses_lr ? rules_.exchange_lr : now.kind == Kind::exchange ? rules_.exchange : rules_.move_pc;
      break;
    case Kind::add_pc:
      cycles = rules_.add_pc;
      break;
    case Kind::compare_branch:
      cycles = rules_.compare_branch;
      break;
    case Kind::load:
    case Kind::load_multiple:
      cycles = rules_.load_pc;
      break;
    case Kind::table_branch:
      cycles = rules_.table_branch;
      break;
    default:
      return 0;
  }
  const bool two_fetches = rules_.overlaps && how.next_size == 4 && at_odd_halfword(how.next) && !fetched_early;
  return cycles + (two_fetches ? 1 : 0);
}

unsigned CycleModel::own_cycles(const Instruction& now, const Execution& how) const {
  switch (now.kind) {
    case Kind::multiply:
      return rules_.multiply;
    case Kind::multiply_accumulate:
      return rules_.accumulate;
    case Kind::long_multiply:
      return rules_.long_multiply_by_operand ? long_multiply(how.a, how.b, 4, 3) : 1;
    case Kind::long_multiply_accumulate:
      return rules_.long_multiply_by_operand ? long_multiply(how.a, how.b, 5, 5) : 1;
    case Kind::divide_unsigned:
      return divide(how.a, how.b);
    case Kind::divide_signed:
      return divide(magnitude(how.a), magnitude(how.b));
    case Kind::load:
      return load_cycles(now, how);
    case Kind::store:
      return rules_.io_port != 0 && how.data_address >> 28 == kIoPort >> 28 ? rules_.io_port : store_cycles(now);
    case Kind::load_multiple:
    case Kind::store_multiple:
      return 1u + now.count;
    case Kind::load_pair:
    case Kind::store_pair:
    case Kind::float_accumulate:
      return 3;
    case Kind::table_branch:
    case Kind::exclusive:
    case Kind::float_pair:
      return 2;
    case Kind::if_then:  // folded into a 16-bit neighbour
      return previous_.size == 2 && !previous_.writes_pc ? 0 : 1;
    case Kind::special:
      return rules_.special;
    case Kind::barrier:
      return rules_.barrier;
    case Kind::float_divide:
      return 14;
    default:
      return 1;
  }
}

// A word of code in SRAM takes two cycles; jumps begin with the word that their own cycles brought.
unsigned CycleModel::fetch_stall(const Instruction& now, const Execution& how, unsigned cycles) {
  if (!rules_.overlaps || !fetches_slowly(how.address)) return 0;
  const unsigned wanted = now.size / 2u;
  fetched_ = std::min(fetched_ + cycles, kFetchBuffer);
  const unsigned stall = wanted > fetched_ ? wanted - fetched_ : 0;
  fetched_ = how.taken ? 1 : fetched_ + stall - wanted;
  return stall;
}

unsigned CycleModel::step_of_any(const Instruction& now, const Execution& how) {
  unsigned cycles = own_cycles(now, how);
  const bool address_just_made = is_alu(previous_.kind) && (previous_.writes & now.address_registers) != 0;
  if (rules_.overlaps && now.touches_memory() && address_just_made) ++cycles;
  if (now.touches_memory()) cycles += unaligned(how);
  cycles += jump_cycles(now, how);
  cycles += fetch_stall(now, how, cycles);
  if (now.kind == Kind::if_then && cycles == 0) return 0;  // neighbours overlap as though it were not there
  previous_ = {now.kind, now.size, now.write_back, now.writes_pc, now.writes, how.data_address, cycles};
  return cycles;
}

unsigned CycleModel::enter_exception() const { return rules_.exception; }

unsigned CycleModel::skip() {
  const std::uint32_t data_address = previous_.data_address;
  previous_ = {};
  previous_.data_address = data_address;
  return previous_.cycles;
}

}  // namespace spanline::host
