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
    total_ += count;
    functions_[entry.function] += count;
    stages_[static_cast<std::size_t>(calls_.stage())] += count;
    calls_.charge(count);
  }
  // So many of the cycles charged last were spent in a loop that waits, in the function of `entry`.
  void charge_waiting(const DecodedCode::Entry& entry, std::uint64_t cycles) { charge(entry, {0, 0, 0, cycles}); }

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

 private:
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
