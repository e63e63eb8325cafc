// The X-sort list (III.F): segments in order of their left edge. While one line's list is taken from the front, the
// next line's is put together at the back, almost always by appending; what enters on a line waits in a short list of
// its own and is merged on the way.
#pragma once

#include <utility>

#include "core/vsg/blocks.hpp"
#include "core/vsg/statistics.hpp"

namespace spanline {

inline constexpr std::int32_t kNoKey = INT32_MAX;  // of an empty list: no segment begins there

// A singly walked, sorted chain of blocks whose front block is held in a register.
template <bool kCount>
class FrontRegister {
 public:
  // Walking begins with load(); until then the chain may change.
  void set(std::uint16_t front) { front_ = front; }
  void load(SegmentStore<kCount>& store) { key_ = front_ == 0 ? kNoKey : store.fetch(front_).left(); }
  std::uint16_t front() const { return front_; }
  std::int32_t key() const { return key_; }
  // Takes the front block. The next one is not loaded yet.
  std::uint16_t pop(SegmentStore<kCount>& store) {
    const std::uint16_t index = front_;
    front_ = store.held(index).next;
    return index;
  }

 private:
  std::uint16_t front_ = 0;
  std::int32_t key_ = kNoKey;
};

// VSG6: a doubly linked list.
template <bool kCount>
class XSortList {
 public:
  XSortList() = default;
  explicit XSortList(SegmentStore<kCount>* store) : store_(store) {}

  void clear() {
    current_.set(0);
    entering_.set(0);
    begin_next();
  }

  // The list that was put together becomes the one that is taken from.
  void begin_line() {
    if (kept_back_ != 0) insert_after(next_last_, kept_back_);
    current_.set(next_front_);
    entering_.set(0);
    begin_next();
  }

  // Files a block that enters on this line, or whose left edge was replaced.
  void enter(std::uint16_t index) {
    SegmentBlock& block = store_->held(index);
    std::uint16_t before = 0, at = entering_.front();
    while (at != 0 && comes_before(store_->fetch(at).half[0], block.half[0])) {
      before = at;
      at = store_->held(at).next;
    }
    block.next = at;
    block.flags = SegmentBlock::kEntering;
    if (before == 0) {
      entering_.set(index);
    } else {
      store_->held(before).next = index;
      store_->store(before);
    }
  }

  // Takes a block out before the line is begun to be taken from. The block itself is in the caller's hands.
  void remove(std::uint16_t index) {
    SegmentBlock& block = store_->held(index);
    if ((block.flags & SegmentBlock::kListed) != 0) unlink(index);
    if ((block.flags & SegmentBlock::kEntering) != 0) unlink_entering(index);
    block.flags &= SegmentBlock::kMoved;
  }

  // Before the line is taken from.
  void start() {
    current_.load(*store_);
    entering_.load(*store_);
  }
  // The left column of the next block in order; kNoKey at the end.
  std::int32_t key() const { return current_.key() < entering_.key() ? current_.key() : entering_.key(); }
  // Takes that block.
  std::uint16_t pop() {
    popped_entering_ = entering_.key() < current_.key() || (entering_.key() == current_.key() && enters_first());
    return popped_entering_ ? entering_.pop(*store_) : current_.pop(*store_);
  }
  // Loads what follows the block that was taken, when that block has been dealt with.
  void next() { (popped_entering_ ? entering_ : current_).load(*store_); }

  // Files a block, stepped to the next line, into that line's list. Returns true where it went to the end.
  //
  // The block furthest right so far is kept back in a register, so that those it has overtaken still go to the end of
  // the list, before it; and the last block of the list is in a register too, so that its forward link costs no
  // reference (the listing counts likewise).
  bool append(std::uint16_t index) {
    SegmentBlock& block = store_->held(index);
    block.flags = SegmentBlock::kListed;
    if (kept_back_ == 0 || store_->held(kept_back_).left() <= block.left()) std::swap(index, kept_back_);
    if (index == 0) return true;
    const std::int32_t key = store_->held(index).left();
    const bool at_end = next_last_ == 0 || store_->held(next_last_).left() <= key;
    insert_after(at_end ? next_last_ : search_back(key), index);
    return at_end;
  }

 private:
  void begin_next() { next_front_ = next_last_ = kept_back_ = 0; }

  // Edges from one vertex part on the next line: the order of their slopes saves a search back there.
  bool enters_first() const {
    return comes_before(store_->held(entering_.front()).half[0], store_->held(current_.front()).half[0]);
  }

  std::uint16_t search_back(std::int32_t key) {
    std::uint16_t at = next_last_;
    do {
      at = store_->held(at).previous;
    } while (at != 0 && store_->fetch(at).left() > key);
    return at;
  }

  void insert_after(std::uint16_t before, std::uint16_t index) {
    SegmentBlock& block = store_->held(index);
    block.previous = before;
    const std::uint16_t after = before == 0 ? next_front_ : store_->held(before).next;
    block.next = after;
    if (before == 0) {
      next_front_ = index;
    } else {
      store_->held(before).next = index;
    }
    if (after == 0) {
      next_last_ = index;
    } else {
      store_->held(after).previous = index;
      if (after != next_last_) store_->store(after);
      if (before != 0) store_->store(before);
    }
  }

  void unlink(std::uint16_t index) {
    const SegmentBlock& block = store_->held(index);
    if (block.previous == 0) {
      current_.set(block.next);
    } else {
      store_->held(block.previous).next = block.next;
      store_->store(block.previous);
    }
    if (block.next != 0) {
      store_->held(block.next).previous = block.previous;
      store_->store(block.next);
    }
  }

  void unlink_entering(std::uint16_t index) {
    const std::uint16_t after = store_->held(index).next;
    if (entering_.front() == index) return entering_.set(after);
    std::uint16_t at = entering_.front();
    while (store_->fetch(at).next != index) at = store_->held(at).next;
    store_->held(at).next = after;
    store_->store(at);
  }

  SegmentStore<kCount>* store_ = nullptr;
  FrontRegister<kCount> current_, entering_;
  std::uint16_t next_front_ = 0, next_last_ = 0, kept_back_ = 0;
  bool popped_entering_ = false;
};

// VSG5: a bucket for every column, this line's and the next line's (Romney). Kept for the measured comparison; the
// accesses to the buckets themselves are not counted, as in the seed. Columns off the screen share the end buckets.
template <bool kCount>
class XSortBuckets {
 public:
  static constexpr std::int32_t kColumns = 2048;
  struct Buckets {
    std::uint16_t front[2][kColumns];
  };

  XSortBuckets() = default;
  explicit XSortBuckets(SegmentStore<kCount>* store) : store_(store) {}
  void use(Buckets* buckets) { buckets_ = buckets; }

  void clear() {
    for (auto& line : buckets_->front) {
      for (std::uint16_t& f : line) f = 0;
    }
  }
  void begin_line() {
    now_ ^= 1;
    for (std::uint16_t& f : buckets_->front[now_ ^ 1]) f = 0;
    at_ = 0;
  }
  void enter(std::uint16_t index) { push(buckets_->front[now_], index); }
  void remove(std::uint16_t index) {
    SegmentBlock& block = store_->held(index);
    if ((block.flags & SegmentBlock::kListed) == 0) return;
    for (std::uint16_t& front : buckets_->front[now_]) {
      for (std::uint16_t* link = &front; *link != 0; link = &store_->held(*link).next) {
        if (*link != index) continue;
        *link = block.next;
        block.flags &= SegmentBlock::kMoved;
        store_->store(index);
        return;
      }
    }
  }
  void start() { next(); }
  std::int32_t key() const { return at_ < kColumns ? at_ : kNoKey; }
  std::uint16_t pop() {
    const std::uint16_t index = buckets_->front[now_][at_];
    buckets_->front[now_][at_] = store_->fetch(index).next;
    return index;
  }
  void next() {
    while (at_ < kColumns && buckets_->front[now_][at_] == 0) ++at_;
  }
  bool append(std::uint16_t index) {
    push(buckets_->front[now_ ^ 1], index);
    return true;
  }

 private:
  void push(std::uint16_t (&front)[kColumns], std::uint16_t index) {
    SegmentBlock& block = store_->held(index);
    const std::int32_t key = block.left() < 0 ? 0 : block.left() >= kColumns ? kColumns - 1 : block.left();
    block.next = front[key];
    block.flags = SegmentBlock::kListed;
    front[key] = index;
  }

  SegmentStore<kCount>* store_ = nullptr;
  Buckets* buckets_ = nullptr;
  std::int32_t at_ = 0;
  unsigned now_ = 0;
};

}  // namespace spanline
