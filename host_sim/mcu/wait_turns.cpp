#include "mcu/wait_turns.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

bool same_cost(const Count& a, const Count& b) {
  return a.instructions == b.instructions && a.cycles == b.cycles && a.stalls == b.stalls;
}

}  // namespace

// All of a turn that is replayed is waiting.
bool WaitTurns::is_like_the_last(const Count& turn) const {
  return turn.waiting == turn.time() && same_cost(turn, turn_) &&
         std::equal(steps_.begin(), steps_.end(), last_.begin(), last_.end(),
                    [](const Step& a, const Step& b) { return a.is_like(b); });
}

bool WaitTurns::begin_turn(const Count& total) {
  if (state_ == State::armed) {
    state_ = State::recording;
    last_.clear();
  } else {
    const Count turn = total - base_;
    if (is_like_the_last(turn)) state_ = State::replaying;
    turn_ = turn;
    std::swap(last_, steps_);
  }
  steps_.clear();
  base_ = total;
  at_ = 0;
  turns_ = 0;
  return replaying();
}

void WaitTurns::record(Step step, const Count& total) {
  if (steps_.size() == kLongest) return cancel();
  step.before = total - base_;
  steps_.push_back(step);
}

void WaitTurns::record_datum(std::uint32_t address, std::uint32_t bytes) {
  if (steps_.empty()) return;
  if (steps_.back().datum != kNothing) return cancel();  // of several data the order would have to be the same
  steps_.back().datum = address;
  steps_.back().datum_bytes = bytes;
}

// Up to the next one's beginning; the first one's is in the next turn.
Count WaitTurns::cost(std::size_t step) const {
  const Count end = step + 1 < last_.size() ? last_[step + 1].before : [&] {
    Count after = turn_;
    after += last_.front().before;
    return after;
  }();
  return end - last_[step].before;
}

}  // namespace spanline::host
