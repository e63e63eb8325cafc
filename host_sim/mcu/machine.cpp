#include "mcu/machine.hpp"

#include <unicorn/unicorn.h>

#include <set>

#include "assetc/input_error.hpp"
#include "mcu/emulated_machine.hpp"
#include "mcu/semihosting.hpp"

namespace spanline::host {
namespace {

constexpr std::uint16_t kSemihosting = 0xBEAB;
constexpr std::uint64_t kNeverReached = 0xFFFF'FFFE;
constexpr std::uint32_t kFarJump = 0x1000;  // bytes ahead: no branch within a function

// Of QEMU's target/arm/cpu.h.
enum Exception : std::uint32_t { kUndefined = 1, kSupervisorCall = 2, kBreakpoint = 7, kExceptionReturn = 8 };

}  // namespace

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
      code_(image, debug_, board.core, marks_),
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
  leave_replay();
  if (!ended_) report_.end = why;
  ended_ = true;
  uc_emu_stop(core_.engine());
}

void Machine::fail(const std::string& what) {
  leave_replay();
  if (failure_.empty()) failure_ = what + ", at " + place(current_address_) + "; " + core_.registers();
  end("fault");
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
  if (ended_ || replays(address)) return;
  const DecodedCode::Entry& here = decoded(address);
  const std::uint32_t before = current_address_;
  settle(address, here.insn.size);
  if (sp_changed_) watch_stack(before);
  if (now() >= next_event_ && serve_events(address)) return turns_.cancel();
  current_address_ = address;
  if (here.marked || address == line_made_) enter_marks(address);
  if (ended_) return;
  begin_step(here, address);
  if (ledger_.total().instructions >= options_.limit) {
    return fail("has not stopped after " + std::to_string(options_.limit) + " instructions");
  }
  if (here.special) look_at(here.insn);
}

// What more there is to an instruction than its time.
void Machine::look_at(const Instruction& insn) {
  if (!insn.supported) return fail(std::string("executes an instruction that a ") + name(board_.core) + " lacks");
  if (CycleModel::asks_for_operands(board_.core, insn.kind) && model_) {
    how_.a = core_.reg(insn.a);
    how_.b = core_.reg(insn.b);
  }
  if (insn.kind == Kind::if_then) {
    block_end_ = current_address_ + insn.size;
    for (unsigned i = 0; i < insn.block; ++i) block_end_ += decoded(block_end_).insn.size;
  }
  if (insn.kind == Kind::branch) end("spins at " + place(current_address_));
  if (insn.waits) end("waits for an interrupt at " + place(current_address_));
}

void Machine::on_access(bool write, std::uint32_t address, std::uint32_t size) {
  if (turns_.replaying()) {
    const WaitTurns::Step& step = turns_.current();
    if (!write && !turns_.has_read() && address == step.datum && size == step.datum_bytes) return turns_.read();
    leave_replay();
  }
  if (current_ == nullptr) return;
  if (write) {
    turns_.cancel();
    waits_.stored();
    ledger_.forget_recent();
    pools_.written(address);
    touch(address, size);
  } else {
    note_read(address, size);
  }
  const bool aligned_only = board_.core == Core::m0 || board_.core == Core::m0plus || !current_->insn.is_single();
  const std::uint32_t unit = size > 4 ? 4 : size;
  if (aligned_only && current_->insn.touches_memory() && address % unit != 0) {
    fail("touches " + std::to_string(size) + " bytes at the unaligned address " + hex(address));
  }
}

void Machine::touch(std::uint32_t address, std::uint32_t size) {
  if (how_.data_size != 0) return;
  how_.data_address = address;
  how_.data_size = static_cast<std::uint8_t>(size);
}

void Machine::note_read(std::uint32_t address, std::uint32_t size) {
  stall_ += timing_.read(address);
  touch(address, size);
  if (turns_.recording()) turns_.record_datum(address, size);
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
  leave_replay();
  turns_.cancel();
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
  ledger_.settle();
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

RunReport run_image(const Image& image, const BoardDescription& board, const RunOptions& options) {
  Machine machine(image, board, options);
  return machine.run();
}

}  // namespace spanline::host
