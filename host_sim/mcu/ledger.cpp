#include "mcu/ledger.hpp"

#include <algorithm>

namespace spanline::host {

void Ledger::charge_waiting(std::uint64_t begin) {
  for (const Charge& charge : recent_) {
    if (charge.when < begin) continue;
    const Count waited{0, 0, 0, charge.time};
    total_ += waited;
    functions_[charge.function] += waited;
    stages_[static_cast<std::size_t>(charge.stage)] += waited;
    calls_.charge_at(charge.node, waited);
  }
  recent_.clear();
}

void Ledger::end() {
  passages_.push_back(total_ - begin_);
  counted_.resize(functions_.size());
  for (std::size_t i = 0; i < functions_.size(); ++i) counted_[i] += functions_[i] - at_begin_[i];
}

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
  const std::uint64_t begin = std::max(before.when, counted_until_);
  counted_until_ = now;
  return Wait{begin, now};
}

}  // namespace spanline::host
