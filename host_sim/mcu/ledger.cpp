#include "mcu/ledger.hpp"

#include <algorithm>

namespace spanline::host {

void Ledger::close_run() {
  functions_[run_.function] += run_.count;
  stages_[static_cast<std::size_t>(run_.stage)] += run_.count;
  calls_.charge(run_.node, run_.count);
  if (watching_) recent_.push_back(run_);
  run_.when = total_.time();
  run_.count = {};
  if (!watching_ || total_.instructions - watched_from_ < kLongestLoop) return;
  watching_ = false;
  recent_.clear();
}

StageCounts Ledger::stages() const {
  StageCounts stages = stages_;
  stages[static_cast<std::size_t>(run_.stage)] += run_.count;
  return stages;
}

void Ledger::charge_waiting(std::uint64_t begin) {
  close_run();
  for (const Run& run : recent_) {
    if (run.when < begin) continue;
    const Count waited{0, 0, 0, run.count.time()};
    total_ += waited;
    functions_[run.function] += waited;
    stages_[static_cast<std::size_t>(run.stage)] += waited;
    calls_.charge(run.node, waited);
  }
  recent_.clear();
  watched_from_ = total_.instructions;
}

void Ledger::pass_turns(const Count& turn, std::uint64_t turns) {
  close_run();
  const Count all{turn.instructions * turns, turn.cycles * turns, turn.stalls * turns, turn.waiting * turns};
  total_ += all;
  // What has been watched of the turn under way moves along.
  run_.when += all.time();
  watched_from_ += all.instructions;
  for (Run& run : recent_) run.when += all.time();
}

void Ledger::charge_turns(std::uint32_t function, std::uint32_t node, Stage stage, const Count& turns) {
  functions_[function] += turns;
  stages_[static_cast<std::size_t>(stage)] += turns;
  calls_.charge(node, turns);
}

void Ledger::end() {
  close_run();
  passages_.push_back(total_ - begin_);
  counted_.resize(functions_.size());
  for (std::size_t i = 0; i < functions_.size(); ++i) counted_[i] += functions_[i] - at_begin_[i];
}

WaitFinder::Wait WaitFinder::go_on(std::uint64_t since, std::uint64_t passed) {
  for (Question& question : questions_) {
    if (question.when >= since) question.when += passed;
  }
  const Wait wait{counted_until_, counted_until_ + passed};
  counted_until_ += passed;
  return wait;
}

// A loop asks few questions, over and over: they are kept at the front.
std::optional<WaitFinder::Wait> WaitFinder::asked(std::uint32_t instruction, std::uint64_t now) {
  const auto known = std::find_if(questions_.begin(), questions_.end(),
                                  [&](const Question& question) { return question.instruction == instruction; });
  if (known == questions_.end()) {
    questions_.push_back({instruction, stores_, now});
    return std::nullopt;
  }
  const Question before = *known;
  *known = {instruction, stores_, now};
  if (before.stores != stores_) return std::nullopt;
  if (known != questions_.begin()) std::iter_swap(known, known - 1);
  const std::uint64_t begin = std::max(before.when, counted_until_);
  counted_until_ = now;
  return Wait{begin, now};
}

}  // namespace spanline::host
