#include "mcu/call_tree.hpp"

#include <algorithm>

namespace spanline::host {

std::uint32_t CallTree::find(std::uint32_t place, const Places& places) {
  const auto [known, is_new] = known_.try_emplace(std::uint64_t{base_} << 32 | place, 0);
  if (!is_new) return known->second;
  std::uint32_t node = base_;
  for (const std::uint32_t frame : places.frames(place)) {
    const auto next = static_cast<std::uint32_t>(nodes_.size());
    const auto [child, is_first] = nodes_[node].children.try_emplace(frame, next);
    const std::uint32_t index = child->second;
    if (is_first) {
      const Stage stage = places.stage(frame).value_or(nodes_[node].stage);
      nodes_.push_back({node, frame, stage, frame != places.frames(place).front(), {}, {}});
    }
    node = index;
  }
  return known->second = node;
}

std::vector<std::uint32_t> CallTree::callers_of(std::uint32_t node) const {
  std::vector<std::uint32_t> frames;
  for (; node != 0; node = nodes_[node].parent) {
    if (!nodes_[node].inlined) frames.push_back(nodes_[node].frame);
  }
  std::reverse(frames.begin(), frames.end());
  return frames;
}

void CallTree::call(std::uint32_t return_to) {
  callers_.push_back({return_to, base_});
  base_ = node_;
  place_ = kNoPlace;
}

void CallTree::return_through(std::size_t depth) {
  base_ = callers_[depth].base;
  callers_.resize(depth);
  place_ = kNoPlace;
}

// Whoever calls comes back in order, but a tail call may skip frames.
void CallTree::jump(std::uint32_t to) {
  for (std::size_t depth = callers_.size(); depth-- > 0;) {
    if (callers_[depth].return_to == kException) return;
    if (callers_[depth].return_to == to) return return_through(depth);
  }
}

void CallTree::interrupt() {
  callers_.push_back({kException, base_});
  base_ = 0;
  place_ = kNoPlace;
}

void CallTree::resume() {
  for (std::size_t depth = callers_.size(); depth-- > 0;) {
    if (callers_[depth].return_to == kException) return return_through(depth);
  }
}

void CallTree::clear_counts() {
  for (Node& node : nodes_) node.self = {};
}

}  // namespace spanline::host
