// The X-sort list (III.F): segments in order of their left edge. While one line's list is taken from the front, the
// next line's is put together at the back, almost always by appending; what enters on a line waits in a short list of
// its own and is merged on the way.
#pragma once

#include <utility>

#include "core/vsg/blocks.hpp"
#include "core/vsg/statistics.hpp"

namespace spanline {

// A singly walked, sorted chain of blocks whose front block is held in a register once looked at.
template <bool kCount>
class FrontRegister {
 public:
  void set(std::uint16_t front) {
    front_ = front;
    loaded_ = false;
  }
  std::uint16_t front() const { return front_; }
  bool peek(SegmentStore<kCount>& store, std::int32_t& key) {
    if (front_ == 0) return false;
    if (!loaded_) {
      store.fetch(front_);
      loaded_ = true;
    }
    key = store.held(front_).left();
    return true;
  }
  std::uint16_t pop(SegmentStore<kCount>& store) {
    const std::uint16_t index = front_;
    set(store.held(index).next);
    return index;
  }

 private:
  std::uint16_t front_ = 0;
  bool loaded_ = false;
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

  // The left column of the next block in order; false at the end.
  bool peek(std::int32_t& key) {
    const bool any = current_.peek(*store_, key);
    std::int32_t entering = 0;
    take_entering_ =
        entering_.peek(*store_, entering) && (!any || entering < key || (entering == key && enters_first()));
    if (take_entering_) key = entering;
    return any || take_entering_;
  }
  // Takes what peek() saw; the fetch is counted there.
  std::uint16_t pop() { return take_entering_ ? entering_.pop(*store_) : current_.pop(*store_); }

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
  bool take_entering_ = false;
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
  bool peek(std::int32_t& key) {
    while (at_ < kColumns && buckets_->front[now_][at_] == 0) ++at_;
    key = at_;
    return at_ < kColumns;
  }
  std::uint16_t pop() {
    const std::uint16_t index = buckets_->front[now_][at_];
    buckets_->front[now_][at_] = store_->fetch(index).next;
    return index;
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
