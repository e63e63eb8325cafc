#include "mcu/machine.hpp"

#include <unicorn/unicorn.h>

#include <optional>

#include "assetc/input_error.hpp"
#include "mcu/cycle_model.hpp"
#include "mcu/decoded_code.hpp"
#include "mcu/semihosting.hpp"
#include "mcu/system_registers.hpp"

namespace spanline::host {
namespace {

constexpr std::uint16_t kSemihosting = 0xBEAB;
constexpr std::uint32_t kNowhere = 1;  // odd: no instruction lies there
constexpr std::uint64_t kNeverReached = 0xFFFF'FFFE;

// Of QEMU's target/arm/cpu.h.
enum Exception : std::uint32_t { kUndefined = 1, kSupervisorCall = 2, kBreakpoint = 7, kExceptionReturn = 8 };

class Machine {
 public:
  Machine(const Image& image, const BoardDescription& board, const RunOptions& options);
  ~Machine() { uc_close(uc_); }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  RunReport run();

 private:
  void map_memory();
  void add_hooks();
  const DecodedCode::Entry& decoded(std::uint32_t address);
  void on_code(std::uint32_t address);
  void on_access(std::uint32_t address, std::uint32_t size);
  void on_interrupt(std::uint32_t number);
  void settle(std::uint32_t next, std::uint8_t next_size);
  void charge(std::uint32_t function, unsigned cycles);
  void semihost();
  void enter_marks(std::uint32_t address);
  void finish_passage();
  void watch_stack(std::uint32_t address);
  void end(const std::string& why);
  void fail(const std::string& what);
  std::uint32_t reg(int id) const;
  std::uint32_t core_reg(unsigned number) const;
  std::string registers() const;
  std::uint64_t now() const { return model_ ? total_.cycles : total_.instructions; }
  std::string place(std::uint32_t address) const { return hex(address) + " in " + image_.name_at(address); }

  const Image& image_;
  const BoardDescription& board_;
  const RunOptions& options_;
  uc_engine* uc_ = nullptr;
  std::optional<CycleModel> model_;
  SystemRegisters system_;
  DecodedCode code_;
  std::uint32_t from_ = kNowhere, until_ = kNowhere;
  bool counting_ = true, ended_ = false;
  const DecodedCode::Entry* current_ = nullptr;
  std::uint32_t current_address_ = 0, block_end_ = 0;
  Execution how_;
  bool sp_changed_ = true;
  Count total_, begin_;
  std::vector<Count> functions_, functions_at_begin_;
  std::uint32_t lowest_sp_ = 0, deepest_at_ = 0;
  std::string failure_;
  RunReport report_;
};

Machine::Machine(const Image& image, const BoardDescription& board, const RunOptions& options)
    : image_(image), board_(board), options_(options), code_(image, board.core) {
  if (has_cycle_model(board.core)) model_.emplace(board.core);
  if (!options.from.empty()) from_ = image.address_of(options.from) & ~1u;
  if (!options.until.empty()) until_ = image.address_of(options.until) & ~1u;
  counting_ = options.from.empty();
  functions_.resize(image.functions().size() + 1);
  functions_at_begin_ = functions_;
  report_.functions = functions_;
  if (uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_THUMB | UC_MODE_MCLASS), &uc_) != UC_ERR_OK) {
    throw std::runtime_error("unicorn has no Cortex-M");
  }
  map_memory();
  add_hooks();
}

void Machine::map_memory() {
  for (const BoardDescription::Memory& memory : board_.memories) {
    const std::uint32_t rights = memory.flash ? UC_PROT_READ | UC_PROT_EXEC : UC_PROT_ALL;
    uc_mem_map(uc_, memory.base, memory.size, rights);
  }
  for (const Image::Segment& segment : image_.segments()) {
    uc_mem_write(uc_, segment.load_address, segment.bytes.data(), segment.bytes.size());
  }
  const auto read = [](uc_engine*, std::uint64_t offset, unsigned, void* self) -> std::uint64_t {
    Machine& machine = *static_cast<Machine*>(self);
    const std::uint32_t address = SystemRegisters::kBase + static_cast<std::uint32_t>(offset);
    const std::optional<std::uint32_t> value = machine.system_.read(address, machine.now());
    if (!value) machine.fail("reads the register " + hex(address) + ", which is not modelled");
    return value.value_or(0);
  };
  const auto write = [](uc_engine*, std::uint64_t offset, unsigned, std::uint64_t value, void* self) {
    Machine& machine = *static_cast<Machine*>(self);
    const std::uint32_t address = SystemRegisters::kBase + static_cast<std::uint32_t>(offset);
    if (!machine.system_.write(address, static_cast<std::uint32_t>(value), machine.now())) {
      machine.fail("writes the register " + hex(address) + ", which is not modelled");
    }
  };
  uc_mmio_map(uc_, SystemRegisters::kBase, SystemRegisters::kBytes, read, this, write, this);
}

void Machine::add_hooks() {
  using OnCode = void (*)(uc_engine*, std::uint64_t, std::uint32_t, void*);
  using OnAccess = void (*)(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
  using OnMissing = bool (*)(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
  using OnInterrupt = void (*)(uc_engine*, std::uint32_t, void*);
  const OnCode code = [](uc_engine*, std::uint64_t address, std::uint32_t, void* self) {
    static_cast<Machine*>(self)->on_code(static_cast<std::uint32_t>(address));
  };
  const OnAccess access = [](uc_engine*, uc_mem_type, std::uint64_t address, int size, std::int64_t, void* self) {
    static_cast<Machine*>(self)->on_access(static_cast<std::uint32_t>(address), static_cast<std::uint32_t>(size));
  };
  const OnMissing missing = [](uc_engine*, uc_mem_type type, std::uint64_t address, int, std::int64_t, void* self) {
    const bool write = type == UC_MEM_WRITE_UNMAPPED || type == UC_MEM_WRITE_PROT;
    const bool fetch = type == UC_MEM_FETCH_UNMAPPED || type == UC_MEM_FETCH_PROT;
    const bool flash = type == UC_MEM_WRITE_PROT;
    static_cast<Machine*>(self)->fail(std::string(write   ? "writes "
                                                  : fetch ? "executes "
                                                          : "reads ") +
                                      hex(static_cast<std::uint32_t>(address)) +
                                      (flash ? ", which is flash" : ", where nothing is modelled"));
    return false;
  };
  const OnInterrupt interrupt = [](uc_engine*, std::uint32_t number, void* self) {
    static_cast<Machine*>(self)->on_interrupt(number);
  };
  // The library takes any function pointer as void*; a hook of an empty range concerns all addresses.
  uc_hook hook = 0;
  const auto add = [&](int type, auto callback) {
    uc_hook_add(uc_, &hook, type, reinterpret_cast<void*>(callback), this, std::uint64_t{1}, std::uint64_t{0});
  };
  add(UC_HOOK_CODE, code);
  add(UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, access);
  add(UC_HOOK_MEM_INVALID, missing);
  add(UC_HOOK_INTR, interrupt);
}

std::uint32_t Machine::reg(int id) const {
  std::uint32_t value = 0;
  uc_reg_read(uc_, id, &value);
  return value;
}

std::uint32_t Machine::core_reg(unsigned number) const {
  if (number <= 12) return reg(UC_ARM_REG_R0 + static_cast<int>(number));
  return reg(number == 13 ? UC_ARM_REG_SP : number == 14 ? UC_ARM_REG_LR : UC_ARM_REG_PC);
}

std::string Machine::registers() const {
  std::string text;
  for (unsigned i = 0; i < 15; ++i) {
    text += (i == 0 ? "" : " ") +
            (i == 13   ? std::string("sp")
             : i == 14 ? "lr"
                       : "r" + std::to_string(i)) +
            "=" + hex(core_reg(i));
  }
  return text + " xpsr=" + hex(reg(UC_ARM_REG_XPSR));
}

void Machine::end(const std::string& why) {
  if (!ended_) report_.end = why;
  ended_ = true;
  uc_emu_stop(uc_);
}

void Machine::fail(const std::string& what) {
  if (failure_.empty()) failure_ = what + ", at " + place(current_address_) + "; " + registers();
  end("fault");
}

const DecodedCode::Entry& Machine::decoded(std::uint32_t address) {
  return code_.at(address, [&](std::uint32_t from) {
    std::uint16_t half = 0;
    uc_mem_read(uc_, from, &half, sizeof half);
    return half;
  });
}

void Machine::charge(std::uint32_t function, unsigned cycles) {
  const Count one{1, cycles};
  total_ += one;
  functions_[function] += one;
}

// The instruction before is over: where it went tells what it cost.
void Machine::settle(std::uint32_t next, std::uint8_t next_size) {
  if (current_ == nullptr) return;
  const Instruction& insn = current_->insn;
  std::uint32_t expected = current_address_ + insn.size;
  how_.address = current_address_;
  how_.taken = next != expected && insn.writes_pc;
  how_.next = next;
  how_.next_size = next_size;
  charge(current_->function, model_ ? model_->step(insn, how_) : 0);
  if (!insn.known) ++report_.unknown;
  // Hooks are not called for what an IT block skips, but it is executed as far as time is concerned.
  while (!insn.writes_pc && expected < next && next <= block_end_) {
    const DecodedCode::Entry& skipped = decoded(expected);
    charge(skipped.function, model_ ? model_->skip() : 0);
    expected += skipped.insn.size;
  }
  current_ = nullptr;
}

void Machine::watch_stack(std::uint32_t address) {
  const std::uint32_t sp = reg(UC_ARM_REG_SP);
  if (sp >= lowest_sp_) return;
  lowest_sp_ = sp;
  deepest_at_ = address;
}

void Machine::finish_passage() {
  counting_ = false;
  report_.passages.push_back(total_ - begin_);
  for (std::size_t i = 0; i < functions_.size(); ++i) report_.functions[i] += functions_[i] - functions_at_begin_[i];
}

void Machine::enter_marks(std::uint32_t address) {
  if (address == until_ && counting_) {
    finish_passage();
    if (options_.from.empty() || report_.passages.size() == options_.passages) end("reached " + options_.until);
  }
  if (address == from_ && !counting_ && !ended_) {
    counting_ = true;
    begin_ = total_;
    functions_at_begin_ = functions_;
  }
}

void Machine::on_code(std::uint32_t address) {
  if (ended_) return;
  const DecodedCode::Entry& here = decoded(address);
  const Instruction& insn = here.insn;
  const std::uint32_t before = current_address_;
  settle(address, insn.size);
  if (sp_changed_) watch_stack(before);
  current_address_ = address;
  enter_marks(address);
  if (ended_) return;
  current_ = &here;
  sp_changed_ = insn.writes_sp();
  how_ = Execution{};
  if (!insn.supported) return fail(std::string("executes an instruction that a ") + name(board_.core) + " lacks");
  if (insn.kind >= Kind::long_multiply && insn.kind <= Kind::divide_signed && model_) {
    how_.a = core_reg(insn.a);
    how_.b = core_reg(insn.b);
  }
  if (insn.kind == Kind::if_then) {
    block_end_ = address + insn.size;
    for (unsigned i = 0; i < insn.block; ++i) block_end_ += decoded(block_end_).insn.size;
  }
  if (insn.kind == Kind::branch && insn.direct && insn.target == address) return end("spins at " + place(address));
  if (insn.waits) return end("waits for an interrupt at " + place(address));
  if (total_.instructions >= options_.limit) {
    fail("has not stopped after " + std::to_string(options_.limit) + " instructions");
  }
}

void Machine::on_access(std::uint32_t address, std::uint32_t size) {
  if (current_ == nullptr) return;
  if (how_.data_size == 0) {
    how_.data_address = address;
    how_.data_size = static_cast<std::uint8_t>(size);
  }
  const bool aligned_only = board_.core == Core::m0 || board_.core == Core::m0plus || !current_->insn.is_single();
  const std::uint32_t unit = size > 4 ? 4 : size;
  if (aligned_only && current_->insn.touches_memory() && address % unit != 0) {
    fail("touches " + std::to_string(size) + " bytes at the unaligned address " + hex(address));
  }
}

void Machine::semihost() {
  const auto read = [&](std::uint32_t address) -> std::optional<std::uint8_t> {
    std::uint8_t byte = 0;
    return uc_mem_read(uc_, address, &byte, 1) == UC_ERR_OK ? std::optional(byte) : std::nullopt;
  };
  const std::uint32_t operation = reg(UC_ARM_REG_R0);
  const std::uint64_t microseconds = now() * 1000 / board_.kilohertz;
  const SemihostingAnswer answer =
      answer_semihosting(operation, reg(UC_ARM_REG_R1), read, microseconds, report_.output);
  if (!answer.known) return fail("asks for the semihosting operation " + hex(operation) + ", which is not modelled");
  if (answer.exit_code) {
    report_.exit_code = *answer.exit_code;
    return end("exit " + std::to_string(*answer.exit_code));
  }
  uc_reg_write(uc_, UC_ARM_REG_R0, &answer.r0);
  const std::uint32_t next = (current_address_ + 2) | 1;
  uc_reg_write(uc_, UC_ARM_REG_PC, &next);
}

void Machine::on_interrupt(std::uint32_t number) {
  if (ended_) return;
  if (number == kBreakpoint) {
    std::uint16_t code = 0;
    uc_mem_read(uc_, current_address_, &code, sizeof code);
    return code == kSemihosting ? semihost() : end("BKPT at " + place(current_address_));
  }
  if (number == kSupervisorCall) return end("SVC at " + place(current_address_));
  fail(number == kUndefined ? "executes an undefined instruction" : "raises the exception " + std::to_string(number));
}

RunReport Machine::run() {
  const StartState start = start_of(image_, board_);
  uc_reg_write(uc_, UC_ARM_REG_SP, &start.sp);
  report_.initial_sp = start.sp;
  for (const auto& [address, value] : options_.words) uc_mem_write(uc_, address, &value, sizeof value);
  lowest_sp_ = start.sp;
  deepest_at_ = start.pc;
  current_address_ = start.pc;
  const uc_err error = uc_emu_start(uc_, start.pc | 1, kNeverReached, 0, 0);
  if (failure_.empty() && !ended_) fail(std::string("stops: ") + uc_strerror(error));
  if (!failure_.empty()) throw InputError(image_.path(), failure_);
  settle(current_address_, 2);
  if (until_ == kNowhere && counting_) finish_passage();
  if (report_.passages.empty()) {
    throw InputError(image_.path(), "does not reach " +
                                        (options_.until.empty() || !counting_ ? options_.from : options_.until) + ": " +
                                        report_.end);
  }
  for (const Count& passage : report_.passages) report_.total += passage;
  report_.stack_reached = start.sp - lowest_sp_;
  report_.stack_deepest = image_.name_at(deepest_at_);
  return report_;
}

}  // namespace

Count& Count::operator+=(const Count& other) {
  instructions += other.instructions;
  cycles += other.cycles;
  return *this;
}

Count Count::operator-(const Count& other) const { return {instructions - other.instructions, cycles - other.cycles}; }

RunReport run_image(const Image& image, const BoardDescription& board, const RunOptions& options) {
  Machine machine(image, board, options);
  return machine.run();
}

}  // namespace spanline::host
