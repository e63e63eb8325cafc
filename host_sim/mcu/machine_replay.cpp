// An instruction begins; or the turn of a loop that waits is seen to go as those before.
#include "mcu/emulated_machine.hpp"

namespace spanline::host {

// The instruction before is settled.
void Machine::begin_step(const DecodedCode::Entry& here, std::uint32_t address) {
  current_address_ = address;
  ledger_.calls().at(here.place, code_.places());
  current_ = &here;
  sp_changed_ = here.insn.writes_sp();
  how_ = Execution{};
  stall_ = timing_.fetch(address, now());
  if (!turns_.recording()) return;
  const bool plain = !here.special || here.insn.kind == Kind::if_then;
  if (!plain || here.marked || address == line_made_ || sp_changed_ || !here.insn.known) return turns_.cancel();
  turns_.record({&here, address, WaitTurns::kNothing, 0, false, ledger_.calls().node(), ledger_.calls().stage(), {}},
                ledger_.total());
}

// Whether the instruction at `address` is the next step of a turn whose cost is known, before anything else happens.
bool Machine::replays(std::uint32_t address) {
  if (address == turns_.head() && !turns_.replaying()) turns_.begin_turn(ledger_.total());
  if (!turns_.replaying()) return false;
  const bool goes_on = address == turns_.next().address && turns_.has_read() && turns_.next_time() < next_event_ &&
                       turns_.next_instructions() < options_.limit;
  if (goes_on) {
    turns_.step();
  } else {
    leave_replay();
  }
  return goes_on;
}

// Accounts what has been replayed, and all is as if each instruction had been.
void Machine::leave_replay() {
  if (!turns_.replaying()) return;
  const std::uint64_t count = turns_.turns(), begin = ledger_.total().time(), turn = turns_.turn().time();
  if (count != 0) {
    ledger_.pass_turns(turns_.turn(), count);
    timing_.pass(turn * count);
    const WaitFinder::Wait wait = waits_.go_on(begin - turn, turn * count);
    if (frames_) frames_->waited(wait.begin, wait.end);
  }
  const std::vector<WaitTurns::Step> steps = turns_.steps();
  for (std::size_t i = 0; count != 0 && i < steps.size(); ++i) {
    const Count once = turns_.cost(i);
    ledger_.charge_turns(steps[i].entry->function, steps[i].node, steps[i].stage,
                         {once.instructions * count, once.cycles * count, once.stalls * count, once.time() * count});
  }
  const std::size_t begun = turns_.begun();
  const bool has_read = turns_.has_read();
  turns_.leave();
  for (std::size_t i = 0; i < begun; ++i) {
    const WaitTurns::Step& step = steps[i];
    settle(step.address, step.entry->insn.size);
    begin_step(*step.entry, step.address);
    if (step.entry->special) look_at(step.entry->insn);
    if (step.datum == WaitTurns::kNothing || (i + 1 == begun && !has_read)) continue;
    note_read(step.datum, step.datum_bytes);
    if (step.asks) note_question();
  }
}

}  // namespace spanline::host
