// Who called whom, and what each took by itself: the data of a flame graph.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mcu/count.hpp"
#include "mcu/places.hpp"
#include "mcu/stage.hpp"

namespace spanline::host {

class CallTree {
 public:
  struct Node {
    std::uint32_t parent;
    std::uint32_t frame;  // of Places; the root's is kRoot
    Stage stage;          // of its file, or its caller's
    bool inlined;
    Count self;
    std::map<std::uint32_t, std::uint32_t> children;  // by frame
  };
  static constexpr std::uint32_t kRoot = UINT32_MAX;

  CallTree() : nodes_{{0, kRoot, Stage::other, false, {}, {}}}, recent_(kRecent) {}

  // The next instruction belongs to this place.
  void at(std::uint32_t place, const Places& places) {
    if (place == place_) return;
    place_ = place;
    Recent& recent = recent_[(place ^ base_ << 4) % kRecent];
    if (recent.base != base_ || recent.place != place) recent = {base_, place, find(place, places)};
    node_ = recent.node;
  }
  Stage stage() const { return nodes_[node_].stage; }
  std::uint32_t node() const { return node_; }

  // The functions that were on their way at `node`, outermost first, what is inlined left out; by frame.
  std::vector<std::uint32_t> callers_of(std::uint32_t node) const;
  void charge(std::uint32_t node, const Count& count) { nodes_[node].self += count; }

  // A call that will come back to `return_to`; a jump somewhere, perhaps back.
  void call(std::uint32_t return_to);
  void jump(std::uint32_t to);

  // An exception interrupts, or ends.
  void interrupt();
  void resume();

  const std::vector<Node>& nodes() const { return nodes_; }
  void clear_counts();

 private:
  static constexpr std::uint32_t kNoPlace = UINT32_MAX, kException = 1;  // odd: no address of code
  struct Caller {
    std::uint32_t return_to, base;
  };
  std::uint32_t find(std::uint32_t place, const Places& places);
  void return_through(std::size_t depth);

  std::vector<Node> nodes_;
  std::vector<Caller> callers_;
  std::uint32_t base_ = 0, node_ = 0, place_ = kNoPlace;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;  // base and place
  // Some of these, by their last bits: inlined code changes its place every few instructions.
  struct Recent {
    std::uint32_t base = 0, place = kNoPlace, node = 0;
  };
  static constexpr std::uint32_t kRecent = 1024;
  std::vector<Recent> recent_;
};

}  // namespace spanline::host
