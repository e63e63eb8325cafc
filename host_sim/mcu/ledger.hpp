// Keeps account of a run: by function, by call, by frame, between two symbols.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mcu/call_tree.hpp"
#include "mcu/count.hpp"
#include "mcu/decoded_code.hpp"

namespace spanline::host {

class Ledger {
 public:
  // `functions`: how many there are, besides the one for what belongs to none.
  explicit Ledger(std::size_t functions) : functions_(functions + 1), at_begin_(functions + 1) {}

  void charge(const DecodedCode::Entry& entry, const Count& count) {
    if (watching_) watch(entry, count);
    total_ += count;
    functions_[entry.function] += count;
    stages_[static_cast<std::size_t>(calls_.stage())] += count;
    calls_.charge(count);
  }

  // A register is asked: with this instruction a turn of a loop that waits may begin.
  void asked() { watching_ = true; }
  // No such turn has begun before this.
  void forget_recent() {
    watching_ = false;
    recent_.clear();
  }
  // What was charged since `begin` was a turn of a loop that waits.
  void charge_waiting(std::uint64_t begin);

  const Count& total() const { return total_; }
  const StageCounts& stages() const { return stages_; }
  CallTree& calls() { return calls_; }

  // What is counted from here to the next end() is a passage.
  void begin() {
    begin_ = total_;
    at_begin_ = functions_;
    if (passages_.empty()) calls_.clear_counts();
  }
  void end();

  const std::vector<Count>& passages() const { return passages_; }
  const std::vector<Count>& functions() const { return counted_; }
  // Of the whole run, counted or not.
  const std::vector<Count>& all_functions() const { return functions_; }

 private:
  struct Charge {
    std::uint64_t when, time;
    std::uint32_t function, node;
    Stage stage;
  };
  static constexpr std::size_t kLongestLoop = 1024;  // instructions of a turn

  void watch(const DecodedCode::Entry& entry, const Count& count) {
    recent_.push_back({total_.time(), count.time(), entry.function, calls_.node(), calls_.stage()});
    if (recent_.size() == kLongestLoop) forget_recent();
  }

  bool watching_ = false;
  std::vector<Charge> recent_;
  Count total_, begin_;
  StageCounts stages_{};
  std::vector<Count> functions_, at_begin_, counted_;
  std::vector<Count> passages_;
  CallTree calls_;
};

// Finds the loops that wait: the same instruction reads a register again, and nothing was stored in between.
class WaitFinder {
 public:
  struct Wait {
    std::uint64_t begin, end;
  };

  void stored() { ++stores_; }
  std::optional<Wait> asked(std::uint32_t instruction, std::uint64_t now);

 private:
  struct Question {
    std::uint32_t instruction;
    std::uint64_t stores, when;
  };
  std::vector<Question> questions_;
  std::uint64_t stores_ = 0, counted_until_ = 0;
};

}  // namespace spanline::host
