// The turns of a loop that waits, as a delay does. Where two turns in a row went the same way, read the same addresses
// and took as long, and nothing was stored, the core model and the caches are as they were a turn before: so the next
// turn costs the same as long as it goes that way, whatever it reads there. It is enough, then, to see where it goes.
// Whole turns are charged at once; of the last one, which ends otherwise, each step is accounted as if for the first
// time.
#pragma once

#include <cstdint>
#include <vector>

#include "mcu/ledger.hpp"

namespace spanline::host {

class WaitTurns {
 public:
  static constexpr std::uint32_t kNothing = UINT32_MAX;

  struct Step {
    const DecodedCode::Entry* entry = nullptr;
    std::uint32_t address = 0;
    std::uint32_t datum = kNothing;  // the address it reads
    std::uint32_t datum_bytes = 0;
    bool asks = false;  // and that is a register
    std::uint32_t node = 0;
    Stage stage = Stage::other;
    Count before;  // of the turn, when it begins

    bool is_like(const Step& other) const {
      return address == other.address && datum == other.datum && datum_bytes == other.datum_bytes &&
             node == other.node && before.instructions == other.before.instructions &&
             before.cycles == other.before.cycles && before.stalls == other.before.stalls;
    }
  };

  // A loop has asked at `head` twice. Its turns are told apart from there on.
  void arm(std::uint32_t head) {
    if (state_ != State::idle) return;
    state_ = State::armed;
    head_ = head;
  }
  // What goes on is no turn of such a loop.
  void cancel() {
    state_ = State::idle;
    head_ = kNothing;
  }

  bool idle() const { return state_ == State::idle; }
  bool recording() const { return state_ == State::recording; }
  bool replaying() const { return state_ == State::replaying; }
  std::uint32_t head() const { return head_; }

  // The loop is at its head, `total` is charged so far. True where the next turn may be replayed.
  bool begin_turn(const Count& total);
  // An instruction begins; what it reads; and that this is a register.
  void record(Step step, const Count& total);
  void record_datum(std::uint32_t address, std::uint32_t bytes);
  void record_question() {
    if (recording() && !steps_.empty()) steps_.back().asks = true;
  }

  // While turns are replayed: the step to come, when, and after how many instructions; the one on its way, and when it
  // began.
  const Step& next() const { return last_[is_over() ? 0 : at_]; }
  std::uint64_t next_time() const { return base_.time() + (is_over() ? turn_.time() : 0) + next().before.time(); }
  std::uint64_t next_instructions() const {
    return base_.instructions + (is_over() ? turn_.instructions : 0) + next().before.instructions;
  }
  const Step& current() const { return last_[at_ - 1]; }
  std::uint64_t current_time() const { return base_.time() + current().before.time(); }
  // The step that was to come begins.
  void step() {
    if (is_over()) {
      at_ = 0;
      ++turns_;
      base_ += turn_;
    }
    ++at_;
    has_read_ = false;
  }
  // Whether the step on its way has read what it reads.
  bool has_read() const { return at_ == 0 || has_read_ || current().datum == kNothing; }
  void read() { has_read_ = true; }

  // What there is to account when replaying ends: whole turns, then the first begun() of steps().
  std::uint64_t turns() const { return turns_; }
  const Count& turn() const { return turn_; }
  std::size_t begun() const { return at_; }
  const std::vector<Step>& steps() const { return last_; }
  Count cost(std::size_t step) const;  // of one of them
  // It has ended; steps that have begun are to be recorded anew.
  void leave() { state_ = State::recording; }

 private:
  enum class State : std::uint8_t { idle, armed, recording, replaying };
  static constexpr std::size_t kLongest = 256;  // steps

  bool is_over() const { return at_ == last_.size(); }
  bool is_like_the_last(const Count& turn) const;

  State state_ = State::idle;
  std::uint32_t head_ = kNothing;
  Count base_;  // when the turn began
  std::vector<Step> steps_, last_;
  Count turn_;  // the last one's
  std::size_t at_ = 0;
  std::uint64_t turns_ = 0;
  bool has_read_ = false;
};

}  // namespace spanline::host
