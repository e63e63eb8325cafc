// The machine that runs an image: core, chip and clock in one time. machine.hpp is how others ask for a run.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "mcu/chip.hpp"
#include "mcu/core_hooks.hpp"
#include "mcu/core_state.hpp"
#include "mcu/cycle_model.hpp"
#include "mcu/decoded_code.hpp"
#include "mcu/ledger.hpp"
#include "mcu/machine.hpp"
#include "mcu/marks.hpp"
#include "mcu/memory_map.hpp"
#include "mcu/pool_watch.hpp"
#include "mcu/stack_watch.hpp"
#include "mcu/system_registers.hpp"
#include "mcu/wait_turns.hpp"

namespace spanline::host {

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
  void begin_step(const DecodedCode::Entry& here, std::uint32_t address);
  void touch(std::uint32_t address, std::uint32_t size);
  void note_read(std::uint32_t address, std::uint32_t size);
  void note_question();
  bool replays(std::uint32_t address);
  void leave_replay();
  void look_at(const Instruction& insn);
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
    if (turns_.replaying()) return turns_.current_time();
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
  WaitTurns turns_;
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

}  // namespace spanline::host
