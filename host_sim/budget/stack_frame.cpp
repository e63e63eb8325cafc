#include "budget/stack_frame.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace spanline::host {
namespace {

constexpr unsigned kSp = 13;
constexpr int kRevisits = 64;  // a loop that still grows then grows without end

struct Value {
  enum class Kind : std::uint8_t { unknown, constant, below_entry, popped };
  Kind kind = Kind::unknown;
  std::uint32_t number = 0;  // the constant, or the distance from the entry's stack pointer (two's complement)

  bool operator==(const Value&) const = default;
};

// The registers before an instruction; SP is one of them, below_entry where all is well.
struct State {
  std::array<Value, 16> r;
  int visits = 0;
};

class Walk {
 public:
  Walk(const Image& image, const Decoder& decoder, std::uint32_t entry) : image_(image), decoder_(decoder) {
    const int index = image.function_at(entry);
    if (index >= 0) {
      const Image::Symbol& function = image.functions()[static_cast<std::size_t>(index)];
      begin_ = function.address;
      end_ = function.address + function.size;
    }
  }

  StackFrame frame(std::uint32_t entry) {
    if (end_ == 0) {
      frame_.problems.push_back("code at " + hex(entry) + " belongs to no function");
      return frame_;
    }
    State first;
    first.r[kSp].kind = Value::Kind::below_entry;
    meet(entry, first);
    drain();
    if (jumps_by_table_) sweep();
    return frame_;
  }

 private:
  bool is_code(std::uint32_t address) const {
    const std::vector<Image::Mapping>& all = image_.mappings();
    const auto after =
        std::upper_bound(all.begin(), all.end(), address,
                         [](std::uint32_t wanted, const Image::Mapping& m) { return wanted < m.address; });
    return after == all.begin() || (after - 1)->code;
  }

  Instruction at(std::uint32_t address) const {
    std::uint16_t halves[2] = {};
    if (!image_.read(address, 4, halves)) image_.read(address, 2, halves);
    return decoder_.decode(address, halves[0], halves[1]);
  }

  void problem(std::uint32_t address, const std::string& text) {
    const std::string line = text + " at " + hex(address) + " in " + image_.name_at(address);
    if (std::find(frame_.problems.begin(), frame_.problems.end(), line) == frame_.problems.end())
      frame_.problems.push_back(line);
  }

  static std::uint32_t depth(const State& state) {
    const auto below = static_cast<std::int32_t>(0u - state.r[kSp].number);
    return below > 0 ? static_cast<std::uint32_t>(below) : 0;
  }

  // Paths that meet keep what they agree on, and the deeper stack.
  void meet(std::uint32_t address, const State& coming) {
    if (address < begin_ || address >= end_ || !is_code(address)) return;  // behind a call that does not return
    const auto [place, is_new] = states_.try_emplace(address, coming);
    if (is_new) {
      work_.push_back(address);
      return;
    }
    State& known = place->second;
    bool changed = false;
    for (std::size_t i = 0; i < known.r.size(); ++i) {
      if (known.r[i] == coming.r[i] || (i != kSp && known.r[i].kind == Value::Kind::unknown)) continue;
      if (i == kSp && depth(coming) <= depth(known)) continue;
      known.r[i] = i == kSp ? coming.r[i] : Value{};
      changed = true;
    }
    if (!changed) return;
    if (++known.visits < kRevisits) {
      work_.push_back(address);
    } else if (known.visits == kRevisits) {
      problem(address, "the stack grows in a loop");
    }
  }

  void drain() {
    while (!work_.empty()) {
      const std::uint32_t address = work_.back();
      work_.pop_back();
      visit(address, states_.at(address));
    }
  }

  void sweep() {
    for (std::uint32_t address = begin_; address < end_;) {
      if (!is_code(address)) {
        address += 2;
        continue;
      }
      if (!states_.contains(address)) {
        State deepest;
        deepest.r[kSp] = {Value::Kind::below_entry, 0u - frame_.depth};
        meet(address, deepest);
        drain();
      }
      address += at(address).size;
    }
  }

  void visit(std::uint32_t address, State state) {
    const Instruction insn = at(address);
    const State before = state;
    apply(insn, state);
    if (state.r[kSp].kind != Value::Kind::below_entry) {
      problem(address, "the stack pointer takes a value that only the run knows");
      state.r[kSp] = before.r[kSp];
    }
    frame_.depth = std::max(frame_.depth, depth(state));
    if (follow(address, insn, before, state)) meet(address + insn.size, state);
  }

  // Notes calls and jumps; true where execution goes on behind the instruction.
  bool follow(std::uint32_t address, const Instruction& insn, const State& before, State& after) {
    const Value target = before.r[insn.a];
    const bool known = target.kind == Value::Kind::constant;
    switch (insn.kind) {
      case Kind::branch:
      case Kind::compare_branch:
        if (insn.target >= begin_ && insn.target < end_) {
          meet(insn.target, after);
        } else {
          call(address, insn.target, before);
        }
        return insn.conditional || conditional_by_it(address);
      case Kind::call:
        return call_or_jump(address, insn.target, before, after);
      case Kind::exchange:
        if (insn.uses_lr && !insn.links) return conditional_by_it(address);
        if (!insn.links && target.kind == Value::Kind::popped) return false;  // ARMv6-M returns by POP {r3}; BX r3
        call(address, known ? target.number & ~1u : 0, before);
        forget_call_clobbered(after);
        return insn.links || conditional_by_it(address);
      case Kind::move_pc:
        if (insn.uses_lr) return conditional_by_it(address);
        if (known) {
          call(address, target.number & ~1u, before);
        } else {
          jumps_by_table_ = true;
        }
        return false;
      case Kind::add_pc:
      case Kind::table_branch:
        jumps_by_table_ = true;
        return false;
      case Kind::load:
      case Kind::load_multiple:
        return !insn.writes_pc || load_pc(address, insn, before);
      default:
        return true;
    }
  }

  bool load_pc(std::uint32_t address, const Instruction& insn, const State& before) {
    const bool returns = insn.address_registers == 1u << kSp;
    std::uint32_t callee = 0;
    if (insn.register_offset) {
      jumps_by_table_ = true;
    } else if (!returns) {
      if (insn.arithmetic.op == Arithmetic::Op::literal) image_.read(insn.arithmetic.immediate, 4, &callee);
      call(address, callee & ~1u, before);
    }
    return conditional_by_it(address);
  }

  // Two calls that do not come back: ARMv6-M jumps far within a function by BL, and after libgcc's helpers for switches
  // the table follows.
  bool call_or_jump(std::uint32_t address, std::uint32_t callee, const State& before, State& after) {
    if (callee > begin_ && callee < end_) {
      meet(callee, after);
      return false;
    }
    if (image_.name_at(callee).starts_with("__gnu_thumb1_case_")) {
      jumps_by_table_ = true;
      call(address, callee, before);
      return false;
    }
    call(address, callee, before);
    forget_call_clobbered(after);
    return true;
  }

  void call(std::uint32_t address, std::uint32_t callee, const State& before) {
    const std::uint32_t live = depth(before);
    for (StackFrame::Call& known : frame_.calls) {
      if (known.at != address || known.callee != callee) continue;
      known.depth = std::max(known.depth, live);
      return;
    }
    frame_.calls.push_back({address, callee, live});
  }

  static void forget_call_clobbered(State& state) {
    for (const unsigned i : {0u, 1u, 2u, 3u, 12u, 14u}) state.r[i] = {};
  }

  // In an IT block, also what looks unconditional may be passed by. At most four instructions behind the IT, 16 bytes.
  bool conditional_by_it(std::uint32_t address) const {
    for (std::uint32_t back = 2; back <= 14 && back <= address - begin_; back += 2) {
      const auto state = states_.find(address - back);
      if (state == states_.end()) continue;
      const Instruction it = at(address - back);
      if (it.kind != Kind::if_then) continue;
      std::uint32_t end = address - back + it.size;
      for (unsigned i = 0; i < it.block; ++i) end += at(end).size;
      return address < end;
    }
    return false;
  }

  void apply(const Instruction& insn, State& state) const {
    const Value sp = state.r[kSp];
    const Value result = result_of(insn.arithmetic, state);
    const bool from_stack =
        (insn.kind == Kind::load || insn.kind == Kind::load_multiple) && insn.address_registers == 1u << kSp;
    for (unsigned i = 0; i < 16; ++i) {
      if ((insn.writes >> i & 1) != 0 && (i != kSp || insn.arithmetic.op != Arithmetic::Op::none)) {
        state.r[i] = {from_stack ? Value::Kind::popped : Value::Kind::unknown, 0};
      }
    }
    if (insn.arithmetic.op != Arithmetic::Op::none) {
      state.r[insn.arithmetic.d] = result;
    } else if (insn.writes_sp()) {
      state.r[kSp] =
          insn.sp_delta != 0 ? Value{sp.kind, sp.number + static_cast<std::uint32_t>(insn.sp_delta)} : Value{};
    }
  }

  Value result_of(const Arithmetic& sum, const State& state) const {
    using Op = Arithmetic::Op;
    using Kind = Value::Kind;
    const Value n = state.r[sum.n], m = state.r[sum.m];
    switch (sum.op) {
      case Op::constant:
        return {Kind::constant, sum.immediate};
      case Op::literal: {
        std::uint32_t word = 0;
        return image_.read(sum.immediate, 4, &word) ? Value{Kind::constant, word} : Value{};
      }
      case Op::add:
        return n.kind == Kind::popped && sum.immediate != 0 ? Value{} : Value{n.kind, n.number + sum.immediate};
      case Op::add_register:
        if (m.kind == Kind::constant && n.kind != Kind::unknown) return {n.kind, n.number + m.number};
        return n.kind == Kind::constant && m.kind == Kind::below_entry ? Value{m.kind, n.number + m.number} : Value{};
      case Op::subtract_register:
        return m.kind == Kind::constant && n.kind != Kind::unknown ? Value{n.kind, n.number - m.number} : Value{};
      case Op::shift_left:
        return n.kind == Kind::constant && sum.immediate < 32 ? Value{n.kind, n.number << sum.immediate} : Value{};
      case Op::negate:
        return n.kind == Kind::constant ? Value{n.kind, 0u - n.number} : Value{};
      case Op::high_half:
        return n.kind == Kind::constant ? Value{n.kind, (n.number & 0xFFFF) | sum.immediate << 16} : Value{};
      default:
        return {};
    }
  }

  const Image& image_;
  const Decoder& decoder_;
  std::uint32_t begin_ = 0, end_ = 0;
  std::map<std::uint32_t, State> states_;
  std::vector<std::uint32_t> work_;
  bool jumps_by_table_ = false;
  StackFrame frame_;
};

}  // namespace

StackFrame stack_frame(const Image& image, const Decoder& decoder, std::uint32_t entry) {
  return Walk(image, decoder, entry).frame(entry);
}

}  // namespace spanline::host
