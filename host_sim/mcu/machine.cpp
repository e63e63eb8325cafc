#include "mcu/machine.hpp"

#include <unicorn/unicorn.h>

#include <algorithm>
#include <optional>
#include <set>

#include "assetc/input_error.hpp"
#include "mcu/chip.hpp"
#include "mcu/core_hooks.hpp"
#include "mcu/core_state.hpp"
#include "mcu/cycle_model.hpp"
#include "mcu/decoded_code.hpp"
#include "mcu/ledger.hpp"
#include "mcu/marks.hpp"
#include "mcu/memory_map.hpp"
#include "mcu/pool_watch.hpp"
#include "mcu/semihosting.hpp"
#include "mcu/stack_watch.hpp"
#include "mcu/system_registers.hpp"

namespace spanline::host {
namespace {

constexpr std::uint16_t kSemihosting = 0xBEAB;
constexpr std::uint64_t kNeverReached = 0xFFFF'FFFE;
constexpr std::uint32_t kFarJump = 0x1000;  // bytes ahead: no branch within a function

// Of QEMU's target/arm/cpu.h.
enum Exception : std::uint32_t { kUndefined = 1, kSupervisorCall = 2, kBreakpoint = 7, kExceptionReturn = 8 };

// Executes, keeps the time, and tells everybody else what happened when.
class Machine final : private RegisterAccess {
 public:
  Machine(const Image& image, const BoardDescription& board, const RunOptions& options);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  ~Machine() = default;
  RunReport run();

 private:
  friend CoreHooks<Machine>;

  StartState reset();
  const DecodedCode::Entry& decoded(std::uint32_t address);
  void on_code(std::uint32_t address);
  void on_access(bool write, std::uint32_t address, std::uint32_t size);
  void on_interrupt(std::uint32_t number);
  std::uint32_t read_register(std::uint32_t address, unsigned size) override;
  void write_register(std::uint32_t address, unsigned size, std::uint32_t value) override;
  Peripheral* device_at(std::uint32_t address, unsigned size, const char* verb);
  void settle(std::uint32_t next, std::uint8_t next_size);
  bool serve_events(std::uint32_t address);
  void plan_events();
  void semihost();
  void enter_marks(std::uint32_t address);
  void end_frame();
  void begin_line();
  void end_making();
  void watch_stack(std::uint32_t address);
  void end(const std::string& why);
  void fail(const std::string& what);
  void fill_report(const StartState& start);
  // Cycles since reset.
  std::uint64_t now() const {
    if (options_.as_emulator) return clock_.cycle_at(ledger_.total().instructions);
    return model_ ? ledger_.total().time() : ledger_.total().instructions;
  }
  std::string place(std::uint32_t address) const { return hex(address) + " in " + image_.name_at(address); }

  const Image& image_;
  const BoardDescription& board_;
  const RunOptions& options_;
  const Marks marks_;
  CoreState core_;
  MemoryMap map_{core_, *this};
  std::unique_ptr<Chip> chip_;
  MemoryTiming no_timing_;
  MemoryTiming& timing_;
  CoreClock fixed_clock_;
  const CoreClock& clock_;
  std::optional<CycleModel> model_;
  SystemRegisters system_;
  DebugInfo debug_;
  DecodedCode code_;
  PoolWatch pools_;
  Ledger ledger_;
  WaitFinder waits_;
  StackWatch stack_;
  std::optional<FrameRecorder> frames_;
  std::uint32_t vectors_ = 0;
  std::uint32_t line_made_ = Marks::kNowhere;
  bool counting_, ended_ = false;
  const DecodedCode::Entry* current_ = nullptr;
  std::uint32_t current_address_ = 0, block_end_ = 0;
  std::uint64_t next_event_ = 0;
  unsigned stall_ = 0;
  Execution how_;
  bool sp_changed_ = true;
  std::string failure_;
  RunReport report_;
};

Machine::Machine(const Image& image, const BoardDescription& board, const RunOptions& options)
    : image_(image),
      board_(board),
      options_(options),
      marks_(find_marks(image, options)),
      chip_(make_chip(board, [this](std::uint32_t address) { return core_.byte(address); })),
      timing_(chip_ && !options.as_emulator ? chip_->memory() : no_timing_),
      fixed_clock_(board.kilohertz),
      clock_(chip_ ? chip_->clock() : fixed_clock_),
      debug_(image.path()),
      code_(image, debug_, board.core),
      pools_(image, debug_),
      ledger_(image.functions().size()),
      counting_(options.from.empty()) {
  if (has_cycle_model(board.core) && !options.as_emulator) model_.emplace(board.core);
  if (chip_ && options.as_emulator) chip_->send_in_no_time();
  if (marks_.frame_begin != Marks::kNowhere) frames_.emplace();
  map_.map_memories(board, image);
  map_.map_registers(SystemRegisters::kBase, SystemRegisters::kBytes);
  std::set<std::uint32_t> pages;
  if (chip_) {
    for (const auto& peripheral : chip_->peripherals()) pages.insert(peripheral->base() / MemoryMap::kPage);
  }
  for (const std::uint32_t page : pages) map_.map_registers(page * MemoryMap::kPage, MemoryMap::kPage);
  CoreHooks<Machine>::add(core_.engine(), this);
}

void Machine::end(const std::string& why) {
  if (!ended_) report_.end = why;
  ended_ = true;
  uc_emu_stop(core_.engine());
}

void Machine::fail(const std::string& what) {
  if (failure_.empty()) failure_ = what + ", at " + place(current_address_) + "; " + core_.registers();
  end("fault");
}

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
  const std::optional<WaitFinder::Wait> wait = waits_.asked(current_address_, now());
  if (wait) {
    ledger_.charge_waiting(wait->begin);
    if (frames_) frames_->waited(wait->begin, wait->end);
  }
  ledger_.asked();
  return value.value_or(0);
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

const DecodedCode::Entry& Machine::decoded(std::uint32_t address) {
  return code_.at(address, [&](std::uint32_t from) { return core_.halfword(from); });
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
  ledger_.charge(*current_, {1, model_ ? model_->step(insn, how_) : 0, stall_, 0});
  if (!insn.known) ++report_.unknown;
  // Hooks are not called for what an IT block skips, but it is executed as far as time is concerned.
  while (!insn.writes_pc && expected < next && next <= block_end_) {
    const DecodedCode::Entry& skipped = decoded(expected);
    ledger_.charge(skipped, {1, model_ ? model_->skip() : 0, 0, 0});
    expected += skipped.insn.size;
  }
  if (how_.taken) {
    if (insn.links) {
      ledger_.calls().call(expected);
    } else if (!insn.direct || next < expected || next - expected > kFarJump) {
      ledger_.calls().jump(next);
    }
  }
  current_ = nullptr;
}

void Machine::watch_stack(std::uint32_t address) {
  const std::uint32_t sp = core_.reg(CoreState::kSp);
  if (stack_.deeper(sp)) stack_.reach(sp, address, ledger_.calls().node());
}

void Machine::end_frame() {
  if (chip_) chip_->advance(now());
  frames_->end_frame(ledger_, chip_ ? chip_->wire().bytes() : std::vector<DisplayWire::Byte>{});
}

void Machine::begin_line() {
  line_made_ = core_.reg(CoreState::kLr) & ~1u;
  frames_->begin_line(chip_ ? chip_->pixels_promised() : 0, ledger_);
}

// Frame::next_line() returns whether there was a line.
void Machine::end_making() {
  line_made_ = Marks::kNowhere;
  if ((core_.reg(0) & 0xFF) == 0) frames_->no_line();
}

void Machine::enter_marks(std::uint32_t address) {
  if (address == marks_.until && counting_) {
    counting_ = false;
    ledger_.end();
    if (options_.from.empty() || ledger_.passages().size() == options_.passages) end("reached " + options_.until);
  }
  if (address == marks_.from && !counting_ && !ended_) {
    counting_ = true;
    ledger_.begin();
  }
  if (address == marks_.main) pools_.clear();
  if (address == marks_.frame_begin) frames_->begin_frame(ledger_);
  if (address == marks_.next_line) begin_line();
  if (address == line_made_) end_making();
  if (address == marks_.frame_end) end_frame();
}

void Machine::on_code(std::uint32_t address) {
  if (ended_) return;
  const DecodedCode::Entry& here = decoded(address);
  const Instruction& insn = here.insn;
  const std::uint32_t before = current_address_;
  settle(address, insn.size);
  if (sp_changed_) watch_stack(before);
  if (now() >= next_event_ && serve_events(address)) return;
  current_address_ = address;
  enter_marks(address);
  if (ended_) return;
  ledger_.calls().at(here.place, code_.places());
  current_ = &here;
  sp_changed_ = insn.writes_sp();
  how_ = Execution{};
  stall_ = timing_.fetch(address, now());
  if (!insn.supported) return fail(std::string("executes an instruction that a ") + name(board_.core) + " lacks");
  if (insn.kind >= Kind::long_multiply && insn.kind <= Kind::divide_signed && model_) {
    how_.a = core_.reg(insn.a);
    how_.b = core_.reg(insn.b);
  }
  if (insn.kind == Kind::if_then) {
    block_end_ = address + insn.size;
    for (unsigned i = 0; i < insn.block; ++i) block_end_ += decoded(block_end_).insn.size;
  }
  if (insn.kind == Kind::branch && insn.direct && insn.target == address) return end("spins at " + place(address));
  if (insn.waits) return end("waits for an interrupt at " + place(address));
  if (ledger_.total().instructions >= options_.limit) {
    fail("has not stopped after " + std::to_string(options_.limit) + " instructions");
  }
}

void Machine::on_access(bool write, std::uint32_t address, std::uint32_t size) {
  if (current_ == nullptr) return;
  if (write) {
    waits_.stored();
    ledger_.forget_recent();
    pools_.written(address);
  } else {
    stall_ += timing_.read(address);
  }
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
  const std::uint32_t operation = core_.reg(0);
  const std::uint64_t microseconds = clock_.ns_at(now()) / 1000;
  const SemihostingAnswer answer = answer_semihosting(
      operation, core_.reg(1), [this](std::uint32_t address) { return core_.byte(address); }, microseconds,
      report_.output);
  if (!answer.known) return fail("asks for the semihosting operation " + hex(operation) + ", which is not modelled");
  if (answer.exit_code) {
    report_.exit_code = *answer.exit_code;
    return end("exit " + std::to_string(*answer.exit_code));
  }
  core_.set_reg(0, answer.r0);
  core_.go_to(current_address_ + 2);
}

void Machine::on_interrupt(std::uint32_t number) {
  if (ended_) return;
  if (number == kExceptionReturn && core_.in_exception()) {
    core_.leave_exception();
    ledger_.calls().resume();
    sp_changed_ = true;
    return;
  }
  if (number == kBreakpoint) {
    return core_.halfword(current_address_) == kSemihosting ? semihost() : end("BKPT at " + place(current_address_));
  }
  if (number == kSupervisorCall) return end("SVC at " + place(current_address_));
  fail(number == kUndefined ? "executes an undefined instruction" : "raises the exception " + std::to_string(number));
}

// A second-stage boot runs as the boot ROM leaves it: copied to the end of RAM, and nobody to return to.
StartState Machine::reset() {
  StartState start = start_of(image_, board_);
  vectors_ = start.vectors;
  core_.set_reg(CoreState::kSp, start.sp);
  core_.set_reg(CoreState::kLr, start.boots_by == 0 ? UINT32_MAX : 0);
  if (start.boots_by == 0) return start;
  std::uint8_t boot[kSecondStageBoot];
  const BoardDescription::Memory& ram = board_.memories.back();
  const std::uint32_t to = ram.base + ram.size - kSecondStageBoot;
  image_.read(start.boots_by, sizeof boot, boot);
  core_.write(to, sizeof boot, boot);
  core_.set_reg(CoreState::kSp, to);
  start.pc = to;
  return start;
}

void Machine::fill_report(const StartState& start) {
  report_.timed = model_.has_value();
  report_.passages = ledger_.passages();
  report_.functions = ledger_.functions();
  for (const Count& passage : report_.passages) report_.total += passage;
  report_.initial_sp = start.sp;
  report_.stack_reached = start.sp - stack_.lowest();
  report_.stack_deepest = image_.name_at(stack_.deepest_at());
  report_.calls = ledger_.calls();
  report_.places = code_.places().all();
  report_.pools = pools_.pools();
  for (const std::uint32_t frame : report_.calls.callers_of(stack_.deepest_node())) {
    report_.stack_path.push_back(report_.places[frame].name);
  }
  for (std::size_t i = 0; i < image_.functions().size(); ++i) {
    if (ledger_.all_functions()[i].instructions != 0) report_.executed.push_back(image_.functions()[i].name);
  }
  if (frames_) report_.frames = frames_->frames();
  if (!chip_) return;
  const DisplayWire& wire = chip_->wire();
  report_.panel = PanelReport{wire.picture(), wire.complaints(), wire.hz(), wire.bytes().size(), chip_->dma_bytes()};
  const std::vector<std::string>& more = chip_->complaints();
  report_.panel->complaints.insert(report_.panel->complaints.end(), more.begin(), more.end());
}

RunReport Machine::run() {
  const StartState start = reset();
  for (const auto& [address, value] : options_.words) core_.write(address, sizeof value, &value);
  stack_.begin(start.sp, start.pc);
  current_address_ = start.pc;
  plan_events();
  const uc_err error = uc_emu_start(core_.engine(), start.pc | 1, kNeverReached, 0, 0);
  if (failure_.empty() && !ended_) fail(std::string("stops: ") + uc_strerror(error));
  if (!failure_.empty()) throw InputError(image_.path(), failure_);
  settle(current_address_, 2);
  if (options_.until.empty() && counting_) ledger_.end();
  if (ledger_.passages().empty()) {
    throw InputError(image_.path(), "does not reach " +
                                        (options_.until.empty() || !counting_ ? options_.from : options_.until) + ": " +
                                        report_.end);
  }
  fill_report(start);
  return report_;
}

}  // namespace

RunReport run_image(const Image& image, const BoardDescription& board, const RunOptions& options) {
  Machine machine(image, board, options);
  return machine.run();
}

}  // namespace spanline::host
